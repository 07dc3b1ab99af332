// The terminal: calm text, colour only where a person looks on, one progress line that updates.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "app/study/ensemble.h"
#include "app/study/execute.h"
#include "app/study/scene_run.h"
#include "app/study/statics.h"
#include "app/study/tradeoff/tradeoff.h"

namespace dougong::app {

enum class Tone { plain, good, bad, doubtful, faint };

/// Where messages go: standard output, or standard error when standard output is for a program.
class Terminal {
 public:
  explicit Terminal(std::FILE* stream);

  void line(const std::string& text = {}, Tone tone = Tone::plain) const;
  /// One line that replaces the last; only on a terminal, else one line every tenth of the run.
  void progress(const Progress& progress);
  void progress(const SceneProgress& progress);
  void progress(const TradeoffProgress& progress);
  void progress(const EnsembleProgress& progress);
  void progress(const StaticProgress& progress);
  void end_progress();

 private:
  using Clock = std::chrono::steady_clock;

  std::string painted(const std::string& text, Tone tone) const;
  void write(const std::string& text) const;
  void show_progress(double time, double end_time, const std::string& text);
  void update_line(double fraction, const std::string& text);

  std::FILE* stream_;
  bool interactive_;
  bool colour_;
  int last_tenth_ = -1;
  bool open_line_ = false;
  Clock::time_point last_update_ = {};
};

}  // namespace dougong::app
