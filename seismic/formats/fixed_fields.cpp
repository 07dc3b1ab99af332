#include "seismic/formats/fixed_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t widest = 40, most_per_line = 100;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t digits_before(std::string_view text, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && is_digit(text[begin - 1])) --begin;
  return begin;
}

// The integer at text[at...]; 0 when there is none or it is huge.
std::size_t integer_at(std::string_view text, std::size_t at) {
  std::size_t value = 0;
  const auto result = std::from_chars(text.data() + at, text.data() + text.size(), value);
  return result.ec == std::errc{} ? value : 0;
}

// What stands at the edit descriptor text[at], a letter of F, E, I, G or D; nothing when it is only a word.
std::optional<FieldFormat> descriptor(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size() || !is_digit(text[at + 1])) return std::nullopt;
  const std::size_t begin = digits_before(text, at);
  if (begin > 0 && std::isalpha(static_cast<unsigned char>(text[begin - 1]))) return std::nullopt;
  const FieldFormat format{begin == at ? 1 : integer_at(text, begin), integer_at(text, at + 1)};
  const bool sound =
      format.per_line >= 1 && format.per_line <= most_per_line && format.width >= 1 && format.width <= widest;
  return sound ? std::optional(format) : std::nullopt;
}

std::string_view without_blanks(std::string_view field) {
  while (!field.empty() && (field.front() == ' ' || field.front() == '\t')) field.remove_prefix(1);
  while (!field.empty() && (field.back() == ' ' || field.back() == '\t')) field.remove_suffix(1);
  return field;
}

// Appends up to `count` fields of a line. Returns what is wrong with it; empty when nothing is.
std::string append_fields(std::string_view line, std::size_t count, const FieldFormat& format,
                          std::vector<double>& values) {
  const std::size_t width = format.width;
  line.remove_prefix(std::min(format.indent, line.size()));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view field = line.substr(std::min(i * width, line.size()), width);
    const auto value = field_value(field);
    if (!value) {
      const std::string_view found = without_blanks(field);
      return found.empty() ? fmt::format("{} fields", i) : in_quotes(found);
    }
    values.push_back(*value);
  }
  const std::string_view rest = without_blanks(line.substr(std::min(count * width, line.size())));
  return rest.empty() ? std::string{} : in_quotes(rest.substr(0, widest)) + " behind them";
}

InputProblem problem_on(const FileText& text, std::size_t line, std::size_t fields, std::size_t width,
                        std::string found) {
  return {text.name, line + 1, fmt::format("{} finite numbers in fields {} wide", fields, width),
          std::move(found)};
}

}  // namespace

std::optional<FieldFormat> field_format_in(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text[at])));
    if (letter != 'F' && letter != 'E' && letter != 'I' && letter != 'G' && letter != 'D') continue;
    if (const auto format = descriptor(text, at)) return format;
  }
  return std::nullopt;
}

std::optional<FieldFormat> field_format_of_line(std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
  const NumberLine numbers = parse_numbers(line.substr(0, most_per_line * widest));
  const std::size_t count = numbers.values.size();
  if (!numbers.numeric || count == 0 || count > most_per_line) return std::nullopt;
  const std::size_t indent = line.size() % count == 1 && count > 1 && line[0] == ' ' ? 1 : 0;
  const std::size_t width = (line.size() - indent) / count;
  const bool divides = width * count + indent == line.size() && width <= widest;
  return divides ? std::optional(FieldFormat{count, width, indent}) : std::nullopt;
}

std::optional<double> field_value(std::string_view field) {
  field = without_blanks(field);
  const char* const end = field.data() + field.size();
  double value = 0.0;
  // The usual field first, then the rarer spellings: +1.2, 1.0D-3.
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec == std::errc{} && result.ptr == end && std::isfinite(value)) return value;
  return parse_number(field);
}

std::vector<double> read_block(const FileText& text, std::size_t& line, std::size_t count,
                               const FieldFormat& format, std::vector<InputProblem>& problems) {
  std::vector<double> values;
  // A damaged count may be huge: no file holds more values than bytes.
  values.reserve(std::min(count, text.bytes.size() / format.width + 1));
  for (; values.size() < count; ++line) {
    const std::size_t wanted = std::min(format.per_line, count - values.size());
    if (line >= text.lines.size()) {
      problems.push_back({text.name, line, fmt::format("{} values, as the header states", count),
                          fmt::format("{} (the file is truncated)", values.size())});
      return values;
    }
    std::string wrong = append_fields(text.lines[line], wanted, format, values);
    if (wrong.empty()) continue;
    problems.push_back(problem_on(text, line, wanted, format.width, std::move(wrong)));
    return values;
  }
  return values;
}

std::vector<double> read_rows(const FileText& text, std::size_t line, const FieldFormat& format,
                              std::vector<InputProblem>& problems) {
  std::vector<double> values;
  for (; line < text.lines.size() && !without_blanks(text.lines[line]).empty(); ++line) {
    std::string wrong = append_fields(text.lines[line], format.per_line, format, values);
    if (wrong.empty()) continue;
    problems.push_back(problem_on(text, line, format.per_line, format.width, std::move(wrong)));
    return values;
  }
  return values;
}

}  // namespace dougong::seismic
