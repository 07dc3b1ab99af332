// Small scenes at random, for what must hold of any scene: the same seed makes the same scene on every
// machine, since SplitMix64 and the way from its bits to numbers are written out here.
//
// Blocks, regular polygons and discs of all sizes, in a box, on a ground that may shake, or alone in space;
// any density, modulus, friction and damping, velocity and spin. Nothing overlaps at the start.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/scenes/burst.h"
#include "tests/scenes/discs.h"

namespace dougong::scenes {

/// Steele, Lea and Flood, OOPSLA 2014: a counter and a mix of its bits.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1.0p-53;
  }
  /// Evenly over the orders of magnitude.
  double decades(double low, double high) {
    return low * std::pow(10.0, uniform(0.0, std::log10(high / low)));
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

 private:
  std::uint64_t state_;
};

enum class Surroundings { space, ground, box };

constexpr double flattest = 0.2;  // height over width of a block

struct RandomScene {
  engine::Scene scene;
  Surroundings surroundings = Surroundings::ground;
};

namespace random_scene {

// Within a circle of that diameter.
inline engine::Shape shape(SplitMix64& random, double size) {
  const std::size_t kind = random.below(4);
  if (kind == 0) return engine::make_circle(0.5 * size);
  if (kind < 3) return engine::make_rectangle(0.7 * size, 0.7 * size * random.decades(flattest, 1.0));
  // On a circle of 0.4 of the size: the centroid lies off its centre, by a quarter of its radius at most.
  std::vector<engine::Vec2> corners;
  const auto n = static_cast<int>(3 + random.below(5));
  for (int i = 0; i < n; ++i) {
    const double turns = (i + random.uniform(0.25, 0.75)) / n;
    corners.push_back(engine::rotated({0.4 * size, 0.0}, 2.0 * std::numbers::pi * turns));
  }
  return engine::make_polygon(corners).polygon;
}

inline engine::Material material(SplitMix64& random) {
  engine::Material m;
  m.density = random.decades(500.0, 4000.0);
  m.young_modulus = random.decades(2e8, 2e9);
  m.friction_coefficient = random.below(4) == 0 ? 0.0 : random.decades(0.05, 2.0);
  m.damping_ratio = random.below(4) == 0 ? 0.0 : random.decades(0.05, 2.0);
  return m;
}

// Each in a cell of its own, so that nothing overlaps.
inline void add_bodies(engine::Scene& s, SplitMix64& random, double cell, double speed) {
  const std::size_t count = 2 + random.below(5), columns = 1 + random.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    engine::Body body;
    body.name = "body " + std::to_string(i);
    body.shape = shape(random, 0.95 * cell * random.decades(0.3, 1.0));
    const double slack = 0.5 * (cell - 2.0 * engine::bounding_radius(body.shape));
    const double column = static_cast<double>(i % columns) - 0.5 * static_cast<double>(columns - 1);
    body.position = {cell * column + random.uniform(-slack, slack),
                     cell * (0.5 + static_cast<double>(i / columns)) + random.uniform(-slack, slack)};
    body.angle = random.below(2) == 0 ? 0.0 : random.uniform(-std::numbers::pi, std::numbers::pi);
    body.velocity = {random.uniform(-speed, speed), random.uniform(-speed, speed)};
    body.spin = random.uniform(-3.0, 3.0) * speed;
    s.bodies.push_back(std::move(body));
  }
}

}  // namespace random_scene

inline RandomScene make_random_scene(std::uint64_t seed) {
  SplitMix64 random(seed);
  RandomScene r;
  const double cell = 0.5;  // m
  r.surroundings = static_cast<Surroundings>(random.below(3));
  r.scene.materials[0] = random_scene::material(random);
  r.scene.gravity = {0.0, r.surroundings == Surroundings::ground ? -9.81 : 0.0};
  const double speed = random.uniform(0.0, 3.0);
  random_scene::add_bodies(r.scene, random, cell, speed);
  if (r.surroundings == Surroundings::space)  // thrown at each other
    for (engine::Body& body : r.scene.bodies)
      body.velocity += -2.0 * (body.position - engine::Vec2{0.0, cell});
  if (r.surroundings == Surroundings::ground) {
    const bool shakes = random.below(2) == 0;
    const double amplitude = random.decades(0.1, 20.0), frequency = random.decades(0.5, 8.0);
    r.scene.terrains.push_back(ground());
    if (shakes) r.scene.terrains[0].motion = std::make_shared<Burst>(amplitude, frequency, 1.0);
  }
  if (r.surroundings == Surroundings::box) {
    add_box(r.scene, 3.0 * cell, 6.0 * cell);
    for (engine::Terrain& wall : r.scene.terrains) wall.position.y += 3.0 * cell;
  }
  return r;
}

}  // namespace dougong::scenes
