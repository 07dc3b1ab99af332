#include "app/study/tradeoff/ladder.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/integrators/table.h"
#include "tests/app/study/tradeoff/tradeoff_cases.h"

namespace dougong::app {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

PreparedScene scene(const std::string& text) {
  return prepare_scene(read_scene(text, "s.toml"), shipped_records);
}

const std::string a_pin_between =
    "[[joint]]\nkind = \"pin\"\na = \"box\"\nb = \"terrain1\"\nat = [\"0 m\", \"0 m\"]\n";

TEST(Ladder, HasEveryIntegratorThatApplies) {
  const LadderChoice touching = completed({}, scene(box_that_lands)), apart = completed({}, scene(orbit));
  EXPECT_EQ(touching.integrators.size(), std::variant_size_v<engine::AnyIntegrator>);
  EXPECT_THAT(apart.integrators, Not(Contains("moreau-jean"))) << "nothing touches";
  EXPECT_EQ(apart.integrators.size(), touching.integrators.size() - 1);
  EXPECT_FALSE(does_not_apply("moreau-jean", scene(orbit).model).empty());
}

TEST(Ladder, VariesStiffnessOnlyWhereContactsAloneAreElastic) {
  EXPECT_THAT(completed({}, scene(box_that_lands)).stiffnesses, ElementsAre(10.0, 1.0, 0.1));
  EXPECT_THAT(completed({}, scene(box_that_lands + a_pin_between)).stiffnesses, ElementsAre(1.0));
  EXPECT_THAT(completed({}, scene(orbit)).stiffnesses, ElementsAre(1.0));
}

TEST(Ladder, GoesFromCoarseToFineWithinASeries) {
  const PreparedScene box = scene(box_that_lands);
  LadderChoice choice;
  choice.steps = {0.1, 0.9, 0.5, 0.5};
  const std::vector<Way> ways = ladder_of(completed(choice, box), 1.0, box);
  for (std::size_t i = 1; i < ways.size(); ++i) {
    if (!ways[i].is_of_series(ways[i - 1])) continue;
    EXPECT_LT(ways[i].coarseness(), ways[i - 1].coarseness());
  }
  EXPECT_EQ(ways[0].solve.step_fraction, 0.9);
  EXPECT_EQ(ways[2].solve.step_fraction, 0.1) << "what is said twice is run once";
}

TEST(Ladder, HasOneSeriesOfRigidContacts) {
  const PreparedScene box = scene(box_that_lands);
  LadderChoice choice;
  choice.integrators = {"moreau-jean"};
  choice.steps = {0.5, 0.1};
  choice = completed(choice, box);
  const std::vector<Way> ways = ladder_of(choice, 1.0, box);
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_EQ(ways[0].stiffness, rigid);
  EXPECT_EQ(ways[0].solve.step, 0.5e-3) << "a part of the millisecond that it takes by itself";
  EXPECT_TRUE(ladder_of(choice, 10.0, box).empty());
}

TEST(Ladder, TakesPartsOfTheOutputIntervalWhereNothingBoundsTheStep) {
  const PreparedScene free = scene(
      "[[body]]\nshape = \"circle\"\nradius = \"1 m\"\n[solve]\nduration = \"1 s\"\n[output]\nrate = \"10 "
      "Hz\"\n");
  const Way way = fixed_way("rk4", 0.25, 1.0, free);
  EXPECT_FALSE(way.solve.step_fraction);
  EXPECT_EQ(way.solve.step, 0.025);
}

TEST(Ladder, AsksForAStepAboveTheBoundWhenItIsToldTo) {
  const PreparedScene box = scene(
      "[[body]]\nshape = \"rectangle\"\nwidth = \"1 m\"\nheight = \"1 m\"\nposition = [\"0 m\", \"0.5 m\"]\n"
      "[[terrain]]\nshape = \"half-plane\"\n");
  const Way way = fixed_way("velocity-verlet", 1.5, 1.0, box);
  ASSERT_TRUE(way.solve.step);
  EXPECT_NEAR(*way.solve.step / box.plan.bound, 1.5, 1e-3);
}

TEST(Way, SaysTheKeysThatAskForIt) {
  const SceneDescription box = read_scene(box_that_lands, "s.toml");
  const engine::Scene built = build_scene(box).scene;
  Way way{0.5, {}};
  way.solve.integrator = "rk4", way.solve.step_fraction = 0.25;
  std::string text = box_that_lands.substr(0, box_that_lands.find("[solve]"));
  for (const std::string& line : keys_of(way, box, built)) text += line + "\n";
  const SceneDescription asked = read_scene(text, "asked.toml");
  EXPECT_EQ(asked.solve.integrator, "rk4");
  EXPECT_EQ(asked.solve.step_fraction, 0.25);
  EXPECT_EQ(build_scene(asked).scene.materials.at(0).young_modulus,
            0.5 * built.materials.at(0).young_modulus);
  EXPECT_EQ(build_scene(asked).scene.materials.at(0).friction_coefficient,
            built.materials.at(0).friction_coefficient);
}

TEST(Way, TakesBackTheKeysThatItHasNoUseFor) {
  const std::string head = box_that_lands.substr(0, box_that_lands.find("[solve]"));
  const SceneDescription box = read_scene(
      head + "[contact]\npoint_stiffness = \"1e8 N/m\"\n[solve]\naccuracy = \"draft\"\n", "s.toml");
  Way way{rigid, {}};
  way.solve.integrator = "moreau-jean", way.solve.step = 0.5e-3;
  std::string text = head;
  for (const std::string& line : keys_of(way, box, build_scene(box).scene)) text += line + "\n";
  const SceneDescription asked = read_scene(text, "asked.toml");
  EXPECT_NO_THROW(build_scene(asked)) << text;
  EXPECT_EQ(asked.solve.step, 0.5e-3);
  EXPECT_EQ(asked.solve.accuracy, "standard");
  EXPECT_FALSE(asked.contact.point_stiffness);
}

TEST(Way, ScalesAStiffnessThatIsGivenForPoints) {
  SceneDescription box = read_scene(box_that_lands, "s.toml");
  box.contact.point_stiffness = 1e6;
  EXPECT_EQ(with_stiffness(box, build_scene(box).scene, 10.0).contact.point_stiffness, 1e7);
}

}  // namespace
}  // namespace dougong::app
