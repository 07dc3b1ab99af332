// DYNA 1.2 (ESM, ITACA, and AFAD of Turkey): lines "KEY: value" down to USER5, then one value a line.
//
//   SAMPLING_INTERVAL_S: 0.005000
//   NDATA: 19128
//   STREAM: HNE
//   UNITS: cm/s^2
//
// A value may hold colons: the first one parts it from its key. AFAD writes the PGA without its sign and
// leaves out what it does not know. Files of velocity or displacement have the same header and are refused.
#pragma once

#include <filesystem>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_dyna(const FileText& text);
Record read_dyna(const FileText& text, const ReadOptions& options);
/// "HI.ARS1..HNE.D....ASC" lies beside HNN and HNZ, AFAD's "..._E.asc" beside _N and _U.
std::vector<std::filesystem::path> dyna_siblings(const std::filesystem::path& path);

}  // namespace dougong::seismic
