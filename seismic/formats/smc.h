// USGS SMC: 11 text lines, 48 integers (8I10), 50 reals (5E15.7), comments "|", then data in cm/s2.
//
//   line 1       type: 0 unknown, 1 uncorrected, 2 corrected acceleration; 3 velocity and beyond are refused
//   integer 1    the value that stands for "unknown" (-32768); 16: comment lines; 17: number of values
//   real 1       the same for reals (1.7E+38); real 2: samples per second
//
// Data stand eight a line, 10 wide ("1.5057E+0-2.2223E+0"), or as some programs write them one a line, 14
// wide: the first line decides. Type 1 may hold (time, value) pairs at uneven times; integer 17 counts both.
// (USGS National Strong-Motion Project, "SMC-format data files".)
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_smc(const FileText& text);
Record read_smc(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
