// Words of a text or of a keyboard, one after another, each with its line.
//
// Values may be spread over lines in any way; blank lines are skipped, and what follows a # on its line.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace dougong::app {

class SpaceWords {
 public:
  /// With `prompts` a person is at the keyboard: asked before a line is read, and again after a mistake.
  SpaceWords(std::istream& in, std::string source, std::ostream* prompts);

  bool asks() const { return prompts_ != nullptr; }
  /// Nothing at the end of the input. `prompt` is what a person is asked for.
  std::optional<std::string> next(const std::string& prompt);
  /// Says what is wrong to a person and forgets the rest of the line.
  void ask_again(const std::string& reason);
  void say(const std::string& text) const;

  std::size_t line() const { return line_; }
  const std::string& source() const { return source_; }

 private:
  bool fill(const std::string& prompt);

  std::istream& in_;
  std::string source_;
  std::ostream* prompts_;
  std::vector<std::string> words_;
  std::size_t next_ = 0, line_ = 0;
};

}  // namespace dougong::app
