// The earthquakes whose motion is shipped: patches of a fault, each a stochastic point source, summed at one
// site in the order in which their waves arrive; or a finite fault.
//
// They are styled after six events, not copies of any recording: magnitude, patches, delays and attenuation
// are of the published order (docs/theory/seismic.md), the station is invented.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "seismic/synthesis/finite_fault.h"
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
  std::optional<FiniteFault> fault = {};  // instead of patches
  SitePlace site = {};                    // of the fault
};

Scenario wenchuan_scenario();
Scenario tohoku_scenario();
Scenario kobe_scenario();
Scenario chichi_scenario();
Scenario kocaeli_scenario();
Scenario el_centro_scenario();
/// All of them, in the order in which they are shipped.
std::vector<Scenario> shipped_scenarios();

struct ThreeComponents {
  std::vector<double> east_west, north_south, up_down;  // m/s2
};

/// Every component its own noise. Both horizontals have the same spectrum on average.
ThreeComponents simulate(const Scenario& scenario);

}  // namespace dougong::seismic
