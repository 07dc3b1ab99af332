#include "seismic/numerics/parse_number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace dougong::seismic {
namespace {

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r';
}

std::size_t field_length(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && !is_separator(text[end])) ++end;
  return end;
}

// Reads one number at the start of text, from a copy with E in the place of Fortran's D (1.0D-3); returns the
// characters used, 0 when there is none.
std::size_t read_number(std::string_view text, double& value) {
  std::array<char, 64> field{};
  const std::size_t plus = !text.empty() && text[0] == '+' ? 1 : 0;
  const std::size_t length = std::min(field_length(text.substr(plus, field.size())), field.size());
  for (std::size_t i = 0; i < length; ++i) {
    const char c = text[plus + i];
    field[i] = c == 'D' || c == 'd' ? 'E' : c;
  }
  const auto result = std::from_chars(field.data(), field.data() + length, value);
  if (result.ec != std::errc{}) return 0;
  return plus + static_cast<std::size_t>(result.ptr - field.data());
}

// A number ends at a separator, at the line's end, or where the next one's sign begins.
bool ends_here(std::string_view rest) {
  return rest.empty() || is_separator(rest[0]) || rest[0] == '-' || rest[0] == '+';
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const NumberLine line = parse_numbers(text);
  if (line.values.size() != 1 || !line.culprit.empty()) return std::nullopt;
  return line.values[0];
}

NumberLine parse_numbers(std::string_view line) {
  NumberLine out;
  while (true) {
    while (!line.empty() && is_separator(line[0])) line.remove_prefix(1);
    if (line.empty()) return out;
    double value = 0.0;
    const std::size_t used = read_number(line, value);
    const bool numeric = used > 0 && ends_here(line.substr(used));
    if (out.culprit.empty() && (!numeric || !std::isfinite(value))) {
      out.culprit = line.substr(0, field_length(line));
    }
    out.numeric = out.numeric && numeric;
    if (numeric) out.values.push_back(value);
    line.remove_prefix(numeric ? used : field_length(line));
  }
}

}  // namespace dougong::seismic
