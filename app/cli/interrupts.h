// Ctrl-C (and the TERM and HUP that batch systems and lost terminals send).
//
// Before the run begins it ends the program and takes the empty output folder away. During the run the
// first one ends the run only, whose part is saved as a partial result; the second one ends the program.
#pragma once

#include <csignal>
#include <filesystem>
#include <vector>

namespace dougong::app {

/// Handlers are installed while this lives; at most one at a time.
class Interrupts {
 public:
  /// `folders`: removed, innermost (last) first, when the program is ended and they are empty.
  explicit Interrupts(const std::vector<std::filesystem::path>& folders);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  void run_begins();
  bool asked() const;

 private:
  struct sigaction previous_[3] = {};
  struct sigaction previous_pipe_ = {};
};

}  // namespace dougong::app
