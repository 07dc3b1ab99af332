// What a run says on the terminal: before it starts, its answer, and where it is kept.
#pragma once

#include "app/cli/terminal.h"

namespace dougong::app {

struct ToneLine {
  std::string text;
  Tone tone = Tone::plain;
};

/// A name and its value, in two columns.
std::string row(const std::string& name, const std::string& value);
/// "2.5 ms", "41 s", "3 h".
std::string time_text(double value);
/// The heads of a sheet's sentences: what stands before the colon.
std::string heads_of(const std::vector<std::string>& terms);

std::vector<std::string> preparation_text(const Preparation& preparation);
std::vector<ToneLine> answer_text(const RunResult& result);
/// What half the step changed of a run that was made once; empty where it was not done.
std::vector<ToneLine> half_step_line(const RunResult& result);
std::vector<std::string> files_text(const std::filesystem::path& directory, std::size_t files);

}  // namespace dougong::app
