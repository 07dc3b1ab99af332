// Openings, slips and forces of joints: against motions made by hand, and against the weight and inertia of a
// shaken stack.
#include "structures/joint_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/scenes/running.h"
#include "tests/scenes/running_bond.h"
#include "tests/structures/scripted_run.h"

namespace dougong::structures {
namespace {

using dougong::testing::expect_relative;

constexpr std::size_t ground_of_two = 2;

// Two blocks of 1 x 1 m, one on the other, on a ground at y = 0.
Script stack_of_two() {
  Script script;
  script.building.scene = scenes::column(2, 0.5, 0.5, 0.7, 1e9);
  script.building.scene.bodies[0].name = "lower", script.building.scene.bodies[1].name = "upper";
  return script;
}

FaceLoad joint(std::size_t a, std::size_t b, double height) {
  FaceLoad face;
  face.a = a, face.b = b;
  face.start = {-0.5, height}, face.end = {0.5, height};
  return face;
}

// The upper block turns by theta about its centre and goes right by u and up by v:
//   opening v + (cos theta - 1)(-h) + b |sin theta|,   slip u + h sin theta     (its lower face is h below)
TEST(JointMotions, AreThoseOfTheFacesCarriedByTheirBlocks) {
  Script script = stack_of_two();
  const double theta = 0.02, u = 0.003, v = 0.004, h = 0.5, b = 0.5;
  script.ground = [](double t) { return engine::Vec2{0.1 * std::sin(t), 0.02 * t}; };
  script.block = [&](const std::string& name, double t) {
    const double part = t < 2.0 ? 0.5 * t : std::max(0.5, 3.0 - t);  // half of it stays
    return name == "upper" ? Pose{part * u, part * v, part * theta} : Pose{};
  };
  const auto motions =
      joint_motions({joint(0, 1, 1.0), joint(0, ground_of_two, 0.0)}, script.trajectory(), {});
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_NEAR(motions[0].opening.value, v + h * (1 - std::cos(theta)) + b * std::sin(theta), 1e-12);
  EXPECT_NEAR(motions[0].opening.time, 2.0, 0.011);
  EXPECT_NEAR(motions[0].slip.value, u + h * std::sin(theta), 1e-12);
  const double left = 0.5 * theta;
  EXPECT_NEAR(motions[0].residual_slip, 0.5 * u + h * std::sin(left), 1e-12);
  EXPECT_NEAR(motions[0].residual_opening, 0.5 * v + h * (1 - std::cos(left)) + b * std::sin(left), 1e-12);
  EXPECT_NEAR(motions[1].opening.value, 0.0, 1e-12) << "the lower block goes with the ground";
  EXPECT_NEAR(motions[1].slip.value, 0.0, 1e-12);
}

TEST(JointMotions, TurnWithTheirFirstBlock) {
  Script script = stack_of_two();
  // Both turn by the same angle about the middle of the foot: nothing opens, nothing slides.
  script.block = [](const std::string& name, double t) {
    const double angle = 0.05 * t, height = name == "upper" ? 1.5 : 0.5;
    return Pose{-height * std::sin(angle), height * (std::cos(angle) - 1.0), angle};
  };
  const auto motions = joint_motions({joint(0, 1, 1.0)}, script.trajectory(), {});
  EXPECT_NEAR(motions[0].opening.value, 0.0, 1e-12);
  EXPECT_NEAR(motions[0].slip.value, 0.0, 1e-12);
}

TEST(JointMotions, EndWithTheLossOfABlock) {
  Script script = stack_of_two();
  script.block = [](const std::string& name, double t) {
    return name == "upper" ? Pose{0.1 * t, 0.0, 0.0} : Pose{};
  };
  const auto motions = joint_motions({joint(0, 1, 1.0)}, script.trajectory(), {{1, 2.0, "left its place"}});
  EXPECT_NEAR(motions[0].slip.value, 0.199, 1e-9);
  EXPECT_NEAR(motions[0].residual_slip, 0.199, 1e-9);
}

TEST(JointMotions, ReadNegativeOpeningsAsClosed) {
  Script script = stack_of_two();
  script.block = [](const std::string& name, double) {
    return name == "upper" ? Pose{0.0, -1e-4, 0.0} : Pose{};
  };
  EXPECT_EQ(joint_motions({joint(0, 1, 1.0)}, script.trajectory(), {})[0].opening.value, 0.0);
  EXPECT_EQ(joint_motions({joint(0, 1, 1.0)}, Trajectory{}, {}).size(), 1u) << "of no time at all";
}

struct Shaken {
  scenes::Running r;
  JointForceRecorder recorder;
  std::vector<JointForces> forces;

  explicit Shaken(const engine::Scene& scene, double end = 1.0) : r(scene) {
    EXPECT_TRUE(engine::settle(r.model, r.state, {.unbalanced_ratio = 1e-6}).settled);
    recorder = {face_loads(r.model, r.state), r.model, r.state};
    r.run(scenes::run_for(end, 1e-3), [&](const engine::Sample& sample) {
      recorder.note(r.model, sample.state, engine::frames_of(r.model, sample.state));
      return engine::Wish::go_on;
    });
    forces = recorder.forces();
  }
  const JointForces& between(std::size_t a, std::size_t b) const {
    for (std::size_t k = 0; k < forces.size(); ++k)
      if (recorder.joints()[k].a == a && recorder.joints()[k].b == b) return forces[k];
    throw std::out_of_range("no such joint");
  }
};

// A stack so stiff that it goes with the ground: T = sum of m a above the joint, N the weight above it.
TEST(JointForces, OfAShakenStackAreItsInertiaAndItsWeight) {
  const double amplitude = 0.05 * 9.81;
  engine::Scene scene = scenes::column(3, 0.6, 0.3, 0.7, 30e9);
  scene.terrains[0].motion = scenes::sine_motion(amplitude, 2.0);
  const Shaken shaken(scene);
  const double mass = shaken.r.model.mass[0];
  for (const std::size_t above : {3u, 2u}) {
    const JointForces& f = above == 3 ? shaken.between(0, 3) : shaken.between(0, 1);
    expect_relative("joints", "peak shear of a shaken stack (N)",
                    static_cast<double>(above) * mass * amplitude, std::abs(f.shear.value), 1e-3);
    expect_relative("joints", "its compression (N)", static_cast<double>(above) * mass * 9.81,
                    f.compression.value, 1e-3);
    EXPECT_EQ(f.tension.value, 0.0);
  }
}

// A slender block whose bonded foot cracks rocks on it: what it bears then is of the contacts.
TEST(JointForces, OfACrackedBondGoOnAsItsContacts) {
  engine::Scene scene = scenes::column(1, 0.3, 1.0, 0.7, 5e9);
  engine::Bond bond;
  bond.name = "foot";
  bond.a = {false, 0}, bond.b = {true, 0};
  bond.start = {-0.3, 0.0}, bond.end = {0.3, 0.0};
  bond.normal_stiffness = 1e10;
  bond.tensile_strength = 2e4, bond.cohesion = 1e6;
  scene.bonds.push_back(bond);
  scene.terrains[0].motion = scenes::sine_motion(0.5 * 9.81, 2.0);
  const Shaken shaken(scene);
  ASSERT_TRUE(shaken.r.state.bonds.history[0].broken || shaken.r.state.bonds.history[1].broken);
  const double weight = shaken.r.model.mass[0] * 9.81;
  EXPECT_GT(shaken.forces[0].compression.value, 1.05 * weight) << "it lands on its corners";
  EXPECT_EQ(shaken.forces.size(), 1u);
}

}  // namespace
}  // namespace dougong::structures
