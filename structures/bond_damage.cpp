#include "structures/bond_damage.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/contact/contact_points.h"

namespace dougong::structures {
namespace {

using engine::BodyPair;

BodyPair pair_of(const engine::BondPoint& point) {
  return {std::min(point.a, point.b), std::max(point.a, point.b)};
}

/// Greatest normal force (N) of a contact between two bodies whose cracked face has a strength.
std::map<BodyPair, double> contact_forces(const engine::Model& model, const engine::State& state) {
  std::map<BodyPair, double> forces;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i)
    if (std::isfinite(model.bond_points[i].law.crushing) && !state.bonds.history[i].joined)
      forces[pair_of(model.bond_points[i])] = 0.0;
  if (forces.empty()) return forces;
  const auto frames = engine::frames_of(model, state);
  const engine::ContactPoints& points = state.contacts.points;
  for (const engine::ContactPair& pair : state.contacts.pairs()) {
    const auto bonded =
        forces.find({std::min(pair.bodies.a, pair.bodies.b), std::max(pair.bodies.a, pair.bodies.b)});
    if (!pair.active || bonded == forces.end()) continue;
    for (const std::size_t i : {pair.first_point, pair.first_point + 1})
      bonded->second = std::max(bonded->second, dot(engine::force_of(points, i, frames),
                                                    engine::geometry_of(points, i, frames).normal));
  }
  return forces;
}

std::string_view mode_of(const BondDamage& damage, const engine::BondHistory& first,
                         const engine::BondHistory& second) {
  if (first.sheared || second.sheared) return "shear";
  if (first.plastic != 0.0 || second.plastic != 0.0) return "yield";
  return damage.cracked ? "tension" : damage.crushed ? "crushing" : "";
}

}  // namespace

std::vector<BondDamage> bond_damage(const engine::Model& model, const engine::State& state) {
  const std::map<BodyPair, double> forces = contact_forces(model, state);
  std::vector<BondDamage> all(model.bond_points.size() / 2);
  for (std::size_t bond = 0; bond < all.size(); ++bond) {
    BondDamage& damage = all[bond];
    for (const std::size_t i : {2 * bond, 2 * bond + 1}) {
      const engine::BondPoint& point = model.bond_points[i];
      const auto pressed = forces.find(pair_of(point));
      damage.cracked |= engine::has_cracked(point.law, state.bonds.history[i]);
      damage.crushed |= state.bonds.history[i].crushed > 0.0;
      damage.crushed |= pressed != forces.end() && pressed->second > point.law.crushing;
    }
    const engine::BondHistory &first = state.bonds.history[2 * bond],
                              &second = state.bonds.history[2 * bond + 1];
    damage.broken = first.broken && second.broken;
    damage.mode = mode_of(damage, first, second);
  }
  return all;
}

}  // namespace dougong::structures
