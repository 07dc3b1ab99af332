#include "app/study/override.h"

#include <fmt/format.h>

namespace dougong::app {

ScenarioError::ScenarioError(std::vector<LocatedMessage> messages) : messages_(std::move(messages)) {
  for (const LocatedMessage& message : messages_) {
    if (!text_.empty()) text_ += '\n';
    text_ += message.text();
  }
}

Override parse_override(const std::string& text, const std::string& origin) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw ScenarioError({{fmt::format("{} {}", origin, text), "expected key=value"}});
  const auto trim = [](std::string part) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    return part;
  };
  return {trim(text.substr(0, equals)), trim(text.substr(equals + 1)), origin};
}

}  // namespace dougong::app
