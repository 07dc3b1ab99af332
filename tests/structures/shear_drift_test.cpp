// Drift without the rotation of the base: none for what only turns, all for what is only sheared.
#include "structures/shear_drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "structures/layouts/layout.h"
#include "tests/structures/scripted_run.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

// Every block goes with a body that turns about a point of the ground.
Script turned_about(Script script, Vec2 pivot, double angle) {
  const auto places = std::make_shared<std::map<std::string, Vec2>>();
  for (const engine::Body& body : script.building.scene.bodies) (*places)[body.name] = body.position;
  script.block = [=](const std::string& name, double t) {
    const double now = angle * std::min(1.0, t);
    const Vec2 arm = places->at(name) - pivot, moved = engine::rotated(arm, now) - arm;
    return Pose{moved.x, moved.y, now};
  };
  return script;
}

TEST(ShearDrift, OfAWallThatOnlyRocksIsNone) {
  for (const char* layout : {"brick-wall", "column", "four-storey"}) {
    Script script{.building = build_layout(layout)};
    const double angle = -0.01;
    const Response response = turned_about(script, {1.0, 0.0}, angle).response();
    for (const StoreyResponse& storey : response.storeys) {
      EXPECT_GT(storey.drift.back(), 0.4 * 0.01) << layout << ' ' << storey.name;
      EXPECT_NEAR(storey.shear_drift.back(), 0.0, 1e-4) << layout << ' ' << storey.name;
    }
  }
}

TEST(ShearDrift, OfAFrameWhoseFloorsDoNotTurnIsItsDrift) {
  Script script{.building = build_layout("four-storey")};
  script.block = [](const std::string& name, double t) {
    return name == "S2.slab" ? Pose{0.03 * std::min(1.0, t), 0, 0} : Pose{};
  };
  const Response response = script.response();
  for (const StoreyResponse& storey : response.storeys)
    for (std::size_t step = 0; step < storey.drift.size(); ++step)
      EXPECT_NEAR(storey.shear_drift[step], storey.drift[step], 1e-12) << storey.name;
  EXPECT_NEAR(response.storeys[1].peak_shear_drift.positive.value, 0.03 / 2.8, 1e-12);
}

// The first floor tilts and the storey above leans with it: that is no shear of the second storey.
TEST(ShearDrift, OfAStoreyTakesOffTheTurnOfTheLevelBelow) {
  Script script{.building = build_layout("four-storey")};
  const double tilt = 0.004, height = 2.8;
  script.block = [&](const std::string& name, double) {
    if (name == "S1.slab") return Pose{0, 0, tilt};
    return name == "S2.slab" ? Pose{-height * std::sin(tilt), 0, tilt} : Pose{};
  };
  // The first output time is the start: it must stand as described.
  const auto moved = script.block;
  script.block = [=](const std::string& name, double t) { return t > 0.0 ? moved(name, t) : Pose{}; };
  const Response response = script.response();
  EXPECT_NEAR(response.storeys[1].drift.back(), -std::sin(tilt), 1e-9);
  EXPECT_NEAR(response.storeys[1].shear_drift.back(), 0.0, 1e-9);
}

TEST(ShearDrift, IsKeptFromTheLossOn) {
  Script script{.building = build_layout("four-storey")};
  script.block = [](const std::string& name, double t) {
    return name.starts_with("S4.slab") ? Pose{0.02 * t, t > 2.0 ? -3.0 : 0.0, 0} : Pose{};
  };
  const StoreyResponse top = script.response().storeys[3];
  ASSERT_TRUE(top.lost_at);
  EXPECT_EQ(top.shear_drift.back(), top.shear_drift[top.shear_drift.size() / 2]);
}

}  // namespace
}  // namespace dougong::structures
