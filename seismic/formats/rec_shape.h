// `.rec`: a line of titles in GBK, a line of their values, then "time TAB value"; values divided by their
// peak by whoever made the file.
//
//   <magnitude> <year> <name> <station> <component>      GBK bytes, separated by tabs
//   8.0  2010  Wenchuan  051SFB ua0283                   3 to 5 fields
//   0.00E+00  1.03E-02
//
// So the record is dimensionless: a shape, to be scaled to a chosen PGA. Its peak of 1 is not 1 g. The time
// column may hold three digits only, and then repeats: the step is that of the first two lines, and later
// times are only checked against it within their digits.
#pragma once

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_rec_shape(const FileText& text);
Record read_rec_shape(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
