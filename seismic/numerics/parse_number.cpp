#include "seismic/numerics/parse_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dougong::seismic {
namespace {

constexpr bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r';
}

std::size_t field_length(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && !is_separator(text[end])) ++end;
  return end;
}

// Fortran's double precision writes D for E: read from a copy. No such field is longer.
std::size_t read_fortran_double(std::string_view text, double& value) {
  std::array<char, 64> field{};
  const std::size_t length = std::min(field_length(text.substr(0, field.size())), field.size());
  std::replace_copy_if(
      text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length), field.begin(),
      [](char c) { return c == 'D' || c == 'd'; }, 'E');
  const auto [end, error] = std::from_chars(field.data(), field.data() + length, value);
  return error == std::errc{} ? static_cast<std::size_t>(end - field.data()) : 0;
}

// Reads one number at the start of text; returns the characters used, 0 when there is none.
std::size_t read_number(std::string_view text, double& value) {
  const std::size_t plus = text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  text.remove_prefix(plus);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return 0;
  const auto used = static_cast<std::size_t>(end - text.data());
  if (used == text.size() || (text[used] != 'D' && text[used] != 'd')) return plus + used;
  const std::size_t longer = read_fortran_double(text, value);
  return longer > 0 ? plus + longer : 0;
}

// A number ends at a separator, at the line's end, or where the next one's sign begins.
bool ends_here(std::string_view rest) {
  return rest.empty() || is_separator(rest[0]) || rest[0] == '-' || rest[0] == '+';
}

struct Scan {
  bool numeric = true;
  std::string_view culprit;
};

Scan scan_line(std::string_view line, std::vector<double>& values) {
  Scan scan;
  while (true) {
    while (!line.empty() && is_separator(line[0])) line.remove_prefix(1);
    if (line.empty()) return scan;
    double value = 0.0;
    const std::size_t used = read_number(line, value);
    const bool numeric = used > 0 && ends_here(line.substr(used));
    if (scan.culprit.empty() && (!numeric || !std::isfinite(value))) {
      scan.culprit = line.substr(0, field_length(line));
    }
    scan.numeric = scan.numeric && numeric;
    if (numeric) values.push_back(value);
    line.remove_prefix(numeric ? used : field_length(line));
  }
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_separator(text.back())) text.remove_suffix(1);
  double value = 0.0;
  const bool whole = !text.empty() && read_number(text, value) == text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> leading_number(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  double value = 0.0;
  const bool found = read_number(text, value) > 0 && std::isfinite(value);
  return found ? std::optional(value) : std::nullopt;
}

NumberLine parse_numbers(std::string_view line) {
  NumberLine out;
  const Scan scan = scan_line(line, out.values);
  out.numeric = scan.numeric;
  out.culprit = scan.culprit;
  return out;
}

std::string_view append_numbers(std::string_view line, std::vector<double>& values) {
  return scan_line(line, values).culprit;
}

}  // namespace dougong::seismic
