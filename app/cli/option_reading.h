// The options of a command that hold quantities, read together so that all that is wrong is said at once.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "app/study/entries.h"
#include "app/study/quantity.h"

namespace dougong::app {

class OptionReading {
 public:
  /// What `read` throws as std::invalid_argument is an error of that option.
  template <class Read>
  void attempt(const std::string& option, Read read) {
    try {
      read();
    } catch (const std::invalid_argument& error) {
      errors_.push_back({option, error.what()});
    }
  }
  /// `otherwise` for an empty text. `least` may be above_zero (app/study/key.h).
  double number(const std::string& option, const std::string& text, double otherwise, Dimension dimension,
                double least, double most);
  /// Throws ScenarioError with all that was wrong.
  void finish();

 private:
  std::vector<LocatedMessage> errors_;
};

}  // namespace dougong::app
