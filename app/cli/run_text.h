// What a run says on the terminal: before it starts, its answer, and where it is kept.
#pragma once

#include "app/cli/terminal.h"

namespace dougong::app {

struct ToneLine {
  std::string text;
  Tone tone = Tone::plain;
};

std::vector<std::string> preparation_text(const Preparation& preparation);
std::vector<ToneLine> answer_text(const RunResult& result);
std::vector<std::string> files_text(const std::filesystem::path& directory, std::size_t files);

}  // namespace dougong::app
