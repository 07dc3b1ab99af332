#include "app/study/word_keys.h"

#include <sstream>
#include <utility>

#include "app/study/override.h"

namespace dougong::app {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::map<std::string, std::string> key_values(const std::string& list, const std::string& where) {
  std::map<std::string, std::string> values;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto equals = part.find('=');
    const std::string key = trimmed(part.substr(0, equals));
    if (equals == std::string::npos)
      throw ScenarioError({LocatedMessage{where, "expected key=value, found \"" + trimmed(part) + "\""}});
    if (!values.emplace(key, trimmed(part.substr(equals + 1))).second)
      throw ScenarioError({LocatedMessage{where, "the key " + key + " is given twice"}});
  }
  return values;
}

WordKeys::WordKeys(std::string where, std::map<std::string, std::string> values)
    : where_(std::move(where)), values_(std::move(values)) {}

std::string WordKeys::word(const std::string& key, const std::string& otherwise) {
  const auto found = values_.extract(key);
  return found.empty() ? otherwise : found.mapped();
}

std::string WordKeys::word(const std::string& key) {
  if (!has(key)) fail("expected the key " + key + ", found none");
  return word(key, "");
}

double WordKeys::quantity(const std::string& key, Dimension dimension) {
  return parsed(word(key), key, dimension);
}

double WordKeys::quantity(const std::string& key, Dimension dimension, double otherwise) {
  return has(key) ? quantity(key, dimension) : otherwise;
}

double WordKeys::positive(const std::string& key, Dimension dimension) {
  const double value = quantity(key, dimension);
  if (!(value > 0.0)) fail(key + ": expected a value above zero");
  return value;
}

double WordKeys::positive(const std::string& key, Dimension dimension, double otherwise) {
  return has(key) ? positive(key, dimension) : otherwise;
}

int WordKeys::number(const std::string& key, int otherwise) {
  const double value = quantity(key, Dimension::count, otherwise);
  if (!(value >= 0.0 && value <= 1e9)) fail(key + ": expected a count up to 1e9");
  return static_cast<int>(value);
}

void WordKeys::finish() const {
  if (!values_.empty()) fail("unknown key \"" + values_.begin()->first + "\"");
}

void WordKeys::fail(const std::string& message) const {
  throw ScenarioError({LocatedMessage{where_, message}});
}

double WordKeys::parsed(const std::string& value, const std::string& key, Dimension dimension) const {
  try {
    return parse_quantity(value, dimension);
  } catch (const QuantityError& error) {
    fail(key + ": " + error.what());
  }
}

}  // namespace dougong::app
