#include "app/study/key_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using engine::Vec2;

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
  if (std::holds_alternative<ListValue>(entry.value)) return "a TOML array";
  if (std::holds_alternative<TableValue>(entry.value)) return "a TOML table";
  return fmt::format("a TOML {}", std::get<OtherValue>(entry.value).kind);
}

std::string text_of(const KeyFacts& key, const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  if (!text) throw QuantityError(fmt::format("expected a text in quotes, found {}", found(entry)));
  if (key.choices.empty() || std::ranges::find(key.choices, *text) != key.choices.end()) return *text;
  const std::string nearest = structures::nearest_name(*text, key.choices);
  throw QuantityError(fmt::format("expected one of {}, found {}{}", fmt::join(key.choices, ", "),
                                  found(entry),
                                  nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

bool flag_of(const Entry& entry) {
  if (const auto* flag = std::get_if<bool>(&entry.value)) return *flag;
  const auto* text = std::get_if<std::string>(&entry.value);
  if (text && entry.typed && (*text == "true" || *text == "false")) return *text == "true";
  throw QuantityError(fmt::format("expected true or false, found {}", found(entry)));
}

std::string allowed_range(const KeyFacts& key) {
  const auto print = [&](double v) { return print_quantity(v, key.dimension); };
  if (key.least == above_zero) return "above " + print(0.0);
  if (key.most < std::numeric_limits<double>::infinity())
    return fmt::format("from {} to {}", print(key.least), print(key.most));
  return fmt::format("of at least {}", print(key.least));
}

double number_within(const KeyFacts& key, const Entry& entry) {
  const double value = number_of(entry, key.dimension);
  if (key.least <= value && value <= key.most) return value;
  throw QuantityError(
      fmt::format("expected a value {}, found {}", allowed_range(key), print_quantity(value, key.dimension)));
}

const std::vector<Entry>& items_of(const Entry& entry, const std::string& expected) {
  if (const auto* list = std::get_if<ListValue>(&entry.value)) return list->items;
  throw QuantityError(fmt::format("expected {}, found {}", expected, found(entry)));
}

Vec2 point_of(const KeyFacts& key, const Entry& entry) {
  const std::string example =
      key.dimension == Dimension::length ? "[\"1 m\", \"2 m\"]" : "[x, y], each with its unit";
  const std::vector<Entry>& items = items_of(entry, "a point " + example);
  if (items.size() != 2)
    throw QuantityError(fmt::format("expected two values, {}, found {}", example, items.size()));
  return {number_within(key, items[0]), number_within(key, items[1])};
}

std::vector<Vec2> points_of(const KeyFacts& key, const Entry& entry) {
  std::vector<Vec2> points;
  for (const Entry& item : items_of(entry, "a list of points [[\"0 m\", \"0 m\"], ...]"))
    points.push_back(point_of(key, item));
  return points;
}

std::vector<std::string> texts_of(const KeyFacts& key, const Entry& entry) {
  std::vector<std::string> texts;
  for (const Entry& item : items_of(entry, "a list of texts [\"...\", ...]"))
    texts.push_back(text_of(key, item));
  return texts;
}

struct Setter {
  const KeyFacts& key;
  const Entry& entry;
  void operator()(std::string* place) const { *place = text_of(key, entry); }
  void operator()(bool* place) const { *place = flag_of(entry); }
  void operator()(double* place) const { *place = number_within(key, entry); }
  void operator()(Vec2* place) const { *place = point_of(key, entry); }
  void operator()(std::vector<Vec2>* place) const { *place = points_of(key, entry); }
  void operator()(std::vector<std::string>* place) const { *place = texts_of(key, entry); }
  void operator()(std::optional<double>* place) const {
    *place = is_none(entry) ? std::nullopt : std::optional(number_within(key, entry));
  }
  void operator()(std::optional<Vec2>* place) const {
    *place = is_none(entry) ? std::nullopt : std::optional(point_of(key, entry));
  }
};

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

void set_slot(const KeyFacts& key, const Entry& entry, const Slot& slot) {
  std::visit(Setter{key, entry}, slot);
}

bool is_set(const Entry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  return !text || (!text->empty() && *text != "none");
}

}  // namespace dougong::app
