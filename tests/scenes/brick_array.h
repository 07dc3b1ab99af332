// The 81-brick graphite array on a shaking table, in plan and without gravity (comparison M02; Ahmed and
// Stojko, Earthq. Eng. Struct. Dyn. 15 (1987) 159-188): 41 fuel bricks, 40 interstitial bricks and 100 loose
// keys inside a ring of 40 bricks that move with the frame.
#pragma once

#include <cmath>
#include <map>
#include <numbers>

#include "tests/scenes/running.h"

namespace dougong::scenes {

inline constexpr double brick_pitch = 0.6529;  // m

/// Displacement -(A/w^2) sin(phi) in x: acceleration of amplitude A, at the frequency of `from` for `dwell`,
/// then rising by `rate` up to `to`. Its velocity has no mean, as the ratio of velocities asks.
class SweptSine final : public engine::PrescribedMotion {
 public:
  SweptSine(double amplitude, double from, double to, double rate, double dwell)
      : amplitude_(amplitude), from_(from), to_(to), rate_(rate), dwell_(dwell) {}

  double frequency(double t) const { return std::min(to_, from_ + rate_ * std::max(0.0, t - dwell_)); }
  double end() const { return dwell_ + (to_ - from_) / rate_; }

  engine::MotionSample at(double t) const override {
    const double turn = 2.0 * std::numbers::pi, swept = std::max(0.0, t - dwell_);
    const double w = turn * (from_ + rate_ * swept), dw = t > dwell_ ? turn * rate_ : 0.0;
    const double phase = turn * (from_ * t + 0.5 * rate_ * swept * swept);
    // s = 1/w^2 and its derivatives.
    const double s = 1.0 / (w * w), ds = -2.0 * s / w * dw, dds = 6.0 * s * s * dw * dw;
    const double sine = std::sin(phase), cosine = std::cos(phase);
    return {{-amplitude_ * s * sine, 0.0},
            {-amplitude_ * (ds * sine + s * w * cosine), 0.0},
            {-amplitude_ * ((dds - s * w * w) * sine + (2.0 * ds * w + s * dw) * cosine), 0.0}};
  }

 private:
  double amplitude_, from_, to_, rate_, dwell_;  // m/s2, Hz, Hz, Hz/s, s
};

struct BrickArrayOptions {
  /// Of a contact point. Two fuel bricks meet at four, whose dashpots add up: they part with 0.90 of their
  /// speed, as in binary tests.
  double restitution = 0.943;
  double key_restitution = 0.943;  // of a point of a loose key: no test tells
  double friction = 0.1;
  double young_modulus = 11.8e9;  // Pa
  double key_stiffness = 1.0;     // of the keys' Young's modulus, over that of the bricks
};

namespace bricks {

inline engine::Vec2 quarter_turns(engine::Vec2 p, int count) {
  for (int i = 0; i < count; ++i) p = {-p.y, p.x};
  return p;
}

inline engine::Part polygon_part(const std::vector<engine::Vec2>& corners) {
  const engine::PlacedPolygon placed = engine::make_polygon(corners);
  return {placed.polygon, placed.centroid, 0.0};
}

/// The outline with its four face slots and four key slots: a core that joins the bottoms of the slots, and
/// the eight teeth between them. The bore is not part of what touches.
inline engine::Shape fuel_brick() {
  std::vector<engine::Vec2> core;
  std::vector<engine::Part> parts;
  for (int i = 0; i < 4; ++i) {
    const auto turned = [&](std::vector<engine::Vec2> corners) {
      for (engine::Vec2& p : corners) p = quarter_turns(p, i);
      return corners;
    };
    for (const engine::Vec2 p : turned({{0.18, -0.03}, {0.18, 0.03}, {0.14353, 0.12518}, {0.12518, 0.14353}}))
      core.push_back(p);
    parts.push_back(polygon_part(
        turned({{0.18, 0.03}, {0.214, 0.03}, {0.214, 0.0836}, {0.17137, 0.15302}, {0.14353, 0.12518}})));
    parts.push_back(polygon_part(
        turned({{0.18, -0.03}, {0.14353, -0.12518}, {0.17137, -0.15302}, {0.214, -0.0836}, {0.214, -0.03}})));
  }
  parts.push_back(polygon_part(core));
  return engine::make_compound(std::move(parts)).compound;
}

/// A bearing key of an interstitial brick, towards +x: it stands in the slot of a fuel brick's face, with
/// 0.755 mm of play on each side.
inline std::vector<engine::Vec2> bearing_key() {
  return {{0.11025, -0.029245}, {0.14, -0.029245}, {0.14, 0.029245}, {0.11025, 0.029245}};
}
inline constexpr double key_height = 0.26;  // m, of bearing keys and loose keys

inline engine::Shape octagon() {
  std::vector<engine::Vec2> corners;
  for (int i = 0; i < 4; ++i) {
    corners.push_back(quarter_turns({0.11025, -0.06193}, i));
    corners.push_back(quarter_turns({0.11025, 0.06193}, i));
  }
  return engine::make_polygon(corners).polygon;
}

/// The octagon with its four bearing keys.
inline engine::Shape interstitial_brick() {
  std::vector<engine::Part> parts{{std::get<engine::ConvexPolygon>(octagon()), {}, 0.0}};
  for (int i = 0; i < 4; ++i) {
    std::vector<engine::Vec2> key = bearing_key();
    for (engine::Vec2& p : key) p = quarter_turns(p, i);
    parts.push_back(polygon_part(key));
  }
  return engine::make_compound(std::move(parts)).compound;
}

/// Polar second moment of a regular polygon of n corners and that area, about its centre:
///   A^2/n (1 + 3 cot^2(pi/n)) / (6 cot(pi/n)), which is A^2/(2 pi) for a circle.
inline double regular_polygon_moment(double area, int n) {
  const double cot = 1.0 / std::tan(std::numbers::pi / n);
  return area * area / n * (1.0 + 3.0 * cot * cot) / (6.0 * cot);
}

struct Bore {
  double area;  // m2
  int corners;
};

/// Mass and inertia of the outline less those of the bore.
inline engine::Body bored(const engine::Shape& shape, Bore bore, double density, double height) {
  const engine::AreaProperties outline = engine::area_properties(shape);
  engine::Body body;
  body.shape = shape;
  body.thickness = height;
  body.mass = density * height * (outline.area - bore.area);
  body.inertia = density * height * (outline.second_moment - regular_polygon_moment(bore.area, bore.corners));
  return body;
}

inline bool on_ring(int i, int j) {
  return i == 0 || j == 0 || i == 5 || j == 5;
}

/// The octagon less its bore, and the four keys, which are lower.
inline engine::Body interstitial_body(double density, double height) {
  engine::Body body = bored(octagon(), {0.01228, 24}, density, height);
  const engine::AreaProperties key = engine::area_properties(engine::make_polygon(bearing_key()).polygon);
  const double arm = 0.5 * (0.11025 + 0.14);  // m, from the brick's middle to a key's
  const double mass = density * key_height * key.area;
  body.shape = interstitial_brick();
  *body.mass += 4.0 * mass;
  *body.inertia += 4.0 * (density * key_height * key.second_moment + mass * arm * arm);
  return body;
}

}  // namespace bricks

/// At rest relative to the frame, which moves at t = 0.
inline engine::Scene brick_array(std::shared_ptr<const SweptSine> motion,
                                 const BrickArrayOptions& options = {}) {
  engine::Scene s;
  s.gravity = {};
  engine::Material graphite;
  graphite.name = "graphite";
  graphite.density = 1740.0;
  graphite.young_modulus = options.young_modulus;
  graphite.poisson_ratio = 0.21;
  graphite.friction_coefficient = options.friction;
  graphite.damping_ratio = engine::damping_ratio_for_restitution(options.restitution);
  s.materials = {graphite, graphite};
  s.materials[1].name = "key";
  s.materials[1].young_modulus *= options.key_stiffness;
  s.materials[1].damping_ratio = engine::damping_ratio_for_restitution(options.key_restitution);

  const double q = brick_pitch;
  const engine::Body fuel = bricks::bored(bricks::fuel_brick(), {0.053437, 24}, 1687.7, 0.907);
  const engine::Body interstitial = bricks::interstitial_body(1637.4, 0.907);
  const auto add = [&](engine::Body brick, const std::string& name, engine::Vec2 place, bool fixed) {
    if (fixed) {
      engine::Terrain terrain;
      terrain.name = name;
      terrain.shape = brick.shape;
      terrain.position = place;
      terrain.motion = motion;
      s.terrains.push_back(std::move(terrain));
      return;
    }
    brick.name = name, brick.position = place, brick.velocity = motion->at(0.0).velocity;
    s.bodies.push_back(std::move(brick));
  };
  const auto named = [](const char* kind, int i, int j) {
    return std::string(kind) + "(" + std::to_string(i) + ")(" + std::to_string(j) + ")";
  };
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      add(fuel, named("FB1", i, j), {i * q, j * q}, bricks::on_ring(i, j));
      if (i < 5 && j < 5) add(fuel, named("FB2", i, j), {(i + 0.5) * q, (j + 0.5) * q}, false);
      if (i < 5) add(interstitial, named("IB1", i, j), {(i + 0.5) * q, j * q}, j == 0 || j == 5);
      if (j < 5) add(interstitial, named("IB2", i, j), {i * q, (j + 0.5) * q}, i == 0 || i == 5);
    }
  engine::Body key;
  key.shape = engine::make_rectangle(0.0735, 0.02495);
  key.material = 1, key.thickness = bricks::key_height;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 4; ++k) {
        const engine::Vec2 corner = bricks::quarter_turns({0.25 * q, 0.25 * q}, k);
        key.angle = (k % 2 == 0 ? 0.25 : -0.25) * std::numbers::pi;
        add(key, named("LK", i, j) + std::to_string(k + 1),
            engine::Vec2{(i + 0.5) * q, (j + 0.5) * q} + corner, false);
      }
  return s;
}

struct BrickVelocities {
  std::vector<double> frequency;  // Hz, middle of each window
  std::map<std::string, std::vector<double>>
      ratio;  // of each brick: mean |velocity in x| over that of the frame
  engine::RunOutcome outcome;
};

/// The ratio of mean velocities along the sweep over windows of `window` (s).
inline BrickVelocities measured_velocities(const engine::Scene& scene, const SweptSine& motion,
                                           const std::vector<std::string>& names, double end, double window,
                                           double step_fraction = 0.5) {
  Running r(scene);
  std::vector<std::size_t> bodies;
  for (const std::string& name : names)
    bodies.push_back(static_cast<std::size_t>(std::find(r.model.names.begin(), r.model.names.end(), name) -
                                              r.model.names.begin()));
  BrickVelocities measured;
  std::vector<double> sums(names.size());
  double frame = 0.0;
  const double interval = 1e-3;
  const long per_window = std::lround(window / interval);
  long count = 0;
  auto options = run_for(end, interval);
  options.step_fraction = step_fraction;
  measured.outcome = r.run(options, [&](const engine::Sample& sample) {
    const double t = sample.state.time;
    frame += std::abs(motion.at(t).velocity.x);
    for (std::size_t k = 0; k < bodies.size(); ++k) sums[k] += std::abs(r.velocity(bodies[k]).x);
    if (++count % per_window != 0) return engine::Wish::go_on;
    measured.frequency.push_back(motion.frequency(t - 0.5 * window));
    for (std::size_t k = 0; k < bodies.size(); ++k) measured.ratio[names[k]].push_back(sums[k] / frame);
    std::fill(sums.begin(), sums.end(), 0.0);
    frame = 0.0;
    return engine::Wish::go_on;
  });
  return measured;
}

}  // namespace dougong::scenes
