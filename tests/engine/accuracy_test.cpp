#include "engine/accuracy.h"

#include <gmock/gmock.h>

#include "engine/integrators/table.h"
#include "tests/oracles/two_bodies.h"
#include "tests/scenes/points.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Accuracy draft = AccuracyLevel::draft, standard = AccuracyLevel::standard,
               reference = AccuracyLevel::reference;

TEST(AccuracyText, IsALevelOrATolerance) {
  EXPECT_EQ(accuracy_from("draft"), draft);
  EXPECT_EQ(accuracy_from("standard"), standard);
  EXPECT_EQ(accuracy_from("reference"), reference);
  EXPECT_EQ(accuracy_from("1e-6"), Accuracy(1e-6));
  for (const char* wrong : {"", "Draft", "fine", "1e-6x", "0", "-1e-3", "1e-20", "0.5", "nan"}) try {
      accuracy_from(wrong);
      FAIL() << wrong;
    } catch (const std::invalid_argument& e) {
      EXPECT_THAT(e.what(), HasSubstr("draft, standard, reference"));
      EXPECT_THAT(e.what(), HasSubstr("found \"" + std::string(wrong) + "\""));
    }
}

TEST(Accuracy, OfASmoothSceneIsATolerance) {
  const Model orbit = compile(scenes::two_bodies(1.0, 1.0, 1.0, {1.0, 0.0}, {0.0, 1.0}));
  EXPECT_EQ(resolve_accuracy(draft, orbit).integrator, "dormand-prince");
  EXPECT_EQ(resolve_accuracy(reference, orbit).integrator, "rk8");
  EXPECT_EQ(resolve_accuracy(1e-4, orbit).tolerance, 1e-4);
  EXPECT_EQ(resolve_accuracy(1e-11, orbit).integrator, "rk8");
  EXPECT_THAT(resolve_accuracy(reference, orbit).explanation, HasSubstr("reference: nothing touches"));
}

TEST(Accuracy, OfATreeIsAFixedStep) {
  Scene s = scenes::cloud(600);
  s.fields.gravitational_constant = 1.0, s.fields.opening_angle = 0.5;
  const Model cloud = compile(s);
  double before = 1.0;
  for (const Accuracy& a : {draft, standard, reference}) {
    const ResolvedAccuracy r = resolve_accuracy(a, cloud);
    EXPECT_EQ(r.integrator, "leapfrog");
    EXPECT_LT(r.step_fraction, before);
    before = r.step_fraction;
  }
}

TEST(Accuracy, OfFewBlocksEndsStepsAtImpactsOnlyForReference) {
  const Model block = compile(scenes::block_on_ground(0.5, 0.2, 0.6));
  EXPECT_EQ(resolve_accuracy(draft, block).integrator, "velocity-verlet");
  EXPECT_EQ(resolve_accuracy(standard, block).integrator, "velocity-verlet");
  EXPECT_EQ(resolve_accuracy(standard, block).step_fraction, DriveOptions{}.step_fraction);
  EXPECT_EQ(resolve_accuracy(reference, block).integrator, "dormand-prince");
}

TEST(Accuracy, OfAWallIsAPartOfTheBound) {
  const Model wall = compile(scenes::wall(4, 6, 0.6));
  double before = 1.0;
  for (const Accuracy& a : {draft, standard, reference}) {
    const ResolvedAccuracy r = resolve_accuracy(a, wall);
    EXPECT_EQ(r.integrator, "velocity-verlet");
    EXPECT_LT(r.step_fraction, before);
    EXPECT_THAT(r.explanation, Not(HasSubstr("\n")));
    before = r.step_fraction;
  }
  EXPECT_LT(resolve_accuracy(1e-4, wall).step_fraction, resolve_accuracy(1e-3, wall).step_fraction);
  EXPECT_THAT(resolve_accuracy(1e-4, wall).explanation, HasSubstr("not promised"));
}

// What the dial gives must be accepted, and a better level must err less.
TEST(Accuracy, ErrsLessTheMoreIsAsked) {
  const double period = 2.0 * 3.14159265358979323846;
  double before = 1.0;
  for (const Accuracy& a : {draft, standard, reference}) {
    const oracles::PlaneMotion start = oracles::ellipse(1.0, 1.0, 0.4, 0.0);
    scenes::Running r(scenes::two_bodies(1.0, 0.5, 0.5, {start.x, start.y}, {start.vx, start.vy}));
    DriveOptions options = scenes::run_for(period, period);
    apply(resolve_accuracy(a, r.model), options);
    ASSERT_EQ(r.run(options).outcome, Outcome::completed);
    const double error = norm(r.position(1) - r.position(0) - Vec2{start.x, start.y});
    EXPECT_LT(error, before);
    before = error;
  }
}

}  // namespace
}  // namespace dougong::engine
