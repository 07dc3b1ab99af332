#include "app/study/output_times.h"

#include <algorithm>
#include <cmath>

namespace dougong::app {

const std::vector<double>& output_times(const RunResult& run) {
  return run.response.times.empty() ? run.trajectory.times : run.response.times;
}

std::size_t nearest_step(const std::vector<double>& times, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - times.begin());
  if (after == times.end()) return times.size() - 1;
  return time - times[i - 1] <= times[i] - time ? i - 1 : i;
}

std::vector<std::size_t> kept_steps(const std::vector<double>& times, double rate,
                                    const std::vector<Moment>& moments) {
  constexpr double rounding = 1e-6;  // of a tick: the sum of many intervals is not quite the tick
  std::vector<std::size_t> kept;
  double last_tick = -1.0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double tick = std::floor((times[k] - times.front()) * rate + rounding);
    if (tick > last_tick) kept.push_back(k);
    last_tick = tick;
  }
  if (times.empty()) return kept;
  for (const Moment& moment : moments) kept.push_back(nearest_step(times, moment.time));
  kept.push_back(times.size() - 1);
  std::ranges::sort(kept);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace dougong::app
