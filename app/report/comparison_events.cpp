#include "app/report/comparison_events.h"

#include <algorithm>
#include <cmath>

#include "app/report/text.h"
#include "app/study/output_times.h"

namespace dougong::app {
namespace {

constexpr double least_gap = 0.03;  // of the duration, between two moments
constexpr double near = 0.05;       // s, of a moment that has a name

double end_of(const RunResult& run) {
  return run.trajectory.times.empty() ? 0.0 : run.trajectory.times.back();
}

// Those of all runs, the more telling first.
std::vector<double> candidates(const std::vector<RunResult>& runs) {
  std::vector<double> times{0.0};
  for (const RunResult& run : runs) times.push_back(end_of(run));
  for (const char* what : {"first loss of support", "peak drift", "strongest shaking"})
    for (const RunResult& run : runs)
      for (const Moment& moment : run.moments)
        if (moment.caption.starts_with(what)) times.push_back(moment.time);
  return times;
}

// told: an earlier picture shows the end.
std::string caption_at(const RunResult& run, double time, bool told) {
  if (time > end_of(run) + near) return told ? "the run has ended" : "end";
  std::string caption;
  for (const Moment& moment : run.moments)
    if (std::abs(moment.time - time) <= near) caption += (caption.empty() ? "" : "; ") + moment.caption;
  return caption;
}

}  // namespace

std::vector<double> common_moments(const std::vector<RunResult>& runs, std::size_t most) {
  double end = 0.0;
  for (const RunResult& run : runs) end = std::max(end, end_of(run));
  std::vector<double> chosen;
  for (const double time : candidates(runs)) {
    const bool apart =
        std::ranges::all_of(chosen, [&](double other) { return std::abs(other - time) >= least_gap * end; });
    if (apart && chosen.size() < most) chosen.push_back(time);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<Frame> frames_at(const RunResult& run, const std::vector<double>& times) {
  std::vector<Frame> frames;
  if (run.trajectory.times.empty()) return frames;
  for (const double time : times) {
    const std::size_t step = nearest_step(run.trajectory.times, time);
    const bool told = !frames.empty() && frames.back().step == step;
    frames.push_back({step, run.trajectory.times[step], caption_at(run, time, told)});
  }
  return frames;
}

SceneView common_view(const std::vector<RunResult>& runs, const std::vector<double>& times) {
  SceneView common;
  bool first = true;
  for (const RunResult& run : runs) {
    const std::vector<Frame> frames = frames_at(run, times);
    if (frames.empty()) continue;
    const SceneView view = view_of(run, frames);
    if (first) common = view;
    first = false;
    common.box.low = {std::min(common.box.low.x, view.box.low.x), std::min(common.box.low.y, view.box.low.y)};
    common.box.high = {std::max(common.box.high.x, view.box.high.x),
                       std::max(common.box.high.y, view.box.high.y)};
    common.magnification = std::min(common.magnification, view.magnification);
    common.largest = std::max(common.largest, view.largest);
  }
  return common;
}

}  // namespace dougong::app
