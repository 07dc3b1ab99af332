#include "app/cli/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace dougong::app {
namespace {

constexpr int widest_bar = 24;
constexpr std::chrono::milliseconds between_updates{100};

std::string bar(double fraction, int width) {
  const int filled = static_cast<int>(fraction * width);
  std::string text;
  for (int i = 0; i < width; ++i) text += i < filled ? "█" : "·";
  return text;
}

int columns_of(std::FILE* stream) {
  struct winsize size = {};
  return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// A line that wraps cannot be replaced: the bar gets what the text leaves, and the text is cut.
std::string one_line(double fraction, const std::string& text, int columns) {
  const int left = columns - static_cast<int>(text.size()) - 4;
  const std::string start = left > 4 ? bar(fraction, std::min(left, widest_bar)) + " " : "";
  return "  " + start + text.substr(0, static_cast<std::size_t>(std::max(columns - 3, 0)));
}

bool says_yes(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool can_move_its_cursor(std::FILE* stream) {
  const char* kind = std::getenv("TERM");
  return isatty(fileno(stream)) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

// Beyond this a level is falling, not drifting; the report freezes its drift where it was lost.
constexpr double falling = 0.5;

std::string drift_so_far(double ratio) {
  return std::abs(ratio) > falling ? "beyond 50 %" : fmt::format("{:+.3f} %", 100.0 * ratio);
}

std::string describe(const Progress& p) {
  return fmt::format("{:6.2f} / {:.2f} s   peak drift {}   energy error {:.2g} %", p.time, p.end_time,
                     drift_so_far(p.peak_drift), 100.0 * p.energy_error);
}

std::string describe(const SceneProgress& p) {
  return fmt::format("{:6.2f} / {:.2f} s   fastest {:.3g} m/s   energy error {:.2g} %", p.time, p.end_time,
                     p.fastest, 100.0 * p.energy_error);
}

std::string describe(const TradeoffProgress& p) {
  return fmt::format("{} of {}: {}", p.done + 1, p.total, p.now);
}

}  // namespace

Terminal::Terminal(std::FILE* stream)
    : stream_(stream),
      interactive_(can_move_its_cursor(stream)),
      colour_(interactive_ && !says_yes("NO_COLOR")) {}

std::string Terminal::painted(const std::string& text, Tone tone) const {
  if (!colour_ || tone == Tone::plain) return text;
  const char* code = tone == Tone::good       ? "1;32"
                     : tone == Tone::bad      ? "1;31"
                     : tone == Tone::doubtful ? "1;33"
                                              : "2";
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

// A terminal that is gone must not cost a run its results, so failures are not told.
void Terminal::write(const std::string& text) const {
  std::fputs(text.c_str(), stream_);
  std::fflush(stream_);
}

void Terminal::line(const std::string& text, Tone tone) const {
  write(painted(text, tone) + "\n");
}

void Terminal::progress(const Progress& p) {
  show_progress(p.time, p.end_time, describe(p));
}

void Terminal::progress(const SceneProgress& p) {
  show_progress(p.time, p.end_time, describe(p));
}

void Terminal::progress(const TradeoffProgress& p) {
  const double total = static_cast<double>(std::max<std::size_t>(p.total, 1));
  show_progress(std::min(static_cast<double>(p.done) + p.part, total), total, describe(p));
}

void Terminal::progress(const EnsembleProgress& p) {
  const double total = static_cast<double>(std::max<std::size_t>(p.total, 1));
  show_progress(std::min(static_cast<double>(p.done) + p.part, total), total,
                p.total == 1 ? "of the run" : fmt::format("{} of {} runs", p.done, p.total));
}

void Terminal::progress(const StaticProgress& p) {
  show_progress(p.share, 1.0, fmt::format("towards the {}, {}", to_string(p.side), p.doing));
}

void Terminal::show_progress(double time, double end_time, const std::string& text) {
  const double fraction = end_time > 0.0 ? time / end_time : 1.0;
  if (interactive_) return update_line(fraction, text);
  const int tenth = static_cast<int>(10.0 * fraction);
  if (tenth <= last_tenth_) return;
  last_tenth_ = tenth;
  write(fmt::format("  {:3d} %  {}\n", 10 * tenth, text));
}

void Terminal::update_line(double fraction, const std::string& text) {
  const Clock::time_point now = Clock::now();
  if (open_line_ && now - last_update_ < between_updates && fraction < 1.0) return;
  last_update_ = now;
  write("\r" + one_line(fraction, text, columns_of(stream_)) + "\033[K");
  open_line_ = true;
}

void Terminal::end_progress() {
  if (open_line_) write("\n");
  open_line_ = false;
  last_tenth_ = -1;
}

}  // namespace dougong::app
