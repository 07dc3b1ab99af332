#include "app/study/metrics.h"

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

using structures::Response;
using structures::StoreyResponse;

constexpr std::size_t per_storey = 3;  // metrics

double size_of(const structures::Envelope& envelope) {
  return std::abs(envelope.largest().value);
}

template <class Value>
double largest(const Response& response, Value value) {
  double most = 0.0;
  for (const StoreyResponse& storey : response.storeys)
    if (!storey.is_base) most = std::max(most, value(storey));
  return most;
}

double peak_drift(const StoreyResponse& storey) {
  return size_of(storey.peak_drift);
}
double residual_drift(const StoreyResponse& storey) {
  return std::abs(storey.residual_drift);
}
double peak_acceleration(const StoreyResponse& storey) {
  return size_of(storey.peak_acceleration);
}

double bonds(const RunResult& run, double DrawnBond::*when) {
  return static_cast<double>(std::ranges::count_if(
      run.model.bonded, [&](const DrawnBond& bond) { return bond.*when < DrawnBond::never; }));
}

}  // namespace

std::vector<Metric> metrics_of(const Response& r) {
  constexpr double never = std::numeric_limits<double>::quiet_NaN();
  std::vector<Metric> metrics{{"peak drift", "1", largest(r, peak_drift)},
                              {"residual drift", "1", largest(r, residual_drift)},
                              {"peak roof displacement", "m", size_of(r.peak_roof_displacement)},
                              {"peak floor acceleration", "m/s2", largest(r, peak_acceleration)},
                              {"peak base shear over weight", "1", size_of(r.peak_base_shear_ratio)},
                              {"fallen mass", "1", r.fallen_mass_fraction},
                              {"first loss of support", "s", r.first_loss_of_support.value_or(never)}};
  for (const StoreyResponse& storey : r.storeys) {
    metrics.push_back({storey.name + " peak drift", "1", peak_drift(storey)});
    metrics.push_back({storey.name + " residual drift", "1", residual_drift(storey)});
    metrics.push_back({storey.name + " peak floor acceleration", "m/s2", peak_acceleration(storey)});
  }
  return metrics;
}

std::vector<Metric> metrics_of(const RunResult& run) {
  std::vector<Metric> metrics = metrics_of(run.response);
  if (run.model.bonded.empty()) return metrics;
  const std::size_t whole = metrics.size() - per_storey * run.response.storeys.size();
  metrics.insert(metrics.begin() + static_cast<std::ptrdiff_t>(whole),
                 {{"cracked bonds", "bonds", bonds(run, &DrawnBond::cracked)},
                  {"crushed bonds", "bonds", bonds(run, &DrawnBond::crushed)},
                  {"broken bonds", "bonds", bonds(run, &DrawnBond::broken)}});
  return metrics;
}

}  // namespace dougong::app
