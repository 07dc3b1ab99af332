// Hall, pagoda and timber frame.
#include <cmath>
#include <numbers>

#include "structures/collapse_multiplier.h"
#include "tests/engine/reference.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

TEST(DougongHall, StandsAndSettles) {
  for (const double tiers : {1.0, 2.0, 4.0}) {
    Built built("dougong-hall", {{"bracket_tiers", tiers}});
    expect_no_findings(built.building);
    expect_settles(built, 5e-3);
    EXPECT_EQ(built.building.scene.bodies.size(),
              4 * 2 + 3 + 4 * (1 + 4 * static_cast<std::size_t>(tiers)) + 2);
  }
}

/// Columns that rock with the roof on them, lintels turning freely: the pile bears on the column's head over
/// the foot of the cap block, lambda = sum of weight times its way to the edge over weight times its height.
double rocking_multiplier(const Building& building, double cap_foot) {
  double load = 0.0, columns = 0.0, lintels = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) {
    const std::string& name = building.scene.bodies[i].name;
    const double mass = mass_of(building, i);
    if (name.starts_with("column"))
      columns += mass;
    else if (name.starts_with("lintel"))
      lintels += mass;
    else if (!name.starts_with("base"))
      load += mass;
  }
  const double b = 0.45, h = 3.6, lintel_height = h - 0.18;
  return (load * 0.5 * (b + cap_foot) + (columns + lintels) * 0.5 * b) /
         (load * h + columns * 0.5 * h + lintels * lintel_height);
}

TEST(DougongHall, RocksOnItsColumns) {
  const Building building =
      build_layout("dougong-hall", {{"tenon_stiffness", 0.0}, {"friction", 0.6}, {"bays", 1}});
  const double multiplier = rocking_multiplier(building, 0.75 * 0.52);
  TrialOptions options;
  options.away = 0.6;  // of the smallest block, 0.1 m: the pile gives by a few millimetres
  options.hold_time = 2.0;
  Built built(building);
  for (const double part : {0.6, 0.93})
    EXPECT_EQ(hold(tilted(building.scene, part * multiplier), built.state, options).result,
              TrialResult::stands);
  EXPECT_EQ(hold(tilted(building.scene, 1.05 * multiplier), built.state, options).result, TrialResult::falls);
}

TEST(DougongHall, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal("dougong-hall", {{"bay_width", 1.2}}), HasSubstr("room for the longest arms"));
  EXPECT_THAT(refusal("dougong-hall", {{"arm_length", 0.6}}), HasSubstr("three bearing blocks"));
  EXPECT_THAT(refusal("dougong-hall", {{"base_width", 0.4}}), HasSubstr("base_width"));
  EXPECT_THAT(refusal("dougong-hall", {{"lintel_depth", 4.0}}), HasSubstr("lintel_depth"));
}

TEST(Pagoda, StandsAndSettles) {
  for (const double storeys : {1.0, 5.0, 7.0}) {
    Built built("pagoda", {{"storeys", storeys}});
    expect_no_findings(built.building);
    expect_settles(built, 5e-3);
    EXPECT_EQ(built.building.storeys.size(), static_cast<std::size_t>(storeys));
  }
}

// Its columns bear on the roofs below with the widths of column and cap: one storey rocks as a frame of
// columns does, at width over height, a cap turning with the column or staying with the roof.
TEST(Pagoda, OfOneStoreyRocksAtItsColumnsSlenderness) {
  const Building building =
      build_layout("pagoda", {{"storeys", 1}, {"finial_height", 0.0}, {"friction", 0.7}});
  const double slenderness = 0.45 / 2.4;
  TrialOptions options;
  options.hold_time = 2.0;
  Built built(building);
  for (const double part : {0.6, 0.95})
    EXPECT_EQ(hold(tilted(building.scene, part * slenderness), built.state, options).result,
              TrialResult::stands);
  EXPECT_EQ(hold(tilted(building.scene, 1.05 * slenderness), built.state, options).result,
            TrialResult::falls);
}

TEST(Pagoda, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal("pagoda", {{"taper_ratio", 0.95}, {"storeys", 8}}), HasSubstr("taper_ratio"));
  EXPECT_THAT(refusal("pagoda", {{"eave_overhang", 0.3}}), HasSubstr("eave_overhang"));
  EXPECT_THAT(refusal("pagoda", {{"finial_width", 1.0}}), HasSubstr("finial_width"));
}

// Rigid posts on free feet, beams that stay level: K = 2 (n - 1) k_r/h2, and the weight takes W/h off it.
TEST(TimberFrame, SwaysAsItsJointsTurn) {
  const ParameterMap values{{"storeys", 1}, {"young_modulus", 1e12}, {"joint_stiffness", 100e3}};
  const Building building = build_layout("timber-frame", values);
  const Built built = weightless(building);
  // Turning of the posts moves the beams' axis, at 2.548 m; their ends lie half a post off its axis, so that
  // the beams take up (1 + post/clear) of it.
  const double height = 2.7 - 0.002 - 0.15, factor = 1.0 + 0.18 / (3.0 - 0.18);
  const double stiffness = 6 * 100e3 * factor * factor / (height * height);
  const std::vector<std::size_t> beams = building.storeys[0].level_blocks;
  dougong::testing::expect_relative("layout", "sway stiffness of a timber frame", stiffness,
                                    1.0 / built.flexibility(beams), 0.02);
  double mass = 0.0;
  for (const std::size_t i : beams) mass += mass_of(building, i);
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i)
    if (building.scene.bodies[i].name.find("post") != std::string::npos) mass += mass_of(building, i) / 3.0;
  dougong::testing::expect_relative("layout", "period of a timber frame",
                                    2.0 * std::numbers::pi * std::sqrt(mass / stiffness),
                                    built.first_period(), 0.02);
}

TEST(TimberFrame, StandsInEveryKindOfJointAndBrace) {
  const std::string frame = "timber-frame";
  for (const char* joints : {"semi-rigid", "pinned"})
    for (const char* bracing : {"none", "knee-braces", "diagonals"}) {
      const ParameterMap values{{"joints", word(frame, "joints", joints)},
                                {"bracing", word(frame, "bracing", bracing)}};
      if (std::string(joints) == "pinned" && std::string(bracing) == "none") {
        EXPECT_THAT(refusal(frame, values), HasSubstr("a mechanism else"));
        continue;
      }
      Built built(frame, values);
      expect_no_findings(built.building);
      expect_settles(built, 5e-3);
    }
}

TEST(TimberFrame, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal("timber-frame", {{"bay_width", 0.2}}), HasSubstr("bay_width"));
  EXPECT_THAT(refusal("timber-frame", {{"beam_depth", 2.0}}), HasSubstr("beam_depth"));
  EXPECT_THAT(refusal("timber-frame", {{"bracing", 1.0}, {"brace_reach", 2.0}}), HasSubstr("brace_reach"));
}

}  // namespace
}  // namespace dougong::structures
