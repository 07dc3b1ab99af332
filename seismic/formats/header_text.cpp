#include "seismic/formats/header_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t longest_line = 1000;  // characters of a header line that are looked at

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

std::size_t find_words(std::string_view line, std::string_view words) {
  line = line.substr(0, longest_line);
  const auto at = std::search(line.begin(), line.end(), words.begin(), words.end(),
                              [](char a, char b) { return upper(a) == upper(b); });
  return at == line.end() && !words.empty() ? std::string_view::npos
                                            : static_cast<std::size_t>(at - line.begin());
}

// Up to three numbers (degrees, minutes, seconds), then the letter of a hemisphere. Moves text past it.
std::optional<double> take_angle(std::string_view& text) {
  double angle = 0.0, unit = 1.0;
  for (int part = 0; part < 3; ++part, unit /= 60.0) {
    const auto start = text.find_first_of("0123456789");
    if (start == std::string_view::npos) return std::nullopt;
    text.remove_prefix(start);
    const auto end = std::min(text.find_first_not_of("0123456789."), text.size());
    angle += leading_number(text.substr(0, end)).value_or(0.0) * unit;
    text.remove_prefix(end);
    const auto letter = text.find_first_not_of(" ");
    if (letter == std::string_view::npos) return std::nullopt;
    const char side = upper(text[letter]);
    if (side == 'N' || side == 'E' || side == 'S' || side == 'W') {
      text.remove_prefix(letter + 1);
      return side == 'S' || side == 'W' ? -angle : angle;
    }
  }
  return std::nullopt;
}

}  // namespace

bool contains(std::string_view line, std::string_view words) {
  return find_words(line, words) != std::string_view::npos;
}

std::optional<std::size_t> find_line(const FileText& text, std::string_view words, std::size_t first,
                                     std::size_t last) {
  for (std::size_t i = first; i < std::min(last, text.lines.size()); ++i) {
    if (contains(text.lines[i], words)) return i;
  }
  return std::nullopt;
}

std::string_view behind(std::string_view line, std::string_view words) {
  const auto at = find_words(line, words);
  return at == std::string_view::npos ? std::string_view{} : trimmed(line.substr(at + words.size()));
}

std::string value_behind(const FileText& text, std::string_view words, std::size_t first, std::size_t last) {
  const auto line = find_line(text, words, first, last);
  return line ? printable(behind(text.lines[*line], words)) : std::string{};
}

std::optional<double> number_behind(std::string_view line, std::string_view words) {
  std::string_view rest = behind(line, words);
  rest.remove_prefix(std::min(rest.find_first_not_of(" =:"), rest.size()));
  return leading_number(rest);
}

std::string_view line_at(const FileText& text, std::size_t index) {
  return index < text.lines.size() ? text.lines[index].substr(0, longest_line) : std::string_view{};
}

std::string_view before(std::string_view text, std::string_view mark) {
  return trimmed(text.substr(0, find_words(text, mark)));
}

std::optional<Place> place_in(std::string_view text) {
  const auto latitude = take_angle(text);
  const auto longitude = latitude ? take_angle(text) : std::nullopt;
  if (!longitude || std::abs(*latitude) > 90.0 || std::abs(*longitude) > 360.0) return std::nullopt;
  return Place{*latitude, *longitude, std::nullopt};
}

void keep_header(const FileText& text, std::size_t first, std::size_t last, Provenance& from) {
  for (std::size_t i = first; i < std::min(last, text.lines.size()); ++i) {
    const std::string line = printable(trimmed(line_at(text, i)));
    if (!line.empty()) from.header.emplace_back(fmt::format("header line {}", i + 1), line);
    from.synthetic = from.synthetic || contains(line, "SYNTHETIC");
  }
}

}  // namespace dougong::seismic
