// Plain text or CSV: lines of header text, then numbers.
//
//   one column         values; the time step comes from the caller
//   two columns        time (s) and value
//   more, time first   time (s) and the components, named by the titles above them when there are as many
//   more, with a step  values row by row (K-NET counts are passed on as CSV, 8 a line)
//
// Units always come from the caller: a word in a header is shown in the error, not trusted. Counts need a
// scale as well, and their whole-record mean is taken off (the instrument's offset). Times that are not
// equally spaced are resampled (even_steps.h), but one odd step among equal ones is an error: a lost sample.
#pragma once

#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_columns(const FileText& text);
std::vector<Record> read_columns(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
