// Blocks of numbers in fields of one width, as Fortran writes them: fields may touch ("30.000000-999.00000",
// "110015000"), so that blanks do not part them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"

namespace dougong::seismic {

struct FieldFormat {
  std::size_t per_line = 1;
  std::size_t width = 0;
  std::size_t indent = 0;  // columns before the first field
};

/// "(8F10.6)", "Format=(1E15.6)", "10I8", "(E15.6)": the first of its kind in the text. Nothing when there is
/// none, or when a width of 1 to 40 or a count of 1 to 100 does not come of it.
std::optional<FieldFormat> field_format_in(std::string_view text);

/// The format of a line whose fields are all of one width: its length shared by the numbers on it, with a
/// column for the printer's carriage control before them when it does not divide otherwise.
std::optional<FieldFormat> field_format_of_line(std::string_view line);

/// One field: a number with blanks around it. A number that fills its field counts as it is written.
std::optional<double> field_value(std::string_view field);

/// Reads `count` values from line `line` (an index) on and moves `line` past them. A missing, blank or bad
/// field becomes a problem and ends the block, and so does text behind the last field of a line, which would
/// mean that the fields are wider than stated.
std::vector<double> read_block(const FileText& text, std::size_t& line, std::size_t count,
                               const FieldFormat& format, std::vector<InputProblem>& problems);

/// Every row to the end of the file (or to the first blank line), each of format.per_line values; the same
/// problems.
std::vector<double> read_rows(const FileText& text, std::size_t line, const FieldFormat& format,
                              std::vector<InputProblem>& problems);

}  // namespace dougong::seismic
