#include "seismic/synthesis/scenario.h"

#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr double km = 1000.0, MPa = 1e6;

constexpr double lead = 1.0;  // s of rest before the first arrival from a fault

std::vector<double> of_fault(const Scenario& s, std::uint64_t number, double factor, std::size_t count) {
  std::vector<double> a = simulate(*s.fault, s.region, s.site, s.interval, lead, s.seed, number, s.duration);
  a.resize(count, 0.0);
  for (double& value : a) value *= factor;
  return a;
}

std::vector<double> component(const Scenario& scenario, std::uint64_t number, double factor) {
  const auto count = static_cast<std::size_t>(std::llround(scenario.duration / scenario.interval));
  if (scenario.fault) return of_fault(scenario, number, factor, count);
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

// Bilateral along Awaji and under Kobe, 60 km in some 15 s: three patches, the site 8 km from the middle one.
Scenario kobe_scenario() {
  Scenario s;
  s.id = "kobe-synthetic";
  s.alias = "kobe";
  s.title = "Kobe-style synthetic (Mw 6.9)";
  s.magnitude = 6.9;
  s.duration = 45.0;
  s.seed = 19950117;
  s.region = {2800.0, 3500.0, 150.0, 0.7, 0.04, {{1.0, -1.0}, {70.0, 0.0}}, 1.9, 0.05};
  s.patches = {{6.4, 10.0 * MPa, 12.0 * km, 4.0},
               {6.6, 10.0 * MPa, 8.0 * km, 7.0},
               {6.3, 10.0 * MPa, 15.0 * km, 12.0}};
  return s;
}

// A thrust that breaks northwards for 30 s along 100 km; the site is on the footwall, 15 km from the slip in
// the north.
Scenario chichi_scenario() {
  Scenario s;
  s.id = "chichi-synthetic";
  s.alias = "chichi";
  s.title = "Chi-Chi-style synthetic (Mw 7.6)";
  s.magnitude = 7.6;
  s.duration = 80.0;
  s.seed = 19990921;
  s.region = {2800.0, 3500.0, 117.0, 0.77, 0.05, {{1.0, -1.0}, {50.0, 0.0}}, 1.8, 0.05};
  s.patches = {{6.9, 6.0 * MPa, 45.0 * km, 6.0},
               {7.0, 6.0 * MPa, 28.0 * km, 15.0},
               {7.2, 6.0 * MPa, 15.0 * km, 25.0},
               {7.0, 6.0 * MPa, 25.0 * km, 36.0}};
  return s;
}

// Strike-slip, bilateral over 140 km; the site is 12 km from the eastern end, so that the near patches come
// late and fast.
Scenario kocaeli_scenario() {
  Scenario s;
  s.id = "kocaeli-synthetic";
  s.alias = "kocaeli";
  s.title = "Kocaeli-style synthetic (Mw 7.5)";
  s.magnitude = 7.5;
  s.duration = 60.0;
  s.seed = 19990817;
  s.region = {2800.0, 3500.0, 180.0, 0.6, 0.05, {{1.0, -1.0}, {60.0, 0.0}}, 1.8, 0.05};
  s.patches = {
      {7.1, 5.0 * MPa, 60.0 * km, 4.0}, {7.0, 5.0 * MPa, 35.0 * km, 13.0}, {6.8, 5.0 * MPa, 14.0 * km, 21.0}};
  return s;
}

// The Imperial fault, 63 x 13 km, breaks from its middle; the site is 6 km beside it, on its soft valley.
Scenario el_centro_scenario() {
  Scenario s;
  s.id = "elcentro-synthetic";
  s.alias = "elcentro";
  s.title = "El Centro-style synthetic (Mw 6.95)";
  s.magnitude = 6.95;
  s.duration = 40.0;
  s.seed = 19400518;
  s.region.kappa = 0.05;
  s.region.site_factor = 1.5;
  FiniteFault f;
  f.magnitude = s.magnitude;
  f.stress_drop = 5.0 * MPa;
  f.length = 63.0 * km, f.width = 13.0 * km;
  f.dip = 80.0 * two_pi / 360.0;
  f.subfault_length = f.subfault_width = 3.0 * km;
  f.slip = SlipModel::random;
  s.fault = f;
  s.site = {-6.0 * km, 43.0 * km};
  return s;
}

std::vector<Scenario> shipped_scenarios() {
  return {wenchuan_scenario(), tohoku_scenario(),  kobe_scenario(),
          chichi_scenario(),   kocaeli_scenario(), el_centro_scenario()};
}

ThreeComponents simulate(const Scenario& scenario) {
  return {component(scenario, 1, 1.0), component(scenario, 2, 1.0),
          component(scenario, 3, scenario.vertical_ratio)};
}

}  // namespace dougong::seismic
