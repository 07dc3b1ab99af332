#include "app/study/space_words.h"

#include <sstream>

namespace dougong::app {
namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

SpaceWords::SpaceWords(std::istream& in, std::string source, std::ostream* prompts)
    : in_(in), source_(std::move(source)), prompts_(prompts) {}

bool SpaceWords::fill(const std::string& prompt) {
  while (next_ >= words_.size()) {
    if (prompts_) *prompts_ << prompt << ": " << std::flush;
    std::string line;
    if (!std::getline(in_, line)) return false;
    ++line_;
    words_ = words_of(line);
    next_ = 0;
  }
  return true;
}

std::optional<std::string> SpaceWords::next(const std::string& prompt) {
  if (!fill(prompt)) return std::nullopt;
  return words_[next_++];
}

void SpaceWords::ask_again(const std::string& reason) {
  say(reason);
  next_ = words_.size();
}

void SpaceWords::say(const std::string& text) const {
  if (prompts_) *prompts_ << "  " << text << '\n';
}

}  // namespace dougong::app
