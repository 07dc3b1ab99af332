// Taiwan's Central Weather Administration (CWA, formerly CWB): lines "#Key: value", one of them empty, then
// time and three components in fields 10 wide. The offset is taken off already ("DCoffset(corr)").
//
//   #StationCode: ECU
//   #SampleRate(Hz): 50
//   #AmplitudeUnit:  gal. DCoffset(corr)
//   #DataSequence: Time U(+); N(+); E(+)
//   #Data: 4F10.3
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_cwa(const FileText& text);
std::vector<Record> read_cwa(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
