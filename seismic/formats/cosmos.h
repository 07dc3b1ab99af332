// COSMOS v1.20 (V0 counts, V1 uncorrected, V2 corrected), one or more channels a file:
//
//   13 text lines, the first with "(Format v01.20 with 13 text lines)"
//   100 Integer-header values follow on  10 lines, Format = (10I8)
//   100 Real-header values follow on  20 lines, Format = (5F15.6)
//     2 Comment line(s) follow, each starting with a "|"
//   42000 acceleration pts, approx  210 secs, units=cm/sec2(04),Format=(1E15.6)
//   End-of-data for ...
//
// Stated counts and formats are obeyed: 10I8, 8F9.6 and 1E15.6 occur. The unit is that of the code in
// brackets. The time step is real 62 (ms); real 34, the raw interval, may be another and is only compared.
// (COSMOS, "Strong motion data format", version 1.20, 2001, tables 1 to 3.)
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_cosmos(const FileText& text);
std::vector<Record> read_cosmos(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
