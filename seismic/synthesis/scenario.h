// The earthquakes whose motion is shipped: ruptures that run over one or several planes, seen from one site.
//
// They are styled after six events, not copies of any recording: planes, hypocentres, delays, asperities and
// attenuation are of the published order (docs/records.md says where they come from and how near the motions
// come to what was observed), the station is invented.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "seismic/record.h"
#include "seismic/synthesis/finite_fault.h"

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
  std::optional<Place> hypocentre;  // of the event; where it is given, the map is from the epicentre
  std::vector<RupturePlane> planes;
  SitePlace site;  // on the same map
};

Scenario wenchuan_scenario();
Scenario tohoku_scenario();
Scenario kobe_scenario();
Scenario chichi_scenario();
Scenario kocaeli_scenario();
Scenario el_centro_scenario();
/// All of them, in the order in which they are shipped.
std::vector<Scenario> shipped_scenarios();

/// Of the site from the nearest centre of a subfault, m.
double closest_distance(const Scenario& scenario);

struct ThreeComponents {
  std::vector<double> east_west, north_south, up_down;  // m/s2
};

/// Every component its own noise. Both horizontals have the same spectrum on average.
ThreeComponents simulate(const Scenario& scenario);

}  // namespace dougong::seismic
