// A scene with its model and state, ready to run.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/drive.h"
#include "tests/scenes/blocks.h"

namespace dougong::scenes {

struct Running {
  engine::Model model;
  engine::State state;

  explicit Running(const engine::Scene& scene)
      : model(engine::compile(scene)), state(engine::initial_state(model, scene)) {}

  std::size_t bodies() const { return model.body_count; }
  engine::Vec2 position(std::size_t i = 0) const {
    return model.origin + engine::Vec2{state.q()[i], state.q()[bodies() + i]};
  }
  engine::Vec2 velocity(std::size_t i = 0) const { return {state.v()[i], state.v()[bodies() + i]}; }
  double angle(std::size_t i = 0) const { return state.q()[2 * bodies() + i]; }
  double spin(std::size_t i = 0) const { return state.v()[2 * bodies() + i]; }
  engine::Energies energies() const { return engine::energies_of(model, state); }

  engine::RunOutcome run(const engine::DriveOptions& options, const engine::Observer& observe = {}) {
    return engine::drive(model, state, options, observe);
  }
};

inline engine::Vec2 momentum(const Running& r) {
  engine::Vec2 sum;
  for (std::size_t i = 0; i < r.bodies(); ++i) sum += r.model.mass[i] * r.velocity(i);
  return sum;
}
/// About a fixed point.
inline double angular_momentum(const Running& r, engine::Vec2 about) {
  double sum = 0.0;
  for (std::size_t i = 0; i < r.bodies(); ++i)
    sum += r.model.mass[i] * cross(r.position(i) - about, r.velocity(i)) + r.model.inertia[i] * r.spin(i);
  return sum;
}

/// How far the body that moved most is from where it was (m).
inline double greatest_drift(const Running& r, const Running& start) {
  double drift = 0.0;
  for (std::size_t i = 0; i < r.bodies(); ++i)
    drift = std::max(drift, norm(r.position(i) - start.position(i)));
  return drift;
}
inline double greatest_turn(const Running& r, const Running& start) {
  double turn = 0.0;
  for (std::size_t i = 0; i < r.bodies(); ++i) turn = std::max(turn, std::abs(r.angle(i) - start.angle(i)));
  return turn;
}

/// What compile() says against a scene; "accepted" when it has nothing to say.
inline std::string refusal_of(const engine::Scene& scene) {
  try {
    engine::compile(scene);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

inline engine::DriveOptions run_for(double end_time, double output_interval = 0.01,
                                    const std::string& integrator = "velocity-verlet") {
  engine::DriveOptions options;
  options.end_time = end_time;
  options.output_interval = output_interval;
  options.integrator = integrator;
  return options;
}

/// A block of half sizes b, h standing on a ground.
inline engine::Scene block_on_ground(double b, double h, double friction, double young_modulus = 30e9) {
  engine::Scene s = scene(friction, young_modulus);
  s.bodies.push_back(block(b, h, {0.0, h}));
  s.terrains.push_back(ground());
  return s;
}

/// `count` equal blocks of half sizes b, h, one on another, on a ground.
inline engine::Scene column(int count, double b, double h, double friction, double young_modulus = 30e9) {
  engine::Scene s = scene(friction, young_modulus);
  for (int i = 0; i < count; ++i) {
    s.bodies.push_back(block(b, h, {0.0, (2 * i + 1) * h}));
    s.bodies.back().name = "block " + std::to_string(i);
  }
  s.terrains.push_back(ground());
  return s;
}

/// A dry wall in running bond: `courses` of `bricks` bricks 0.4 x 0.2 m, half bricks at odd ends.
inline engine::Scene wall(int bricks, int courses, double friction, double young_modulus = 30e9) {
  engine::Scene s = scene(friction, young_modulus);
  const double w = 0.4, h = 0.2;
  for (int row = 0; row < courses; ++row) {
    const bool odd = row % 2 == 1;
    for (int i = 0; i < bricks + (odd ? 1 : 0); ++i) {
      const bool half = odd && (i == 0 || i == bricks);
      const double x =
          odd ? (i == 0 ? 0.25 * w : (i == bricks ? (bricks - 0.25) * w : i * w)) : (i + 0.5) * w;
      s.bodies.push_back(block(half ? 0.25 * w : 0.5 * w, 0.5 * h, {x, (row + 0.5) * h}));
      s.bodies.back().name = "brick " + std::to_string(row) + "/" + std::to_string(i);
    }
  }
  s.terrains.push_back(ground());
  return s;
}

/// Makes the contacts remember that they touch: their friction springs are relaxed at the present poses.
inline void touch(Running& r) {
  std::vector<engine::PairLoad> loads(r.state.contacts.points.load_count());
  engine::contact_forces(r.state.contacts.points, engine::frames_of(r.model, r.state), true, loads);
}

/// Normal and tangential force of one contact point.
struct PointForce {
  engine::Vec2 place;                     // m, relative to the model's origin
  double normal = 0.0, tangential = 0.0;  // N
};

/// The forces of the points as they are, without touching what the contacts remember.
inline std::vector<PointForce> point_forces(const engine::Model& model, const engine::State& state) {
  const auto frames = engine::frames_of(model, state);
  engine::ContactPoints points = state.contacts.points;
  std::vector<PointForce> forces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const engine::PointGeometry g = engine::geometry_of(points, i, frames);
    const engine::Vec2 f = engine::force_of(points, i, frames);
    forces.push_back(
        {frames[points.edge_body[i]].position() + g.arm_edge, dot(f, g.normal), dot(f, turned(g.normal))});
  }
  return forces;
}

}  // namespace dougong::scenes
