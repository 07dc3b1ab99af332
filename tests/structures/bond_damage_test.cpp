#include "structures/bond_damage.h"

#include <gtest/gtest.h>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::structures {
namespace {

using scenes::Running;

// A block of 1 m3 on its bonded bed.
engine::Scene on_its_bed(double strength) {
  engine::Scene s = scenes::scene(0.9, 1e9);
  s.bodies.push_back(scenes::block(0.5, 0.5, {0.0, 0.5}));
  s.terrains.push_back(scenes::ground());
  engine::Bond bed;
  bed.name = "bed";
  bed.a = {true, 0}, bed.b = {false, 0};
  bed.start = {-0.5, 0.0}, bed.end = {0.5, 0.0};
  bed.compressive_strength = strength;
  bed.damping_ratio = 1.0;
  s.bonds.push_back(bed);
  return s;
}

engine::DriveOptions run_for(double time) {
  engine::DriveOptions options;
  options.end_time = time;
  return options;
}

BondDamage damage_of(const Running& r) {
  return bond_damage(r.model, r.state).at(0);
}

constexpr double stress = 2400.0 * 9.81;  // Pa, of the weight on the bed

TEST(BondDamage, IsCrushingWhereASoundFaceYieldsInCompression) {
  Running stands(on_its_bed(1.5 * stress)), sinks(on_its_bed(0.9 * stress));
  engine::settle(stands.model, stands.state);
  EXPECT_EQ(damage_of(stands).mode, "");
  sinks.run(run_for(0.05));
  EXPECT_EQ(damage_of(sinks).mode, "crushing");
  EXPECT_TRUE(damage_of(sinks).crushed);
  EXPECT_FALSE(damage_of(sinks).cracked);
}

// Torn off and set down again: each corner bears half of the weight, and when the block is about to turn over
// nearly all of it.
TEST(BondDamage, TellsWhereAContactOfACrackedFaceBearsMoreThanItsHalf) {
  engine::Scene s = on_its_bed(1.5 * stress);
  s.bonds[0].tensile_strength = 1e3;
  Running r(s);
  r.model.gravity.y = 9.81;
  r.run(run_for(0.02));
  ASSERT_EQ(r.state.bonds.broken, 2u);
  r.model.gravity.y = -9.81;
  r.run(run_for(2.0));
  EXPECT_EQ(damage_of(r).mode, "tension");
  EXPECT_FALSE(damage_of(r).crushed) << "half of the weight is below the 0.75 of it that half the face bears";
  r.model.gravity.x = 0.7 * 9.81;
  r.run(run_for(1.0));
  EXPECT_LT(std::abs(r.angle()), 0.01) << "it stands";
  EXPECT_TRUE(damage_of(r).crushed) << "0.85 of the weight on one corner";
}

}  // namespace
}  // namespace dougong::structures
