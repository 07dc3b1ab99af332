// Rows of numbers, one column a channel.
#pragma once

#include <cstddef>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"

namespace dougong::seismic {

/// The columns of the rows from line `first` (an index) to the end of the file; blank lines are passed over.
/// A row of another width or a field that is no finite number becomes a problem.
std::vector<std::vector<double>> read_table_rows(const FileText& text, std::size_t first, std::size_t columns,
                                                 std::vector<InputProblem>& problems);

/// The columns of values that stand row after row.
std::vector<std::vector<double>> columns_of(const std::vector<double>& values, std::size_t columns);

}  // namespace dougong::seismic
