#include "engine/contact/stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

// Two blocks of different height and stiffness: columns in series, shared by two points.
TEST(PointStiffness, IsTwoColumnsInSeries) {
  for (const double upper_height : {0.15, 0.6}) {
    Scene s = scenes::scene(0.6, 30e9);
    s.materials.push_back(s.materials[0]);
    s.materials[1].young_modulus = 5e9;
    s.materials[1].poisson_ratio = 0.3;
    s.materials[1].friction_coefficient = 0.4;
    s.bodies = {scenes::block(0.5, 0.2, {0, 0.2}),
                scenes::block(0.3, upper_height, {0.1, 0.4 + upper_height})};
    s.bodies[0].thickness = 0.7;
    s.bodies[1].material = 1;
    const Running r(s);
    const PointStiffness p = r.state.contacts.points.stiffness(0);
    const double per_area = 1.0 / (0.2 / 30e9 + upper_height / 5e9);
    EXPECT_NEAR(p.normal, per_area * 0.6 * 0.7 / 2.0, 1e-9 * p.normal);
    EXPECT_NEAR(p.tangential / p.normal, 0.5 / 1.2, 1e-12);
    EXPECT_EQ(p.friction, 0.4);
  }
}

TEST(PointStiffness, OnTerrainIsTheBlocksOwnColumn) {
  for (const double h : {0.2, 1.0}) {
    const Running r(scenes::block_on_ground(0.25, h, 0.7));
    const double m = r.model.mass[0], i = r.model.inertia[0];
    const PointStiffness p = r.state.contacts.points.stiffness(0);
    EXPECT_NEAR(p.normal, 30e9 / h * 0.5 / 2.0, 1e-9 * p.normal);
    const double felt_normal = 1.0 / (1.0 / m + 0.25 * 0.25 / i),
                 felt_tangential = 1.0 / (1.0 / m + h * h / i);
    EXPECT_NEAR(p.normal_damping, 2.0 * std::sqrt(p.normal * felt_normal), 1e-9 * p.normal_damping);
    EXPECT_NEAR(p.tangential_damping, 2.0 * std::sqrt(p.tangential * felt_tangential),
                1e-9 * p.tangential_damping);
  }
}

// The upper block, 0.3 m high, stands over the lower one's end by `length`.
double stiffness_with_length(double length) {
  Scene s = scenes::scene(0.6);
  s.bodies = {scenes::block(0.5, 0.2, {0.0, 0.2}), scenes::block(0.5, 0.15, {1.0 - length, 0.55})};
  const Running r(s);
  const ContactPoints& points = r.state.contacts.points;
  return law_at(points, 0, geometry_of(points, 0, frames_of(r.model, r.state))).normal;
}

TEST(PointStiffness, OfTwoCornersIsThatOfHalfAWidthWithoutAStep) {
  const double per_length = 30e9 / 0.35 / 2.0, width = 0.3;
  for (const double length : {0.15, 0.16, 0.5, 0.9})
    EXPECT_NEAR(stiffness_with_length(length) / per_length, length, 1e-9) << length;
  for (const double length : {0.0151, 0.05, 0.149})
    EXPECT_NEAR(stiffness_with_length(length) / per_length, 0.5 * width, 1e-9) << length;
  for (const double length : {1e-6, 1e-3, 0.0149})
    EXPECT_NEAR(stiffness_with_length(length) / per_length, 10.0 * length, 1e-9) << length;
}

TEST(PointStiffness, OfADiscIsJohnsonsLine) {
  Scene s = scenes::scene(0.6, 30e9);
  Body disc = scenes::block(0.3, 0.3, {0.0, 0.3});
  disc.shape = make_circle(0.3);
  s.bodies = {disc};
  s.terrains.push_back(scenes::ground());
  const Running r(s);
  EXPECT_NEAR(r.state.contacts.points.stiffness(0).normal, std::numbers::pi / 4.0 * 30e9 / (1.0 - 0.04), 1.0);
}

TEST(PointStiffness, CanBeGiven) {
  Scene s = scenes::block_on_ground(0.25, 0.5, 0.7);
  s.contact.point_stiffness = 1e8;
  s.contact.tangential_ratio = 0.25;
  const Running r(s);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(r.state.contacts.points.stiffness(i).normal, 1e8);
    EXPECT_EQ(r.state.contacts.points.stiffness(i).tangential, 0.25e8);
  }
}

}  // namespace
}  // namespace dougong::engine
