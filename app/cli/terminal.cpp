#include "app/cli/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace dougong::app {
namespace {

constexpr int bar_width = 24;

std::string bar(double fraction) {
  const int filled = static_cast<int>(fraction * bar_width);
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += i < filled ? "█" : "·";
  return text;
}

double fraction_of(const Progress& p) { return p.end_time > 0.0 ? p.time / p.end_time : 1.0; }

std::string describe(const Progress& p) {
  return fmt::format("{:6.2f} / {:.2f} s   peak drift {:+.3f} %   energy error {:.2g} %", p.time, p.end_time,
                     100.0 * p.peak_drift, 100.0 * p.energy_error);
}

}  // namespace

Terminal::Terminal(std::FILE* stream) : stream_(stream), interactive_(isatty(fileno(stream)) != 0) {
  const char* no_colour = std::getenv("NO_COLOR");
  colour_ = interactive_ && (no_colour == nullptr || *no_colour == '\0');
}

std::string Terminal::painted(const std::string& text, Tone tone) const {
  if (!colour_ || tone == Tone::plain) return text;
  const char* code = tone == Tone::good       ? "1;32"
                     : tone == Tone::bad      ? "1;31"
                     : tone == Tone::doubtful ? "1;33"
                                              : "2";
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

void Terminal::line(const std::string& text, Tone tone) const {
  fmt::print(stream_, "{}\n", painted(text, tone));
  std::fflush(stream_);
}

void Terminal::progress(const Progress& p) {
  const double fraction = fraction_of(p);
  if (interactive_) {
    fmt::print(stream_, "\r  {} {}\033[K", bar(fraction), describe(p));
    std::fflush(stream_);
    open_line_ = true;
    return;
  }
  const int tenth = static_cast<int>(10.0 * fraction);
  if (tenth == last_tenth_) return;
  last_tenth_ = tenth;
  fmt::print(stream_, "  {:3d} %  {}\n", 10 * tenth, describe(p));
  std::fflush(stream_);
}

void Terminal::end_progress() {
  if (open_line_) fmt::print(stream_, "\n");
  open_line_ = false;
}

}  // namespace dougong::app
