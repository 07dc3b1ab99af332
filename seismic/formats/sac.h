// SAC binary, headers 6 and 7, either byte order: 70 reals, 40 integers, 192 characters, then 32-bit reals.
// (SAC user's manual, "SAC data file format".)
//
//   integer 7   header version, 6 or 7: tells the byte order
//   real 1      time step (s)      real 6   first time, from the reference time of integers 1 to 6
//   integer 10  number of samples  integer 36  true for equal steps
//
// The unit is not in the file (integer 17 names a quantity, and is often left as it was): the caller states
// it.
#pragma once

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_sac(const FileText& text);
Record read_sac(const FileText& text, const ReadOptions& options);

}  // namespace dougong::seismic
