// GeoNet of New Zealand, V1A (uncorrected) and V2A (corrected): for each component 16 text lines, 40 integers
// (10I8 on 4 lines), 60 reals (10F8 on 6 lines) and data (10F8.1) in mm/s2; V2A has velocity and displacement
// behind the acceleration.
//
//   line 20, integer 1 or 4 (V1A, V2A)   values of acceleration; 5 and 6: of velocity and displacement
//   line 23, real 6                      time step (s)
//
// The header's peak times are not those of the samples (a pad of some seconds lies before them).
// (www.geonet.org.nz/data/supplementary/strong_motion_file_formats)
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_geonet(const FileText& text);
std::vector<Record> read_geonet(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
