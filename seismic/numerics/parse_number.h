// Numbers from text, the same in every locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace dougong::seismic {

/// The whole text (blanks around it allowed) as a finite number.
std::optional<double> parse_number(std::string_view text);

/// The number that a text begins with ("100Hz", "7.0(Ms)"; blanks before it allowed).
std::optional<double> leading_number(std::string_view text);

struct NumberLine {
  std::vector<double> values;
  bool numeric = true;       // every field is spelled as a number (nan and inf are)
  std::string_view culprit;  // first field that is no finite number; empty when all are
};

/// The fields of a line: separated by blanks, tabs, commas or semicolons, or by nothing but the sign of
/// the next ("1.5057E+0-2.2223E+0"). Reads ".1297983E-02", "-.0", "40", "+1.2", "1.0D-3".
NumberLine parse_numbers(std::string_view line);

/// The same, appended to `values`, for bodies of many lines; returns the first culprit, empty when there is
/// none.
std::string_view append_numbers(std::string_view line, std::vector<double>& values);

}  // namespace dougong::seismic
