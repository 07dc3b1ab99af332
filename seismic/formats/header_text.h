// What readers look for in the text above the numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "seismic/formats/file_text.h"
#include "seismic/record.h"

namespace dougong::seismic {

/// Case is ignored throughout.
bool contains(std::string_view line, std::string_view words);

/// Index of the first line in [first, last) that contains the words.
std::optional<std::size_t> find_line(const FileText& text, std::string_view words, std::size_t first,
                                     std::size_t last);

/// What stands behind the words on a line, without blanks around it; empty when they are not on it.
std::string_view behind(std::string_view line, std::string_view words);
/// The same on the first line in [first, last) that contains them, printable.
std::string value_behind(const FileText& text, std::string_view words, std::size_t first, std::size_t last);
/// The number that begins there, passing over "=" and ":".
std::optional<double> number_behind(std::string_view line, std::string_view words);

/// The line, or nothing when the file is shorter.
std::string_view line_at(const FileText& text, std::size_t index);

/// The text as far as `mark`.
std::string_view before(std::string_view text, std::string_view mark);

/// "37.973N, 122.038W" or "34 17 11N, 118 13 31W": latitude and longitude.
std::optional<Place> place_in(std::string_view text);

/// Every line in [first, last) that is not blank becomes a fact of the header; a line that says SYNTHETIC
/// makes the record synthetic.
void keep_header(const FileText& text, std::size_t first, std::size_t last, Provenance& from);

}  // namespace dougong::seismic
