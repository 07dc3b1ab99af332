// One key=value of the command line, and the messages about what was written there or in a file.
#pragma once

#include <exception>
#include <string>
#include <vector>

namespace dougong::app {

/// The key may be dotted ("record.pga"), or its last word alone where that is unambiguous ("pga",
/// "storeys"), with - for _; the value is text as typed.
struct Override {
  std::string key;
  std::string value;
  std::string origin = "--set";  // how messages call it
};

/// Splits "key=value". Throws ScenarioError without an equals sign.
Override parse_override(const std::string& text, const std::string& origin = "--set");

struct LocatedMessage {
  std::string where;  // "study.toml:12:7", "--set storeys=six"
  std::string message;
  std::string text() const { return where + ": " + message; }
};

/// All that is wrong in a scenario or a scene file.
class ScenarioError : public std::exception {
 public:
  explicit ScenarioError(std::vector<LocatedMessage> messages);
  const std::vector<LocatedMessage>& messages() const { return messages_; }
  /// All messages, one a line.
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<LocatedMessage> messages_;
  std::string text_;
};

}  // namespace dougong::app
