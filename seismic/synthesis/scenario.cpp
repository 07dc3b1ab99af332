#include "seismic/synthesis/scenario.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr double km = 1000.0, MPa = 1e6, degree = two_pi / 360.0;

constexpr double lead = 1.0;  // s of rest before the first arrival

// So far along an azimuth, and to the right of it.
SitePlace place_along(double azimuth, double along, double right) {
  return {along * std::sin(azimuth) + right * std::cos(azimuth),
          along * std::cos(azimuth) - right * std::sin(azimuth)};
}

// A plane whose hypocentre (f.hypocentre_along, f.hypocentre_down) lies at a place of the map and a depth.
RupturePlane through(FiniteFault f, const SitePlace& epicentre, double depth, double onset) {
  const double down = f.hypocentre_down * f.width;
  const SitePlace off = place_along(f.strike, f.hypocentre_along * f.length, down * std::cos(f.dip));
  f.top_depth = std::max(0.0, depth - down * std::sin(f.dip));
  return {f, {epicentre.east - off.east, epicentre.north - off.north}, onset};
}

std::vector<double> component(const Scenario& s, std::uint64_t number, double factor) {
  const auto count = static_cast<std::size_t>(std::llround(s.duration / s.interval));
  std::vector<double> a = simulate(s.planes, s.region, s.site, s.interval, lead, s.seed, number, count);
  for (double& value : a) value *= factor;
  return a;
}

}  // namespace

// Two planes after Tong et al. (2010, J. Geophys. Res. 115) and Koketsu's geometry: a thrust of 150 x 40 km,
// then 150 x 25 km that slant and slip sideways, the moment shared by area. The rupture starts 25 km from the
// southwestern end and runs northeast; at 0.8 beta it meets the subevents of the joint inversions when they
// do: Yingxiu from 4 s on, Beichuan at 43 s, Nanba at 63 s, Qingchuan at 80 s. The site is on the footwall,
// 11 km from the nearest slip and half way from the hypocentre to Beichuan, so that two phases are strong.
Scenario wenchuan_scenario() {
  Scenario s;
  s.id = "wenchuan-synthetic";
  s.alias = "wenchuan";
  s.title = "Wenchuan-style synthetic (Mw 7.9)";
  s.magnitude = 7.9;
  s.duration = 120.0;
  s.seed = 20080512;
  s.hypocentre = {31.014, 103.391, -14.0 * km};
  s.region = {2800.0, 3500.0, 274.6, 0.423, 0.03, {{1.0, -1.0}, {70.0, 0.0}, {130.0, -0.5}}, 1.5, 0.05};
  FiniteFault thrust;
  thrust.magnitude = 7.77;
  thrust.stress_drop = 10.0 * MPa;
  thrust.length = 150.0 * km, thrust.width = 40.0 * km;
  thrust.strike = 229.0 * degree, thrust.dip = 33.0 * degree;  // along is from the northeast
  thrust.subfault_length = thrust.subfault_width = 5.0 * km;
  thrust.hypocentre_along = 125.0 / 150.0, thrust.hypocentre_down = 0.64;
  thrust.slip = SlipModel::random;
  thrust.asperities = {{95.0 * km, 12.5 * km, 40.0 * km, 25.0 * km, 3.0},   // Yingxiu
                       {15.0 * km, 12.5 * km, 30.0 * km, 25.0 * km, 3.0}};  // Beichuan
  FiniteFault slanting = thrust;
  slanting.magnitude = 7.63;
  slanting.width = 25.0 * km, slanting.dip = 65.0 * degree;
  slanting.hypocentre_along = 1.0, slanting.hypocentre_down = 0.5;
  slanting.asperities = {{99.0 * km, 12.5 * km, 30.0 * km, 20.0 * km, 3.0},   // Nanba
                         {51.0 * km, 12.5 * km, 30.0 * km, 20.0 * km, 2.0}};  // Qingchuan
  const double azimuth = 49.0 * degree, run = 125.0 * km;
  const SitePlace end = place_along(azimuth, run, 21.5 * km);  // of the thrust, at the surface
  s.planes = {through(thrust, {}, 14.0 * km, 0.0),
              through(slanting, end, 11.0 * km, run / (thrust.rupture_ratio * s.region.shear_velocity))};
  s.site = place_along(azimuth, 75.0 * km, 30.0 * km);
  return s;
}

// The five strong motion generation areas of Kurahashi & Irikura (2011, Earth Planets Space 63): sizes,
// moments, stress drops and delays as remembered from their table, places to some 20 km from their map; the
// rest of the plate boundary, which sent little above 0.1 Hz, is left out. Q, kappa and the factor for soil
// softer than the table's are set for the bias of PGV and PSa at 1 s at fourteen stations (docs/records.md),
// not published. The site is on the coast of Miyagi, where the first area and the third make two bursts, 50 s
// apart.
Scenario tohoku_scenario() {
  Scenario s;
  s.id = "tohoku-synthetic";
  s.alias = "tohoku";
  s.title = "Tohoku-style synthetic (Mw 9.0)";
  s.magnitude = 9.0;
  s.duration = 200.0;
  s.seed = 20110311;
  s.hypocentre = {38.1035, 142.861, -23.7 * km};
  s.region = {2800.0, 3900.0, 400.0, 0.6, 0.03, {{1.0, -1.0}}, 1.4, 0.05, SiteTable::japan_500};
  struct Area {
    double size, moment, stress_drop, onset, east, north, depth;  // km, N m, MPa, s, km, km, km
  };
  constexpr Area areas[] = {{36.0, 2.68e20, 41.3, 15.6, -62.0, 38.0, 38.0},
                            {23.0, 1.41e20, 23.9, 66.4, -45.0, 94.0, 40.0},
                            {42.5, 6.54e20, 29.5, 68.4, -71.0, 22.0, 40.0},
                            {25.5, 1.24e20, 16.4, 109.7, -115.0, -84.0, 42.0},
                            {38.5, 5.75e20, 26.0, 118.2, -150.0, -161.0, 42.0}};
  for (const Area& a : areas) {
    FiniteFault f;
    f.magnitude = moment_magnitude(a.moment);
    f.stress_drop = a.stress_drop * MPa;
    f.length = f.width = a.size * km;
    f.strike = 193.0 * degree, f.dip = 10.0 * degree;
    f.subfault_length = f.subfault_width = 5.0 * km;
    f.slip = SlipModel::random;
    s.planes.push_back(through(f, {a.east * km, a.north * km}, a.depth * km, a.onset));
  }
  s.site = {-138.4 * km, 36.0 * km};
  return s;
}

// Bilateral along Awaji and under Kobe, 59 x 20 km (the planes of Wald 1996 in one); the site is 3 km beside
// the plane, 20 km towards Kobe.
Scenario kobe_scenario() {
  Scenario s;
  s.id = "kobe-synthetic";
  s.alias = "kobe";
  s.title = "Kobe-style synthetic (Mw 6.9)";
  s.magnitude = 6.9;
  s.duration = 45.0;
  s.seed = 19950117;
  s.hypocentre = {34.583, 135.018, -16.0 * km};
  s.region = {2800.0, 3500.0, 150.0, 0.7, 0.04, {{1.0, -1.0}, {70.0, 0.0}}, 1.5, 0.05};
  FiniteFault f;
  f.magnitude = s.magnitude;
  f.stress_drop = 8.0 * MPa;
  f.length = 59.0 * km, f.width = 20.0 * km;
  f.strike = 51.0 * degree, f.dip = 85.0 * degree;
  f.subfault_length = f.subfault_width = 3.0 * km;
  f.hypocentre_along = 20.0 / 59.0, f.hypocentre_down = 0.8;
  f.slip = SlipModel::random;
  s.planes = {through(f, {}, 16.0 * km, 0.0)};
  s.site = place_along(f.strike, 20.0 * km, -3.0 * km);
  return s;
}

// The plane of Johnson et al. (2001), a thrust that breaks northwards and slips most in the north; the site
// is on the footwall beside it.
Scenario chichi_scenario() {
  Scenario s;
  s.id = "chichi-synthetic";
  s.alias = "chichi";
  s.title = "Chi-Chi-style synthetic (Mw 7.6)";
  s.magnitude = 7.6;
  s.duration = 80.0;
  s.seed = 19990921;
  s.hypocentre = {23.869, 120.840, -8.8 * km};
  s.region = {2800.0, 3500.0, 117.0, 0.77, 0.05, {{1.0, -1.0}, {50.0, 0.0}}, 1.5, 0.05};
  FiniteFault f;
  f.magnitude = 7.58;
  f.stress_drop = 8.0 * MPa;
  f.length = 103.6 * km, f.width = 30.0 * km;
  f.strike = 5.0 * degree, f.dip = 23.0 * degree;
  f.subfault_length = f.subfault_width = 5.0 * km;
  f.hypocentre_along = 0.3, f.hypocentre_down = 0.75;
  f.slip = SlipModel::random;
  f.asperities = {{82.0 * km, 12.5 * km, 35.0 * km, 25.0 * km, 3.0}};
  s.planes = {through(f, {}, 8.8 * km, 0.0)};
  s.site = place_along(f.strike, 25.0 * km, -27.0 * km);
  return s;
}

// Strike-slip, bilateral over 140 km; the site is 11 km from the eastern end, so that the near part comes
// last.
Scenario kocaeli_scenario() {
  Scenario s;
  s.id = "kocaeli-synthetic";
  s.alias = "kocaeli";
  s.title = "Kocaeli-style synthetic (Mw 7.5)";
  s.magnitude = 7.5;
  s.duration = 60.0;
  s.seed = 19990817;
  s.hypocentre = {40.73, 29.88, -16.0 * km};
  s.region = {2800.0, 3500.0, 180.0, 0.6, 0.05, {{1.0, -1.0}, {60.0, 0.0}}, 1.8, 0.05};
  FiniteFault f;
  f.magnitude = s.magnitude;
  f.stress_drop = 8.0 * MPa;
  f.length = 140.0 * km, f.width = 20.0 * km;
  f.strike = 90.0 * degree, f.dip = 85.0 * degree;
  f.subfault_length = f.subfault_width = 5.0 * km;
  f.hypocentre_along = 0.4, f.hypocentre_down = 0.8;
  f.slip = SlipModel::random;
  s.planes = {through(f, {}, 16.0 * km, 0.0)};
  s.site = {90.0 * km, 8.0 * km};
  return s;
}

// The Imperial fault, 63 x 13 km, breaks from its middle; the site is 6 km beside it, on its soft valley. The
// map begins at the fault's end.
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
  f.dip = 80.0 * degree;
  f.subfault_length = f.subfault_width = 3.0 * km;
  f.slip = SlipModel::random;
  s.planes = {{f, {}, 0.0}};
  s.site = {-6.0 * km, 43.0 * km};
  return s;
}

std::vector<Scenario> shipped_scenarios() {
  return {wenchuan_scenario(), tohoku_scenario(),  kobe_scenario(),
          chichi_scenario(),   kocaeli_scenario(), el_centro_scenario()};
}

double closest_distance(const Scenario& s) {
  double least = std::numeric_limits<double>::infinity();
  for (const RupturePlane& plane : s.planes) {
    const SitePlace site{s.site.east - plane.corner.east, s.site.north - plane.corner.north};
    least = std::min(least, closest_distance(subfaults(plane.fault, s.region, site, s.seed)));
  }
  return least;
}

ThreeComponents simulate(const Scenario& scenario) {
  return {component(scenario, 1, 1.0), component(scenario, 2, 1.0),
          component(scenario, 3, scenario.vertical_ratio)};
}

}  // namespace dougong::seismic
