// K-NET and KiK-net as NIED offers them in CSV: facts on lines behind "#", then date, time from the first
// sample, and a column in gal for each component.
//
//   #K-NET CSV
//   #Station
//   #Code,Latitude,Longitude,Height(m)
//   #HKD004,45.2149,142.2260,4
//   #Time,RelativeTime(s),N-S(gal),E-W(gal),U-D(gal)
//   2026/01/13 01:58:43.00,0.00,-2.97,10.86,-0.20
//
// KiK-net numbers its six columns: 1 to 6 are NS1 EW1 UD1 NS2 EW2 UD2. Values still hold the offset that the
// header states: the whole-record mean is taken off on reading, as from the ASCII files (knet.h).
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_knet_csv(const FileText& text);
std::vector<Record> read_knet_csv(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
