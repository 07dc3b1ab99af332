// The keys of a target or of a motion to make, each taken once by who knows it; what nobody takes is an
// error.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/study/quantity.h"

namespace dougong::app {

std::string trimmed(const std::string& text);
/// "a=1, b=0.2 g". Throws ScenarioError that names `where`.
std::map<std::string, std::string> key_values(const std::string& list, const std::string& where);

class WordKeys {
 public:
  WordKeys(std::string where, std::map<std::string, std::string> values);

  bool has(const std::string& key) const { return values_.contains(key); }
  std::string word(const std::string& key);  // must be there
  std::string word(const std::string& key, const std::string& otherwise);
  double quantity(const std::string& key, Dimension dimension);  // must be there
  double quantity(const std::string& key, Dimension dimension, double otherwise);
  double positive(const std::string& key, Dimension dimension);
  double positive(const std::string& key, Dimension dimension, double otherwise);
  int number(const std::string& key, int otherwise);
  /// Throws for a key that was not taken.
  void finish() const;
  /// Throws ScenarioError.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  double parsed(const std::string& value, const std::string& key, Dimension dimension) const;

  std::string where_;
  std::map<std::string, std::string> values_;
};

}  // namespace dougong::app
