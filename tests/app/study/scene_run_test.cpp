#include "app/study/scene_run.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "app/study/scene_file.h"
#include "app/study/space_input.h"
#include "seismic/input_error.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path records = DOUGONG_RECORDS_DIRECTORY;

SceneDescription scene(const std::string& text) {
  return read_scene(text, "s.toml");
}
PreparedScene prepared(const std::string& text) {
  return prepare_scene(scene(text), records);
}
SceneResult ran(const std::string& text) {
  PreparedScene p = prepared(text);
  return run_scene(p, "test");
}

const std::string falling = R"(
[[body]]
name = "stone"
shape = "circle"
radius = "0.1 m"
position = ["0 m", "100 m"]
velocity = ["3 m/s", "0 m/s"]
[solve]
duration = "1 s"
[output]
rate = "100 Hz"
)";
const std::string floor_of_rubber = R"(
[[terrain]]
name = "floor"
shape = "half-plane"
material = "rubber"
)";
const std::string box = R"(
[[body]]
name = "box"
shape = "rectangle"
width = "1 m"
height = "1 m"
position = ["0 m", "0.5 m"]
material = "rubber"
)" + floor_of_rubber;

TEST(SceneRun, LetsAStoneFallAsGalileoSays) {
  const SceneResult r = ran(falling);
  EXPECT_TRUE(r.valid) << r.reason;
  ASSERT_EQ(r.run.trajectory.times.size(), 101u);
  EXPECT_NEAR(r.run.trajectory.position(100, 0).y, 100.0 - 0.5 * 9.80665, 1e-9);
  EXPECT_NEAR(r.run.trajectory.position(100, 0).x, 3.0, 1e-12);
  EXPECT_NEAR(r.velocities[100].y, -9.80665, 1e-9);
  EXPECT_NEAR(r.accelerations[50].y, -9.80665, 1e-12);
  EXPECT_LT(r.run.energy.relative_error, 1e-9);
}

TEST(SceneRun, FromAWrittenSceneGivesTheSameHash) {
  const SceneDescription first = scene(box + "[solve]\nduration = \"0.3 s\"\n");
  PreparedScene a = prepare_scene(first, records), b = prepare_scene(scene(to_toml(first)), records);
  EXPECT_EQ(run_scene(a, "").run.reproducibility.state_hash, run_scene(b, "").run.reproducibility.state_hash);
}

TEST(SceneRun, CanBeInterruptedAndKeepsWhatItReached) {
  PreparedScene p = prepared(falling);
  const SceneResult r = run_scene(p, "", [](const SceneProgress& now) { return now.time < 0.5; });
  EXPECT_TRUE(r.run.partial);
  EXPECT_TRUE(r.valid);
  EXPECT_NEAR(r.run.trajectory.times.back(), 0.5, 0.02);
}

TEST(SceneRun, RefusesAStepAboveTheBound) {
  try {
    prepared(box + "[solve]\nstep = \"1 s\"\n");
    FAIL() << "a step of a second on a rubber floor";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("solve.step: expected at most the stability bound"));
  }
}

TEST(SceneRun, TakesTheAccuracyThatIsAskedFor) {
  const auto with = [](const std::string& solve) { return prepared(box + "[solve]\n" + solve + "\n"); };
  const PreparedScene draft = with("accuracy = \"draft\""), standard = with("accuracy = \"standard\"");
  EXPECT_EQ(draft.drive.integrator, "velocity-verlet");
  EXPECT_GT(draft.drive.step_fraction, 1.5 * standard.drive.step_fraction);
  EXPECT_THAT(draft.accuracy, HasSubstr("draft: "));
  const PreparedScene reference = with("accuracy = \"reference\"");
  EXPECT_EQ(reference.drive.integrator, "dormand-prince") << "few bodies: steps that end at impacts";
}

TEST(SceneRun, TakesAToleranceForAPositionOfTheDial) {
  const PreparedScene p = prepared(box + "[solve]\ntolerance = 1e-9\n");
  EXPECT_EQ(p.drive.integrator, "dormand-prince");
  EXPECT_EQ(p.drive.tolerance, 1e-9);
  EXPECT_THAT(p.accuracy, HasSubstr("tolerance 1e-09: "));
  EXPECT_THROW(prepared(box + "[solve]\ntolerance = 0.5\n"), std::invalid_argument);
}

TEST(SceneRun, SaysWhatIsAskedForInsteadOfTheDial) {
  const PreparedScene p = prepared(box + "[solve]\nstep_fraction = 0.02\n");
  EXPECT_THAT(p.accuracy, HasSubstr("but 0.02 of the bound, as asked for"));
  EXPECT_THROW(prepared(box + "[solve]\nintegrator = \"rk8\"\nstep_fraction = 0.1\n"), std::invalid_argument);
}

TEST(SceneRun, RefusesARockingRestitutionThatRigidContactsDoNotKnow) {
  EXPECT_THROW(prepared("[materials.rubber]\nrocking_restitution = 0.8\n" + box +
                        "[solve]\nintegrator = \"moreau-jean\"\n"),
               std::invalid_argument);
}

// A vibration under explicit Euler: prepare_scene() refuses it, and who gets past it is told so.
TEST(SceneRun, IsNotValidWithoutAStableStep) {
  const std::string charge =
      "[[body]]\nshape = \"circle\"\nradius = \"0.1 m\"\nmass = \"1 kg\"\ncollides = false\n";
  const PreparedScene p = prepared(charge + "position = [\"1 m\", \"0 m\"]\n" + charge +
                                   "[fields]\ngravitational_constant = \"1 m3/(kg s2)\"\n");
  PreparedScene euler = integrated_by(p, {"explicit-euler", "standard", {}, {}, {}});
  const SceneResult r = run_scene(euler, "");
  EXPECT_FALSE(r.valid);
  EXPECT_THAT(r.reason, HasSubstr("no stable step"));
}

TEST(SceneRun, SaysWhatOverlapsAtTheStart) {
  EXPECT_TRUE(prepared(box).findings.empty());
  SceneDescription d = scene(box);
  d.bodies[0].shape.position.y -= 0.03;
  EXPECT_THAT(prepare_scene(d, records).findings,
              ElementsAre(HasSubstr("box and floor overlap by 0.03 m at the start, 3 %")));
}

TEST(SceneRun, SaysWhenOutputsMoveToTheMotionsSamples) {
  SceneDescription d = scene(box + "[solve]\nduration = \"1 s\"\n[output]\nrate = \"30 Hz\"\n");
  d.terrains[0].motion.emplace().source = "kobe";
  EXPECT_THAT(prepare_scene(d, records).findings,
              ElementsAre(HasSubstr("output every 0.03 s instead of 0.0333333 s"),
                          HasSubstr("1.02 s are simulated instead of 1 s")));
}

TEST(SceneRun, SaysWhatMakesNoDifference) {
  const auto findings = [](const std::string& text) { return prepared(text).findings; };
  EXPECT_THAT(findings("[materials.basalt]\nfriction = 0.4\n" + box),
              ElementsAre(HasSubstr("materials.basalt makes no difference: nothing is made of it")));
  EXPECT_THAT(findings("[materials.rubber]\nyoung_modulus = \"3 MPa\"\n" + box +
                       "[contact]\npoint_stiffness = \"1 MN/m\"\n"),
              ElementsAre(HasSubstr("materials.rubber.young_modulus makes no difference: no spring")));
  EXPECT_THAT(
      findings("[materials.concrete]\nfriction = 0.4\n" + falling + "[contact]\ntangential_ratio = 1\n"),
      ElementsAre(HasSubstr("nothing can touch"), HasSubstr("contact.tangential_ratio")));
  EXPECT_THAT(findings(falling + "[fields]\nopening_angle = 0.5\nelectric_field = [\"1 V/m\", \"0 V/m\"]\n"),
              ElementsAre(HasSubstr("fields.electric_field makes no difference: no body has a charge"),
                          HasSubstr("with fewer than 512 bodies every pair is summed")));
  EXPECT_THAT(findings(box + "motion = { harmonic = { frequency = \"2 Hz\" } }\n"),
              ElementsAre(HasSubstr("motion of terrain floor makes no difference: it is at rest")));
  EXPECT_THAT(findings(box + "[solve]\nintegrator = \"moreau-jean\"\nstep_fraction = 0.5\n"),
              ElementsAre(HasSubstr("rigid contacts have no stability bound")));
}

// A dial beside a step or tolerance that stands in its place.
TEST(SceneRun, RefusesAnAccuracyThatTurnsNothing) {
  const std::string draft = box + "[solve]\naccuracy = \"draft\"\n";
  EXPECT_THROW(prepared(draft + "tolerance = 1e-4\n"), std::invalid_argument);
  EXPECT_THROW(prepared(draft + "integrator = \"rk4\"\nstep_fraction = 0.5\n"), std::invalid_argument);
  EXPECT_THROW(prepared(draft + "integrator = \"rk8\"\ntolerance = 1e-9\n"), std::invalid_argument);
  EXPECT_NO_THROW(prepared(draft + "integrator = \"rk4\"\n"));
}

// A block as broad as high: its own is 0.25, and an impact at the middle of its face gives 0.646.
TEST(SceneRun, SaysWhichRockingRestitutionIsReachedInstead) {
  const auto rocking = [](const std::string& ratio) {
    return "[materials.rubber]\ndamping_ratio = 2\nrocking_restitution = " + ratio + "\n" + box +
           "[solve]\nduration = \"10 ms\"\n";
  };
  const auto said =
      AllOf(HasSubstr("box and floor: a rocking restitution of 1 is out of the contact law's reach"),
            HasSubstr("of the spin"));
  EXPECT_THAT(prepared(rocking("1")).findings, ElementsAre(said));
  EXPECT_THAT(ran(rocking("1")).run.numerics.warnings, Contains(said));
  EXPECT_THAT(prepared(rocking("0.6")).findings, testing::IsEmpty());
}

// Charges that nothing touches: a smooth motion, whose energy comes from their field.
TEST(SceneRun, LetsBodiesPassThatDoNotCollideAndCountsTheirField) {
  const std::string charge =
      "[[body]]\nshape = \"circle\"\nradius = \"0.1 m\"\nmass = \"1 kg\"\ncharge = \"1e-5 C\"\n"
      "collides = false\n";
  const SceneResult r = ran("gravity = \"none\"\n" + charge + "position = [\"0 m\", \"0 m\"]\n" + charge +
                            "position = [\"1 m\", \"0 m\"]\n[fields]\ncoulomb_constant = \"8.9875517923e9 "
                            "N m2/C2\"\n[solve]\nduration = \"1 s\"\n");
  EXPECT_TRUE(r.valid) << r.reason;
  const EnergyHistory& e = r.run.energy;
  EXPECT_NEAR(e.field.front(), 0.898755, 1e-5);
  EXPECT_NEAR(e.kinetic.back(), e.field.front() - e.field.back(), 1e-9);
  EXPECT_LT(r.run.numerics.steps, 2000u) << "no contact bounds the step";
}

TEST(SceneRun, TakesTheIntegratorThatIsNamed) {
  const PreparedScene p = prepared(box + "[solve]\nintegrator = \"rk4\"\nstep_fraction = 0.3\n");
  EXPECT_EQ(p.drive.integrator, "rk4");
  EXPECT_EQ(p.drive.step_fraction, 0.3);
  EXPECT_EQ(p.accuracy, "");
  EXPECT_THROW(prepared(box + "[solve]\nintegrator = \"rk4\"\ntolerance = 1e-6\n"), std::invalid_argument);
}

TEST(SceneRun, CarriesABoxOnABelt) {
  SceneDescription d = scene(box + "[solve]\nduration = \"2 s\"\n");
  d.terrains[0].motion.emplace().velocity = engine::Vec2{0.5, 0.0};
  PreparedScene p = prepare_scene(d, records);
  const SceneResult r = run_scene(p, "");
  EXPECT_NEAR(r.velocities.back().x, 0.5, 0.01);
  EXPECT_NEAR(r.terrain_displacements.back().x, 1.0, 1e-12);
}

TEST(SceneRun, ShakesTheGroundByAShippedRecord) {
  SceneDescription d = scene(box + "[solve]\nduration = \"0.5 s\"\n");
  d.terrains[0].motion.emplace().source = "wenchuan";
  const PreparedScene p = prepare_scene(d, records);
  EXPECT_THAT(modelled_terms(p), Contains(HasSubstr("motion of terrain floor")));
  EXPECT_GT(p.motions[0].duration, 100.0);
  d.terrains[0].motion->source = "lisbon";
  EXPECT_THROW(prepare_scene(d, records), seismic::InputError);
}

const std::string pendulum = R"(
[[body]]
name = "bar"
shape = "rectangle"
width = "0.1 m"
height = "1 m"
position = ["0.008726203218641756 m", "-0.4999238475781956 m"]
angle = "1 deg"
material = "rubber"
[[terrain]]
name = "ceiling"
shape = "circle"
radius = "0.1 m"
position = ["0 m", "0.5 m"]
[[joint]]
kind = "pin"
a = "ceiling"
b = "bar"
at = ["0 m", "0 m"]
[output]
rate = "500 Hz"
)";

TEST(SceneRun, SwingsABarOnAPin) {
  const SceneResult r = ran(pendulum + "[solve]\nduration = \"2 s\"\n");
  ASSERT_TRUE(r.valid) << r.reason;
  // Small swings of a bar about its end: T = 2 pi sqrt(2 L/(3 g)) = 1.638 s; upright a quarter period after
  // the start, with the slack that an anchor off by a degree of arc gives.
  const double quarter = 0.25 * 2.0 * M_PI * std::sqrt(2.0 / (3.0 * 9.80665));
  const auto step = static_cast<std::size_t>(std::lround(500.0 * quarter));
  EXPECT_NEAR(r.run.trajectory.angle(step, 0), 0.0, 2e-3);
  EXPECT_LT(r.run.trajectory.angle(2 * step, 0), -0.012);
  EXPECT_EQ(r.run.model.links.size(), 1u);
}

TEST(SceneRun, HoldsABlockByABondThatBreaksWhenItIsTooWeak) {
  const std::string hung = R"(
[[body]]
name = "block"
shape = "rectangle"
width = "1 m"
height = "1 m"
position = ["0 m", "-0.5 m"]
[[terrain]]
name = "ceiling"
shape = "rectangle"
width = "2 m"
height = "1 m"
position = ["0 m", "0.5 m"]
[[bond]]
a = "ceiling"
b = "block"
start = ["-0.5 m", "0 m"]
end = ["0.5 m", "0 m"]
tensile_strength = "STRENGTH"
[solve]
duration = "0.5 s"
accuracy = "reference"
)";
  const auto height_with = [&](const std::string& strength) {
    std::string text = hung;
    text.replace(text.find("STRENGTH"), 8, strength);
    const SceneResult r = ran(text);
    EXPECT_TRUE(r.valid) << r.reason;
    EXPECT_EQ(r.run.model.bonded.at(0).broken < DrawnBond::never, strength == "1 kPa");
    return r.run.trajectory.position(r.run.trajectory.times.size() - 1, 0).y;
  };
  EXPECT_NEAR(height_with("1 MPa"), -0.5, 1e-4);
  EXPECT_LT(height_with("1 kPa"), -1.0);  // it weighs 23.5 kPa
}

// What the springs hold at 1 MPa is 26.6 J/m2.
TEST(SceneRun, SaysThatABondWithTooLittleFractureEnergyIsBrittle) {
  const std::string two =
      "[[body]]\nname = \"low\"\nshape = \"rectangle\"\nwidth = \"1 m\"\nheight = \"1 m\"\n"
      "[[body]]\nname = \"high\"\nshape = \"rectangle\"\nwidth = \"1 m\"\nheight = \"1 m\"\n"
      "position = [\"0 m\", \"1 m\"]\n[[bond]]\na = \"low\"\nb = \"high\"\n"
      "start = [\"-0.5 m\", \"0.5 m\"]\nend = [\"0.5 m\", \"0.5 m\"]\n"
      "tensile_strength = \"1 MPa\"\nnormal_stiffness = \"18.8 GPa/m\"\nfracture_energy = ";
  EXPECT_THAT(prepared(two + "\"20 J/m2\"\n").findings,
              ElementsAre(AllOf(HasSubstr("bond.bond1.fracture_energy"), HasSubstr("store 26.59"))));
  EXPECT_THAT(prepared(two + "\"40 J/m2\"\n").findings, testing::IsEmpty());
}

TEST(SceneTerms, NameOnlyWhatTheSceneHas) {
  EXPECT_THAT(modelled_terms(prepared(falling)), Not(Contains(HasSubstr("gravitation"))));
  const PreparedScene p =
      prepared("gravity = \"none\"\n" + falling + "[fields]\ngravitational_constant = \"1 m3/(kg s2)\"\n");
  EXPECT_THAT(modelled_terms(p), Contains(HasSubstr("gravitation between all bodies, G = 1")));
  EXPECT_THAT(missing_terms(p), Contains(HasSubstr("uniform gravity: switched off")));
}

TEST(SceneTerms, KnowContactsOnlyWhereSomethingCanTouchAndOfWhichKind) {
  EXPECT_THAT(modelled_terms(prepared(falling)), Not(Contains(HasSubstr("contact"))));
  EXPECT_THAT(missing_terms(prepared(falling)),
              Contains(HasSubstr("contact and friction: nothing can touch")));
  EXPECT_THAT(modelled_terms(prepared(box)), Contains(HasSubstr("contact: springs from the Young's moduli")));
  EXPECT_THAT(modelled_terms(prepared(box + "[contact]\npoint_stiffness = \"1 MN/m\"\n")),
              Contains(HasSubstr("contact: springs of the stiffness that is given")));
  EXPECT_THAT(modelled_terms(prepared(box + "[solve]\nintegrator = \"moreau-jean\"\n")),
              Contains(HasSubstr("contact: rigid, impulses")));
}

TEST(SceneTerms, SayThatAChargeFeelsNothing) {
  SceneDescription d = scene(falling);
  d.bodies[0].charge = 1.0;
  EXPECT_THAT(missing_terms(prepare_scene(d, records)), Contains(HasSubstr("forces on 1 charge")));
}

// --- the step of the message loop
// ---------------------------------------------------------------------------

SceneDescription entered(const std::string& text) {
  std::istringstream in(text);
  SpaceWords words(in, "in.space", nullptr);
  return read_space(words, {}).description;
}

TEST(SpaceStep, IsTheTickOverNWhereThatIsStable) {
  SceneDescription d = entered("cir 0 0 0 0 1 0 100 1 finish 10");
  EXPECT_THAT(choose_space_step(d, 10.0, records), HasSubstr("as asked for"));
  EXPECT_EQ(d.solve.step, 0.001);
}

TEST(SpaceStep, IsHalfTheBoundWhereItIsNotAndSaysSo) {
  SceneDescription d = entered("rect 0 0 0 0 2400 1 1 0 0.5 0 plane 0 0 1 0 finish 10");
  EXPECT_THAT(choose_space_step(d, 10.0, records), HasSubstr("above the stability bound"));
  EXPECT_FALSE(d.solve.step);
  EXPECT_EQ(d.solve.step_fraction, 0.5);
  const PreparedScene p = prepare_scene(d, records);
  EXPECT_LE(p.plan.step, 0.5 * p.plan.bound);
}

}  // namespace
}  // namespace dougong::app
