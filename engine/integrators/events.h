// Where a step must end: the first sign change of any of the system's event values (a gap that closes or
// opens, a sliding point that turns back) within an accepted step.
//
// The step is taken again, shorter, at the secant's estimate, with bisection when that stalls, until the
// end of the step lies just behind the event: by no more than a given time.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace dougong::engine {

class EventBracket {
 public:
  void resize(std::size_t count) { start_.resize(count), low_.resize(count), high_.resize(count); }
  std::span<double> start() { return start_; }
  /// Values at the end of the step last tried.
  std::span<double> now() { return high_; }

  /// After a step of length h: whether an event lies in it. Starts the search.
  bool begins(double h) {
    low_ = start_;
    low_time_ = 0.0, high_time_ = h, tries_ = 0;
    return crossed();
  }
  /// Whether the event lies within dt before the end of the bracket.
  bool found(double dt) const { return high_time_ - root() <= dt || tries_ > most_tries; }
  double high_time() const { return high_time_; }
  double next_time(double dt) {
    ++tries_;
    const double width = high_time_ - low_time_;
    const double aim = tries_ % 3 == 0 ? low_time_ + 0.5 * width : root() + 0.5 * dt;
    return std::clamp(aim, low_time_ + 1e-3 * width, high_time_ - 1e-3 * width);
  }
  /// The values at `time` are in `tried`: it becomes one end of the bracket. Returns whether the later one.
  bool note(double time, std::span<const double> tried) {
    const bool behind = any_crossing(tried);
    auto& side = behind ? high_ : low_;
    std::copy(tried.begin(), tried.end(), side.begin());
    (behind ? high_time_ : low_time_) = time;
    return behind;
  }

 private:
  static constexpr int most_tries = 60;

  // Values that are not numbers are not watched. A gap of exactly zero counts as open.
  bool crosses(std::size_t i, double value) const {
    return !std::isnan(start_[i]) && (start_[i] > 0.0) != (value > 0.0);
  }
  bool any_crossing(std::span<const double> values) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (crosses(i, values[i])) return true;
    return false;
  }
  bool crossed() const { return any_crossing(high_); }
  // The earliest zero of the chords.
  double root() const {
    double part = 1.0;
    for (std::size_t i = 0; i < high_.size(); ++i)
      if (crosses(i, high_[i])) {
        const double low = std::abs(low_[i]), high = std::abs(high_[i]);
        part = std::min(part, low + high > 0.0 ? low / (low + high) : 0.0);
      }
    return low_time_ + part * (high_time_ - low_time_);
  }

  std::vector<double> start_, low_, high_;
  double low_time_ = 0.0, high_time_ = 0.0;
  int tries_ = 0;
};

}  // namespace dougong::engine
