// Stresses and uses of joints at rest against statics: a stack, a stack that is pushed, a bonded wall (B07).
#include "structures/self_weight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/settle.h"
#include "structures/pushover.h"
#include "tests/engine/reference.h"
#include "tests/scenes/bonded_bars.h"
#include "tests/scenes/running.h"

namespace dougong::structures {
namespace {

using dougong::testing::expect_relative;

std::vector<FaceLoad> at_rest(const engine::Scene& scene) {
  scenes::Running r(scene);
  EXPECT_TRUE(engine::settle(r.model, r.state, {.unbalanced_ratio = 1e-6}).settled);
  return face_loads(r.model, r.state);
}

const FaceLoad& between(const std::vector<FaceLoad>& faces, std::size_t a, std::size_t b) {
  for (const FaceLoad& face : faces)
    if (face.a == a && face.b == b) return face;
  throw std::out_of_range("no such face");
}

TEST(SelfWeight, OfAStackIsItsWeightOverItsArea) {
  const double b = 0.4, h = 0.5, density = 2400.0, g = 9.81;
  const auto faces = at_rest(scenes::column(3, b, h, 0.7, 1e9));
  ASSERT_EQ(faces.size(), 3u);
  const FaceLoad& foot = between(faces, 0, 3);
  expect_relative("weight", "stress at the foot of a stack (Pa)", 3 * 2 * h * density * g, foot.compression,
                  1e-4);
  expect_relative("weight", "at the second joint (Pa)", 2 * 2 * h * density * g,
                  between(faces, 0, 1).compression, 1e-4);
  EXPECT_NEAR(foot.eccentricity, 0.0, 1e-6);
  EXPECT_NEAR(foot.used, 0.0, 1e-5);
  EXPECT_NEAR(norm(foot.end - foot.start), 2 * b, 1e-3);
}

// A dry joint is as stiff as its blocks, columns between their centroids (the ground is rigid): E A / h at
// the foot, E A / 2 h between two.
TEST(SelfWeight, ADryJointIsAsStiffAsItsBlocks) {
  const double b = 0.4, h = 0.5, modulus = 1e9;
  const auto faces = at_rest(scenes::column(3, b, h, 0.7, modulus));
  for (const auto& [face, expected] : {std::pair{between(faces, 0, 3), modulus * 2 * b / h},
                                       std::pair{between(faces, 0, 1), modulus * 2 * b / (2 * h)}}) {
    expect_relative("weight", "stiffness of a joint (N/m)", expected, face.stiffness, 1e-3);
    expect_relative("weight", "of its blocks (N/m)", expected, face.blocks_stiffness, 1e-3);
    EXPECT_NEAR(face.through.x, 0.0, 1e-6);
  }
}

// Forces lambda W at half the height: e = lambda n h, e' = lambda n h/b; friction lambda/mu. Beyond e' = 1/3
// the face opens and its stress is 4/3 of the mean over what is left.
TEST(SelfWeight, OfAPushedStackPassesWhereStaticsSays) {
  const double b = 0.4, h = 0.5, mu = 0.7;
  for (const double lambda : {0.05, 0.2}) {
    const engine::Scene scene = scenes::column(3, b, h, mu, 30e9);
    const scenes::Running r(scene);
    std::vector<double> weights;
    for (std::size_t i = 0; i < 3; ++i) weights.push_back(r.model.mass[i] * 9.81);
    const auto faces = at_rest(pushed(scene, weights, lambda));
    const FaceLoad& foot = between(faces, 0, 3);
    const double eccentricity = lambda * 3 * h / b;
    const double mean = 3 * weights[0] / (2 * b);
    expect_relative("weight", "eccentricity of a pushed stack", eccentricity, foot.eccentricity, 2e-3);
    if (eccentricity <= 1.0 / 3.0)
      expect_relative("weight", "where the force passes (m)", lambda * 3 * h, foot.through.x, 2e-3);
    expect_relative("weight", "its shear (N)", lambda * 3 * weights[0], std::abs(foot.shear), 2e-3);
    const double peak = eccentricity <= 1.0 / 3.0 ? 1 + 3 * eccentricity : 4.0 / 3.0 / (1 - eccentricity);
    expect_relative("weight", "its greatest stress (Pa)", peak * mean, foot.compression, 0.01);
    EXPECT_EQ(foot.limit, eccentricity > lambda / mu ? FaceLimit::turning : FaceLimit::friction);
  }
}

// B07: 1 x 6 m, 2000 kg/m3, 0.1 MPa, at the push that opens its base: all of the tensile strength is used.
TEST(SelfWeight, OfAPushedBondedWallUsesItsStrength) {
  engine::Scene scene = scenes::scene(0.8, 5e9);
  scene.terrains.push_back(scenes::ground());
  const engine::Owner base{true, 0};
  scenes::BondedBar wall;
  wall.depth = 1.0, wall.modulus = 5e9, wall.shear_modulus = 2e9, wall.density = 2000.0;
  wall.count = 6, wall.end = {0.0, 6.0};
  scenes::add_bar(scene, wall, &base, nullptr);  // the bond of the base is the last
  for (engine::Bond& bond : scene.bonds) bond.tensile_strength = 1e5, bond.cohesion = 1e6;
  const std::vector<double> weights(6, 2000.0 * 9.81);
  for (const double part : {0.5, 0.98}) {
    const double lambda = part * 0.102749;
    const auto faces = at_rest(pushed(scene, weights, lambda));
    ASSERT_EQ(faces.size(), 6u);
    const double mean = 6 * weights[0], bending = 6.0 * lambda * mean * 3.0;
    expect_relative("B07", "greatest compression at the base (Pa)", mean + bending, faces[5].compression,
                    5e-3);
    EXPECT_NEAR(faces[5].tension, std::max(0.0, bending - mean), 5e-3 * mean);
    if (part > 0.9) {
      EXPECT_EQ(faces[5].limit, FaceLimit::tension);
      expect_relative("B07", "use of the tensile strength", (bending - mean) / 1e5, faces[5].used, 0.02);
      EXPECT_EQ(by_use(faces).front(), 5u);
    }
  }
}

}  // namespace
}  // namespace dougong::structures
