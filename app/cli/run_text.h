// What a run says on the terminal: before it starts, and its verdict in ten lines.
#pragma once

#include "app/cli/terminal.h"

namespace dougong::app {

struct ToneLine {
  std::string text;
  Tone tone = Tone::plain;
};

std::vector<std::string> preparation_text(const Preparation& preparation);
std::vector<ToneLine> verdict_text(const RunResult& result, const std::filesystem::path& directory,
                                   std::size_t files);

}  // namespace dougong::app
