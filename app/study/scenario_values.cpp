#include "app/study/scenario_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

bool is_none(const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  return text && *text == "none";
}

/// The value as it was written, for messages.
std::string found(const Entry& entry) {
  if (const auto* text = std::get_if<std::string>(&entry.value)) return toml_text(*text);
  if (const auto* integer = std::get_if<std::int64_t>(&entry.value)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&entry.value)) return structures::print_number(*number);
  if (const auto* flag = std::get_if<bool>(&entry.value)) return *flag ? "true" : "false";
  return fmt::format("a TOML {}", std::get<OtherValue>(entry.value).kind);
}

std::string text_of(const ScenarioKey& key, const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  if (!text) throw QuantityError(fmt::format("expected a text in quotes, found {}", found(entry)));
  if (key.choices.empty() || std::ranges::find(key.choices, *text) != key.choices.end()) return *text;
  const std::string nearest = structures::nearest_name(*text, key.choices);
  throw QuantityError(fmt::format("expected {}, found {}{}", kind_of(key), found(entry),
                                  nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

bool flag_of(const Entry& entry) {
  if (const auto* flag = std::get_if<bool>(&entry.value)) return *flag;
  const auto* text = std::get_if<std::string>(&entry.value);
  if (text && entry.typed && (*text == "true" || *text == "false")) return *text == "true";
  throw QuantityError(fmt::format("expected true or false, found {}", found(entry)));
}

double number_within(const ScenarioKey& key, const Entry& entry) {
  const double value = number_of(entry, key.dimension);
  if (key.least <= value && value <= key.most) return value;
  const auto print = [&](double v) { return print_quantity(v, key.dimension); };
  const std::string range = std::isfinite(key.most)
                                ? fmt::format("from {} to {}", print(key.least), print(key.most))
                                : fmt::format("of at least {}", print(key.least));
  throw QuantityError(fmt::format("expected a value {}, found {}", range, print(value)));
}

}  // namespace

double number_of(const Entry& entry, Dimension dimension) {
  if (const auto* text = std::get_if<std::string>(&entry.value)) {
    if (dimension == Dimension::count && !entry.typed)
      throw QuantityError(fmt::format("expected a whole number without quotes, found {}", found(entry)));
    return parse_quantity(*text, dimension);
  }
  // A bare number goes the same way, so that it is refused where it lacks its unit.
  if (const auto* integer = std::get_if<std::int64_t>(&entry.value))
    return parse_quantity(fmt::format("{}", *integer), dimension);
  if (const auto* number = std::get_if<double>(&entry.value))
    return parse_quantity(structures::print_number(*number), dimension);
  throw QuantityError(fmt::format("expected a {}, found {}", name_of(dimension), found(entry)));
}

void set_key(const ScenarioKey& key, const Entry& entry, Scenario& scenario) {
  const Slot slot = key.slot(scenario);
  if (const auto* text = std::get_if<std::string*>(&slot)) **text = text_of(key, entry);
  if (const auto* flag = std::get_if<bool*>(&slot)) **flag = flag_of(entry);
  if (const auto* number = std::get_if<double*>(&slot)) **number = number_within(key, entry);
  if (const auto* maybe = std::get_if<std::optional<double>*>(&slot))
    **maybe = is_none(entry) ? std::nullopt : std::optional(number_within(key, entry));
}

bool is_set(const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  return !text || (!text->empty() && *text != "none");
}

}  // namespace dougong::app
