#include "app/study/moments.h"

#include <algorithm>
#include <cmath>

#include "app/study/output_times.h"

namespace dougong::app {
namespace {

std::size_t largest_at(const std::vector<double>& values) {
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end(), by_size) - values.begin());
}

void add_strongest_shaking(const RunResult& r, std::vector<Moment>& moments) {
  if (r.motion.acceleration_x.empty()) return;
  const std::size_t strongest = largest_at(r.motion.acceleration_x);
  if (r.motion.acceleration_x[strongest] != 0.0)
    moments.push_back({r.motion.times[strongest], "strongest shaking"});
}

void add_peak_drift(const RunResult& r, std::vector<Moment>& moments) {
  const structures::StoreyResponse* worst = structures::storey_of_peak_drift(r.response);
  if (worst && worst->peak_drift.largest().value != 0.0)
    moments.push_back({worst->peak_drift.largest().time, "peak drift, " + worst->name});
}

void add_losses(const RunResult& r, std::vector<Moment>& moments) {
  if (r.response.first_loss_of_support)
    moments.push_back({*r.response.first_loss_of_support, "first loss of support"});
  if (r.collapse.no_return) moments.push_back({*r.collapse.no_return, "point of no return"});
  for (const auto& storey : r.response.storeys)
    if (storey.lost_at) moments.push_back({*storey.lost_at, storey.name + " lost"});
}

// Moments closer than this show the same picture (s); the caption that came first stays.
constexpr double same_moment = 0.05;

}  // namespace

std::vector<Moment> moments_of(const RunResult& result) {
  std::vector<Moment> moments;
  if (output_times(result).empty()) return moments;
  const double end = output_times(result).back();
  add_losses(result, moments);
  add_peak_drift(result, moments);
  add_strongest_shaking(result, moments);
  moments.push_back({end, "end"});
  std::erase_if(moments, [end](const Moment& m) { return m.time > end; });
  std::stable_sort(moments.begin(), moments.end(),
                   [](const Moment& a, const Moment& b) { return a.time < b.time; });
  const auto same = [](const Moment& a, const Moment& b) { return b.time - a.time < same_moment; };
  moments.erase(std::unique(moments.begin(), moments.end(), same), moments.end());
  return moments;
}

}  // namespace dougong::app
