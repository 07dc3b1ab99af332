#include "app/study/key.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

using engine::Vec2;

std::string number_kind(Dimension dimension) {
  return dimension == Dimension::count ? "whole number" : std::string(name_of(dimension));
}

std::string toml_point(Vec2 p, Dimension dimension) {
  return fmt::format("[{}, {}]", toml_number(p.x, dimension), toml_number(p.y, dimension));
}

template <class T, class Print>
std::string toml_list(const std::vector<T>& items, Print print) {
  std::string text;
  for (const T& item : items) text += (text.empty() ? "" : ", ") + print(item);
  return "[" + text + "]";
}

bool has_numbers(const Slot& slot) {
  return !std::holds_alternative<std::string*>(slot) && !std::holds_alternative<bool*>(slot) &&
         !std::holds_alternative<std::vector<std::string>*>(slot);
}

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

struct Kind {
  const KeyFacts& key;
  std::string text() const {
    return key.choices.empty() ? "text" : fmt::format("one of {}", fmt::join(key.choices, ", "));
  }
  std::string operator()(std::string*) const { return text(); }
  std::string operator()(bool*) const { return "true or false"; }
  std::string operator()(double*) const { return number_kind(key.dimension); }
  std::string operator()(std::optional<double>*) const { return number_kind(key.dimension) + " or none"; }
  std::string operator()(Vec2*) const { return fmt::format("[x, y] of {}", number_kind(key.dimension)); }
  std::string operator()(std::optional<Vec2>*) const {
    return fmt::format("[x, y] of {} or none", number_kind(key.dimension));
  }
  std::string operator()(std::vector<Vec2>*) const {
    return fmt::format("list of [x, y] of {}", number_kind(key.dimension));
  }
  std::string operator()(std::vector<std::string>*) const {
    return key.choices.empty() ? "list of texts" : fmt::format("list of {}", fmt::join(key.choices, ", "));
  }
};

struct Value {
  Dimension dimension;
  std::string operator()(const std::string* text) const { return toml_text(*text); }
  std::string operator()(const bool* flag) const { return *flag ? "true" : "false"; }
  std::string operator()(const double* number) const { return toml_number(*number, dimension); }
  std::string operator()(const std::optional<double>* maybe) const {
    return *maybe ? toml_number(**maybe, dimension) : toml_text("none");
  }
  std::string operator()(const Vec2* point) const { return toml_point(*point, dimension); }
  std::string operator()(const std::optional<Vec2>* maybe) const {
    return *maybe ? toml_point(**maybe, dimension) : toml_text("none");
  }
  std::string operator()(const std::vector<Vec2>* points) const {
    return toml_list(*points, [&](Vec2 p) { return toml_point(p, dimension); });
  }
  std::string operator()(const std::vector<std::string>* texts) const { return toml_list(*texts, toml_text); }
};

}  // namespace

std::string kind_of(const KeyFacts& key, const Slot& slot) {
  return std::visit(Kind{key}, slot);
}

std::string range_of(const KeyFacts& key, const Slot& slot) {
  if (!has_numbers(slot)) return "";
  const auto print = [&](double v) { return print_quantity(v, key.dimension); };
  const bool from = std::isfinite(key.least), to = std::isfinite(key.most);
  const std::string least = key.least == above_zero ? "above " + print(0.0) : "from " + print(key.least);
  if (from && to) return fmt::format("{} to {}", least, print(key.most));
  if (from) return key.least == above_zero ? least : "at least " + print(key.least);
  return to ? "at most " + print(key.most) : "any";
}

std::string toml_value(const KeyFacts& key, const Slot& slot) {
  return std::visit(Value{key.dimension}, slot);
}

std::string toml_number(double value, Dimension dimension) {
  const std::string text = print_quantity(value, dimension);
  return has_unit(dimension) ? toml_text(text) : text;
}

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_key(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, is_bare) ? name : toml_text(name);
}

}  // namespace dougong::app
