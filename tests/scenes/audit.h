// A run and what would be wrong with it: motion that is not finite, energy out of nothing, bodies inside each
// other.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/scenes/running.h"

namespace dougong::scenes {

struct Audit {
  engine::RunOutcome run;
  bool finite = true;
  double energy_error = 0.0;   // greatest, over the energy turned over (EnergyTurnover)
  double energy_gained = 0.0;  // greatest rise of kinetic, potential and stored energy less the input,
                               // likewise: a loss that the ledger books below zero shows here
  double deepest = 0.0;        // overlap over the smaller width

  bool completed() const { return run.outcome == engine::Outcome::completed; }
};

/// What the ground put in and what has not been lost yet (J).
inline double mechanical(const engine::Energies& e) {
  return e.kinetic - e.stagger + e.gravity + e.field + e.elastic - e.input;
}

inline Audit audited(Running& r, const engine::DriveOptions& options) {
  Audit audit;
  engine::EnergyTurnover turnover;
  const engine::Energies start = r.energies();
  double gained = 0.0;
  audit.run = r.run(options, [&](const engine::Sample& sample) {
    const engine::Energies now = r.energies();
    turnover.note(now);
    gained = std::max(gained, mechanical(now) - mechanical(start));
    for (const double a : sample.accelerations) audit.finite &= std::isfinite(a);
    return engine::Wish::go_on;
  });
  for (const double y : r.state.y) audit.finite &= std::isfinite(y);
  const double scale = std::max(turnover.turnover(), start.agitation);
  audit.energy_error = turnover.relative_error();
  audit.energy_gained = scale > 0.0 ? gained / scale : 0.0;
  audit.deepest = r.state.deepest_ratio;
  return audit;
}

}  // namespace dougong::scenes
