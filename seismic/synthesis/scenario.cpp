#include "seismic/synthesis/scenario.h"

#include <cmath>

namespace dougong::seismic {
namespace {

constexpr double km = 1000.0, MPa = 1e6;

std::vector<double> component(const Scenario& scenario, std::uint64_t number, double factor) {
  const auto count = static_cast<std::size_t>(std::llround(scenario.duration / scenario.interval));
  std::vector<double> sum(count, 0.0);
  for (std::size_t i = 0; i < scenario.patches.size(); ++i) {
    const std::uint64_t stream = 100 * number + i;
    const auto part =
        simulate(scenario.patches[i], scenario.region, scenario.interval, count, scenario.seed, stream);
    for (std::size_t k = 0; k < count; ++k) sum[k] += factor * part[k];
  }
  return sum;
}

}  // namespace

// A rupture that runs for 80 s along 270 km of the Longmen Shan; the site is about 30 km from its first
// third, so that the early patches dominate and the later ones are farther and farther away.
Scenario wenchuan_scenario() {
  Scenario s;
  s.id = "wenchuan-synthetic";
  s.alias = "wenchuan";
  s.title = "Wenchuan-style synthetic (Mw 7.9)";
  s.magnitude = 7.9;
  s.duration = 120.0;
  s.seed = 20080512;
  s.region = {2800.0, 3500.0, 274.6, 0.423, 0.03, {{1.0, -1.0}, {70.0, 0.0}, {130.0, -0.5}}, 1.5, 0.05};
  s.patches = {
      {7.2, 10.0 * MPa, 40.0 * km, 3.0},  {7.4, 10.0 * MPa, 24.0 * km, 14.0},
      {7.3, 10.0 * MPa, 30.0 * km, 29.0}, {7.4, 10.0 * MPa, 36.0 * km, 47.0},
      {7.3, 10.0 * MPa, 50.0 * km, 66.0},
  };
  return s;
}

// Five strong motion generation areas off Miyagi to Ibaraki; the site is on the coast of Miyagi, so that two
// bursts some 50 s apart stand out and the southern areas follow weakly.
Scenario tohoku_scenario() {
  Scenario s;
  s.id = "tohoku-synthetic";
  s.alias = "tohoku";
  s.title = "Tohoku-style synthetic (Mw 9.0)";
  s.magnitude = 9.0;
  s.duration = 200.0;
  s.seed = 20110311;
  s.region = {2800.0, 3900.0, 200.0, 0.6, 0.035, {{1.0, -1.0}}, 2.0, 0.05};
  s.patches = {
      {7.8, 41.0 * MPa, 80.0 * km, 12.0},   {7.7, 24.0 * MPa, 85.0 * km, 60.0},
      {7.9, 30.0 * MPa, 80.0 * km, 64.0},   {7.6, 16.0 * MPa, 160.0 * km, 110.0},
      {7.7, 26.0 * MPa, 220.0 * km, 126.0},
  };
  return s;
}

ThreeComponents simulate(const Scenario& scenario) {
  return {component(scenario, 1, 1.0), component(scenario, 2, 1.0),
          component(scenario, 3, scenario.vertical_ratio)};
}

}  // namespace dougong::seismic
