// CSMNC (China Strong Motion Networks Centre), uncorrected acceleration: 16 header lines, cm/s2, 8 a line.
//
//   UNCORRECTED ACCELERATION          UNIT: CM/SEC/SEC
//   NO. OF POINTS:  12000  EQUALLY SPACED INTERVALS OF:  0.005  SEC
//   PEAK VALUE:    -1005.350   AT   26.35 SEC    DURATION:  60 SEC
#pragma once

#include <string>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_csmnc(const FileText& text);
Record read_csmnc(const FileText& text, const ReadOptions& options);

/// The bytes of such a file, seven digits a value.
std::string write_csmnc(const Record& record);

}  // namespace dougong::seismic
