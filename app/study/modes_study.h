// The small-amplitude modes of a building at rest: periods, the mass that moves with each, their shapes.
#pragma once

#include "app/study/prepare.h"

namespace dougong::app {

struct ModesResult {
  ModelSheet model;
  structures::Building building;
  engine::SettleReport settle;
  std::vector<engine::Mode> modes;  // in order of frequency; without any where it did not settle
};

/// Settles the building under its weight first. Throws ModelError.
ModesResult modes_of(const Scenario& scenario, std::size_t count);

/// Largest magnitude of the horizontal part of a shape, 1 for a shape without.
double horizontal_size(const engine::Mode& mode, std::size_t blocks);

}  // namespace dougong::app
