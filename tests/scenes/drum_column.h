// A tapered column of drums, or the same outline in one piece, on a ground that moves by a double pulse
// (comparison C04): a for t_p, -a/2 for 2 t_p, then nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::scenes {

struct DoublePulse {
  double acceleration, duration;  // m/s2; s, t_p

  double at(double t) const {
    return t < duration ? acceleration : (t < 3.0 * duration ? -0.5 * acceleration : 0.0);
  }
  double velocity(double t) const {
    const double second = std::clamp(t - duration, 0.0, 2.0 * duration);
    return acceleration * (std::min(t, duration) - 0.5 * second);
  }
  double displacement(double t) const {
    const double first = std::min(t, duration), second = std::clamp(t - duration, 0.0, 2.0 * duration);
    const double after_first = t - first;  // s, at the speed that the first part left
    const double after_second = t - duration - second;
    const double lost = 0.5 * second * second + (after_second > 0.0 ? second * after_second : 0.0);
    return acceleration * (0.5 * first * first + first * after_first - 0.5 * lost);
  }
  std::shared_ptr<const engine::PrescribedMotion> motion() const {
    const DoublePulse p = *this;
    return horizontal_motion([p](double t) { return p.at(t); }, [p](double t) { return p.velocity(t); },
                             [p](double t) { return p.displacement(t); });
  }
};

struct DrumColumn {
  double foot = 1.11, head = 0.90;                                              // m, full widths
  std::vector<double> heights{0.82, 0.82, 0.82, 0.82, 0.82, 0.82, 0.82, 0.21};  // m, from below
  double density = 2620.0, friction = 0.7;                                      // kg/m3, -
  double joint_stiffness = 5e10;                                                // Pa/m
  double damping_ratio = 0.0;
  double g = 9.81;

  double height() const {
    double sum = 0.0;
    for (const double h : heights) sum += h;
    return sum;
  }
  double half_width(double y) const { return 0.5 * (foot + (head - foot) * y / height()); }
};

/// A joint is as stiff as the blocks on both sides in series, 1/k = h_a/E_a + h_b/E_b (h from centroid to
/// face). Every other drum gives all of its two joints' flexibility, its neighbours none: so each joint, the
/// one on the rigid ground too, has the stiffness asked.
inline engine::Material drum_material(const DrumColumn& c, double centroid_to_face, bool soft) {
  engine::Material material;
  material.name = soft ? "soft drum" : "stiff drum";
  material.density = c.density;
  material.friction_coefficient = c.friction;
  material.damping_ratio = c.damping_ratio;
  material.young_modulus = centroid_to_face * c.joint_stiffness * (soft ? 1.0 : 1e4);
  return material;
}

inline engine::Scene drum_column(const DrumColumn& c, const DoublePulse& pulse) {
  engine::Scene s;
  s.gravity = {0.0, -c.g};
  s.materials = {drum_material(c, 0.5 * c.heights.front(), true),
                 drum_material(c, 0.5 * c.heights.front(), false)};
  double bottom = 0.0;
  for (const double h : c.heights) {
    const double b = c.half_width(bottom), t = c.half_width(bottom + h);
    const engine::Vec2 outline[] = {{-b, bottom}, {b, bottom}, {t, bottom + h}, {-t, bottom + h}};
    const engine::PlacedPolygon placed = engine::make_polygon(outline);
    engine::Body drum;
    drum.name = "drum " + std::to_string(s.bodies.size() + 1);
    drum.shape = placed.polygon;
    drum.position = placed.centroid;
    drum.material = s.bodies.size() % 2;
    s.bodies.push_back(std::move(drum));
    bottom += h;
  }
  s.terrains.push_back(ground(400.0, {}, 0.0, pulse.motion()));
  return s;
}

struct ColumnRun {
  bool collapsed = false, failed = false;
  double time = 0.0;  // s, of the collapse, or the end
  std::string detail;
};

/// It has collapsed when the top block has sunk by half the width of the foot: no rocking column, however it
/// leans without falling, sinks as far.
inline ColumnRun run_column(const DrumColumn& c, const DoublePulse& pulse, double quiet_time,
                            double step_fraction = 0.25) {
  Running r(drum_column(c, pulse));
  ColumnRun run;
  if (!engine::settle(r.model, r.state).settled) return {false, true, 0.0, "does not settle"};
  const std::size_t top = r.bodies() - 1;
  const double start = r.position(top).y;
  engine::DriveOptions options = run_for(3.0 * pulse.duration + quiet_time, pulse.duration / 20.0);
  options.step_fraction = step_fraction;
  const auto outcome = r.run(options, [&](const engine::Sample& sample) {
    run.collapsed = start - r.position(top).y > 0.5 * c.foot;
    run.time = sample.state.time;
    return run.collapsed ? engine::Wish::stop : engine::Wish::go_on;
  });
  run.failed = outcome.outcome == engine::Outcome::diverged;
  run.detail = outcome.detail;
  return run;
}

/// Whether the column collapses at this acceleration (m/s2) and at half a per cent more or less too. Undamped
/// drums bounce about chaotically: a few per cent of all accelerations far below the least collapse alone.
inline bool collapses_around(const DrumColumn& c, double acceleration, double duration,
                             double quiet_time = 6.0, double step_fraction = 0.25) {
  const auto collapses = [&](double a) {
    return run_column(c, {a, duration}, quiet_time, step_fraction).collapsed;
  };
  return collapses(acceleration) && (collapses(1.005 * acceleration) || collapses(0.995 * acceleration));
}

/// The least acceleration around which the column collapses, looked for from `from` upwards in steps of the
/// part `step` (a narrower range of collapse is missed), then bisected to a tenth of that (m/s2). Infinite if
/// it stands up to `to`.
inline double least_collapse(const DrumColumn& c, double duration, double from, double to, double step = 0.02,
                             double quiet_time = 6.0, double step_fraction = 0.25) {
  const auto collapses = [&](double a) {
    return collapses_around(c, a, duration, quiet_time, step_fraction);
  };
  double stands = from, falls = from;
  while (!collapses(falls)) {
    stands = falls, falls *= 1.0 + step;
    if (falls > to) return std::numeric_limits<double>::infinity();
  }
  while (falls - stands > 0.1 * step * falls) {
    const double middle = 0.5 * (stands + falls);
    (collapses(middle) ? falls : stands) = middle;
  }
  return 0.5 * (stands + falls);
}

/// Least acceleration for collapse in g, by duration: published by three codes, and of the monolith exactly.
struct DrumColumnRow {
  double duration, udec, lmgc90, hybridfem, monolith;  // s; g

  double lowest() const { return std::min({udec, lmgc90, hybridfem}); }
  double highest() const { return std::max({udec, lmgc90, hybridfem}); }
  double tolerance() const { return duration == 0.10 || duration == 0.35 ? 0.15 : 0.05; }
};
inline constexpr DrumColumnRow drum_column_rows[] = {
    {0.10, 3.60, 4.30, 4.16, 6.72},  {0.20, 1.46, 1.48, 1.46, 1.018}, {0.30, 0.87, 0.88, 0.88, 0.391},
    {0.35, 0.38, 0.43, 0.37, 0.327}, {0.40, 0.31, 0.30, 0.29, 0.291}, {0.50, 0.27, 0.25, 0.25, 0.252},
    {0.80, 0.22, 0.22, 0.22, 0.213}};

}  // namespace dougong::scenes
