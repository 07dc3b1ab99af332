// What the bonds of a building have suffered: which have left their elastic range, and how.
//
// A face without a crack crushes by the law of its points (engine/bonds/bond_law.h). Once it has cracked, its
// contacts bear the compression and know no strength: there the normal force N of every contact between the
// two bodies is held against the strength of the half face that a contact at its end stands for,
//
//   N > f_c A/2
//
// A the bonded area (m2). That is noted as crushing and changes no motion.
#pragma once

#include <string_view>
#include <vector>

#include "engine/state.h"

namespace dougong::structures {

struct BondDamage {
  bool cracked = false;   // a point broke, softened or yielded
  bool crushed = false;   // a point yielded in compression, or a contact of the cracked face bears too much
  bool broken = false;    // both points
  std::string_view mode;  // "tension", "shear", "yield", "crushing"; empty while sound
};

/// One a bond, in the scene's order.
std::vector<BondDamage> bond_damage(const engine::Model& model, const engine::State& state);

}  // namespace dougong::structures
