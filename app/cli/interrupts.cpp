#include "app/cli/interrupts.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <string_view>

namespace dougong::app {
namespace {

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> run_has_begun = false;
std::atomic<bool> run_is_to_end = false;
static_assert(std::atomic<bool>::is_always_lock_free, "used in a signal handler");
std::vector<std::string> folders_to_remove;  // not changed while a handler is installed

void say(std::string_view text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody listens
}

// Only calls that are safe in a signal handler. The signal is blocked here: raised again with its
// default action it ends the program on return, as a shell expects of an interrupted program.
void on_signal(int signal) {
  const int error = errno;
  if (run_has_begun && !run_is_to_end.exchange(true)) return;
  for (auto it = folders_to_remove.rbegin(); it != folders_to_remove.rend(); ++it) ::rmdir(it->c_str());
  say(run_has_begun ? "\ndougong: interrupted again; results that were not saved yet are lost\n"
                    : "\ndougong: interrupted before the run began; nothing was written\n");
  ::signal(signal, SIG_DFL);
  ::raise(signal);
  errno = error;
}

}  // namespace

Interrupts::Interrupts(const std::vector<std::filesystem::path>& folders) {
  run_has_begun = run_is_to_end = false;
  folders_to_remove.clear();
  for (const auto& folder : folders) folders_to_remove.push_back(folder.string());
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (int i = 0; i < 3; ++i) {
    sigaction(ending_signals[i], &action, &previous_[i]);
    // nohup and background jobs ignore signals on purpose.
    if (previous_[i].sa_handler == SIG_IGN) sigaction(ending_signals[i], &previous_[i], nullptr);
  }
  // A reader that goes away (| head) must not cost a run its results.
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, &previous_pipe_);
}

Interrupts::~Interrupts() {
  for (int i = 0; i < 3; ++i) sigaction(ending_signals[i], &previous_[i], nullptr);
  sigaction(SIGPIPE, &previous_pipe_, nullptr);
}

void Interrupts::run_begins() {
  run_has_begun = true;
}
bool Interrupts::asked() const {
  return run_is_to_end;
}

}  // namespace dougong::app
