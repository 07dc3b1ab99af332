#include "app/study/floor_spectra.h"

#include <algorithm>
#include <span>

#include "seismic/measures/response_spectrum.h"

namespace dougong::app {
namespace {

constexpr double longest = 10.0;  // s
constexpr std::size_t count = 101;

std::span<const double> before_loss(const structures::StoreyResponse& storey,
                                    const std::vector<double>& times) {
  const auto lost = storey.lost_at ? std::ranges::lower_bound(times, *storey.lost_at) : times.end();
  return std::span(storey.floor_acceleration).first(static_cast<std::size_t>(lost - times.begin()));
}

}  // namespace

FloorSpectra floor_spectra(const RunResult& run) {
  FloorSpectra spectra;
  const auto& times = run.response.times;
  if (times.size() < 3 || run.motion.acceleration_x.empty()) return spectra;
  const double interval = times[1] - times[0];
  const double shortest = std::max(0.02, 10.0 * interval);
  if (shortest >= longest) return spectra;
  spectra.periods = seismic::log_spaced_periods(shortest, longest, count);
  spectra.ground =
      seismic::pseudo_accelerations(run.motion.acceleration_x, run.motion.interval, spectra.periods);
  for (const auto& storey : run.response.storeys) {
    if (storey.floor_acceleration.size() != times.size()) continue;
    const auto history = before_loss(storey, times);
    if (history.size() > 2)
      spectra.floors.push_back(
          {storey.name, seismic::pseudo_accelerations(history, interval, spectra.periods)});
  }
  return spectra;
}

}  // namespace dougong::app
