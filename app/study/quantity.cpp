#include "app/study/quantity.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using structures::Unit;

struct Parts {
  double number = 0.0;
  std::string_view unit;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n\r") - first + 1);
}

std::string expectation(Dimension dimension) {
  if (dimension == Dimension::count) return "a whole number";
  if (dimension == Dimension::ratio) return "a bare number or a percentage";
  const std::string_view name = name_of(dimension);
  return fmt::format("{} {} with its unit ({})", name.starts_with('a') ? "an" : "a", name,
                     structures::possible_units(dimension));
}

/// The number in front and what follows it. from_chars knows no locale, but no leading plus either.
Parts split(std::string_view text, Dimension dimension) {
  std::string_view rest = trimmed(text);
  if (rest.size() > 1 && rest.front() == '+' && rest[1] != '-') rest.remove_prefix(1);
  Parts parts;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), parts.number);
  if (error == std::errc::result_out_of_range)
    throw QuantityError(fmt::format("the number of \"{}\" is beyond what a double holds", text));
  if (error != std::errc() || !std::isfinite(parts.number))
    throw QuantityError(fmt::format("expected {}, found \"{}\"", expectation(dimension), text));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  parts.unit = trimmed(rest);
  return parts;
}

[[noreturn]] void refuse_unit(std::string_view text, std::string_view symbol, Dimension dimension) {
  std::vector<std::string> symbols;
  for (const Unit& unit : structures::units()) {
    if (unit.symbol == symbol)
      throw QuantityError(fmt::format("expected {}, found \"{}\": {} is a unit of {}", expectation(dimension),
                                      text, symbol, name_of(unit.dimension)));
    if (unit.dimension == dimension) symbols.emplace_back(unit.symbol);
  }
  std::string message =
      fmt::format("expected {}, found \"{}\": unknown unit \"{}\"", expectation(dimension), text, symbol);
  const std::string nearest = structures::nearest_name(symbol, symbols);
  if (!nearest.empty()) message += fmt::format("; did you mean \"{}\"?", nearest);
  throw QuantityError(message);
}

double bare(std::string_view text, double number, Dimension dimension) {
  if (has_unit(dimension))
    throw QuantityError(
        fmt::format("expected {}, found the bare number {}", expectation(dimension), trimmed(text)));
  if (dimension == Dimension::count && number != std::floor(number))
    throw QuantityError(fmt::format("expected {}, found {}", expectation(dimension), trimmed(text)));
  return number;
}

}  // namespace

double parse_quantity(std::string_view text, Dimension dimension) {
  const Parts parts = split(text, dimension);
  if (parts.unit.empty()) return bare(text, parts.number, dimension);
  for (const Unit& unit : structures::units()) {
    if (unit.dimension != dimension || unit.symbol != parts.unit) continue;
    const double value = unit.to_si(parts.number);
    if (!std::isfinite(value))
      throw QuantityError(fmt::format("the number of \"{}\" is beyond what a double holds", text));
    return value;
  }
  refuse_unit(text, parts.unit, dimension);
}

std::string print_quantity(double value, Dimension dimension) {
  return structures::print_value(value, dimension);
}

}  // namespace dougong::app
