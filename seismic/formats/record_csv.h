// The project's own CSV of a record: facts behind "#", the units declared in the titles, numbers that read
// back to the last bit.
//
//   # dougong record
//   # station: TKYH12
//   # interval (s): 0.01
//   time (s),EW2 (m/s2),NS2 (m/s2),UD2 (m/s2)
//   0,0.0012,-0.0003,0.0001
#pragma once

#include <span>
#include <string>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_record_csv(const FileText& text);
std::vector<Record> read_record_csv(const FileText& text, const ReadOptions& options);

/// Components of one station, of one step and length.
std::string write_record_csv(std::span<const Record> components);

}  // namespace dougong::seismic
