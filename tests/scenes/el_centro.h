// Comparisons C05 and C06: what is known of linear systems under El Centro 1940 N-S.
//
// Chopra, Dynamics of Structures, sections 6.4 and 13.2.6; "exact": the recursion of the record's straight
// lines.
#pragma once

#include <array>
#include <filesystem>

#include "seismic/read_record.h"
#include "tests/scenes/chain_run.h"

namespace dougong::scenes {

struct RecordedMotion {
  std::vector<double> acceleration;  // m/s2
  double interval = 0.0;             // s
};

/// Gravity of the tables (m/s2): C05 has 386.4 in/s2, C06 metric units.
inline constexpr double gravity_in_inches = 386.4 * 0.0254, gravity_in_metres = 9.81;

inline RecordedMotion el_centro(const std::filesystem::path& file, double gravity) {
  const seismic::Record record = seismic::read_channels(file).records.front();
  RecordedMotion motion{record.acceleration, record.interval};
  for (double& a : motion.acceleration) a *= gravity / 9.80665;
  return motion;
}

struct SingleDegreeCase {
  double period, ratio, published, exact;  // s, -, in, in

  std::vector<oracles::ChainLevel> level() const {
    const double mass = 1e4, w = 2.0 * std::numbers::pi / period;
    return {{.mass = mass, .stiffness = mass * w * w}};
  }
};
inline constexpr std::array<SingleDegreeCase, 5> single_degree_cases{{{0.5, 0.02, 2.67, 2.677},
                                                                      {1.0, 0.02, 5.97, 5.973},
                                                                      {2.0, 0.02, 7.47, 7.473},
                                                                      {2.0, 0.00, 9.91, 9.923},
                                                                      {2.0, 0.05, 5.37, 5.378}}};

inline const std::vector<oracles::ChainLevel> five_storeys(5, {.mass = 45e3, .stiffness = 54.82e5});
inline const std::vector<double> five_percent(5, 0.05);
inline constexpr std::array<double, 5> five_storey_drifts{58.95, 49.05, 41.28, 41.51, 28.37};  // mm

}  // namespace dougong::scenes
