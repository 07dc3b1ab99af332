// The earthquakes whose motion is shipped: patches of a fault, each a stochastic point source, summed at one
// site in the order in which their waves arrive.
//
// They are styled after five events, not copies of any recording: magnitude, patches, delays and attenuation
// are of the published order (docs/theory/seismic.md), the station is invented.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "seismic/synthesis/point_source.h"

namespace dougong::seismic {

struct Scenario {
  std::string id;     // "wenchuan-synthetic"
  std::string alias;  // "wenchuan"
  std::string title;
  double magnitude = 0.0;  // Mw of the whole
  double interval = 0.01;  // s
  double duration = 0.0;   // s
  std::uint64_t seed = 0;
  double vertical_ratio = 2.0 / 3.0;  // of the horizontal spectrum, m/s2 per m/s2
  Region region;
  std::vector<PointSource> patches;
};

Scenario wenchuan_scenario();
Scenario tohoku_scenario();
Scenario kobe_scenario();
Scenario chichi_scenario();
Scenario kocaeli_scenario();

struct ThreeComponents {
  std::vector<double> east_west, north_south, up_down;  // m/s2
};

/// Every component its own noise. Both horizontals have the same spectrum on average.
ThreeComponents simulate(const Scenario& scenario);

}  // namespace dougong::seismic
