#include "engine/nonsmooth/contact_impulses.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dougong::engine {
namespace {

// Of the fastest body's speed, beside what gravity gives in a step.
constexpr double part_of_speed = 0.01;
// Impacts no faster than this many times gravity's share of a step are plastic: what bounces comes to rest.
constexpr double slowest_bounce = 2.0;
// Points further apart, over the smaller body's width, cannot close in a step (contact_set.cpp: margin).
constexpr double out_of_reach = 0.04;
constexpr double gain_by_rounding = 1e-9;
constexpr double rounding = 1e-9;

// Round contacts measure their slip from the last step (contact_points.h).
void rebase(ContactPoints& points, std::size_t i, std::span<const Frame> frames) {
  const PointGeometry g = geometry_of(points, i, frames);
  PointHistory history = points.history(i);
  history.anchor -= g.position;
  history.direction = g.normal;
  history.angle_corner = frames[points.corner_body[i]].angle;
  history.angle_edge = frames[points.edge_body[i]].angle;
  points.set_history(i, history);
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

bool slid(const PointPast& past, double friction) {
  return std::abs(past.friction) >= (1.0 - rounding) * friction * past.dashpot;
}

double speed_of(const PlaneVelocity& v) {
  return std::abs(v.x) + std::abs(v.y);
}

}  // namespace

ContactImpulses::ContactImpulses(const Model& model) : model_(model) {
  for (const PairRule& rule : model.rules)
    restitution_.push_back(restitution_for_damping_ratio(rule.damping_ratio));
  problem_.bodies = model.body_count;
  for (std::size_t i = 0; i < model.size(); ++i) {
    problem_.inverse_mass.push_back(model.is_terrain(static_cast<Index>(i)) ? 0.0 : 1.0 / model.mass[i]);
    problem_.inverse_inertia.push_back(model.is_terrain(static_cast<Index>(i)) ? 0.0
                                                                               : 1.0 / model.inertia[i]);
  }
  problem_.velocity.resize(model.size());
  problem_.free_velocity.resize(model.size());
  before_.resize(model.size());
  given_.resize(model.body_count);
}

double ContactImpulses::restitution_of(Index corner, Index edge) const {
  return restitution_[model_.material_index[corner] * model_.material_count + model_.material_index[edge]];
}

void ContactImpulses::read_velocities(std::span<const Frame> frames, std::span<const Vec2> terrains_before,
                                      std::span<const double> before, std::span<const double> v) {
  const std::size_t n = model_.body_count;
  for (std::size_t i = 0; i < n; ++i) {
    before_[i] = {before[i], before[n + i], before[2 * n + i]};
    problem_.free_velocity[i] = {v[i], v[n + i], v[2 * n + i]};
    given_[i] = {v[i] - before[i], v[n + i] - before[n + i], v[2 * n + i] - before[2 * n + i]};
  }
  for (std::size_t i = n; i < model_.size(); ++i) {
    before_[i] = {terrains_before[i - n].x, terrains_before[i - n].y, 0.0};
    problem_.free_velocity[i] = {frames[i].vx, frames[i].vy, 0.0};
  }
}

ImpulsePoint ContactImpulses::point_of(const ContactPoints& points, std::size_t i, const PointGeometry& g) {
  ImpulsePoint p;
  p.source = static_cast<std::uint32_t>(i);
  p.corner = points.corner_body[i], p.edge = points.edge_body[i];
  p.normal = g.normal, p.arm_corner = g.arm_corner, p.arm_edge = g.arm_edge;
  p.friction = points.stiffness(i).friction;
  return p;
}

ContactImpulses::Approach ContactImpulses::approach_of(const ContactPoints& points, const ImpulsePoint& p,
                                                       const PointGeometry& g, double h) const {
  const double kept = points.past(p.source).overlap;
  Approach a;
  a.overlap = g.overlap, a.slip = g.slip, a.position = g.position;
  // The anchor of a point that slid was set for the middle of a step of the same length.
  if (slid(points.past(p.source), p.friction) && std::abs(h - last_step_) > rounding * h) a.slip = 0.0;
  a.gap = (points.open(p.source) ? std::max(0.0, kept) : kept) - g.overlap;
  a.guess = {h * points.past(p.source).dashpot, -h * points.past(p.source).friction};
  a.before = relative_velocity(p, before_);
  // What overlaps and parts already, after another impact in its step, is not thrown apart.
  if (points.open(p.source) && a.before.x > 0.0) a.gap = std::max(a.gap, 0.0);
  const double given = relative_velocity(p, problem_.free_velocity).x - a.before.x;
  a.fast = a.before.x < -slowest_bounce * std::max(norm(model_.gravity) * h, std::abs(given));
  a.impact = a.fast && a.gap < -0.5 * h * a.before.x;
  a.restitution = restitution_of(p.corner, p.edge);
  return a;
}

void ContactImpulses::collect(const ContactPoints& points, std::span<const Frame> frames, double h) {
  problem_.points.clear(), approaches_.clear();
  problem_.points.reserve(points.size()), approaches_.reserve(points.size());
  deepest_ratio_ = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    const double depth = g.overlap * points.inverse_width(i);
    if (depth < -out_of_reach) continue;
    if (depth > deepest_ratio_) deepest_ratio_ = depth, deepest_point_ = i;
    ImpulsePoint p = point_of(points, i, g);
    const Approach a = approach_of(points, p, g, h);
    if (a.fast && !a.impact) continue;  // it is on its way
    problem_.points.push_back(p), approaches_.push_back(a);
  }
}

// What every point asks for at a stage of the step.
void ContactImpulses::set_biases(double h, Stage stage, bool plastic) {
  constexpr double not_yet = 1e100;
  for (std::size_t k = 0; k < approaches_.size(); ++k) {
    const Approach& a = approaches_[k];
    ImpulsePoint& p = problem_.points[k];
    p.bias = {a.gap / h, a.slip / h};
    if (!a.impact) continue;
    if (stage == Stage::before_impacts) p.bias.x = not_yet;
    if (stage == Stage::impacts)
      p.bias.x = plastic ? 0.0 : a.restitution * relative_velocity(p, problem_.free_velocity).x;
    if (stage == Stage::after_impacts) p.bias.x = 0.0;
  }
}

// What residuals are measured by (m/s).
double ContactImpulses::speed_scale(double h) const {
  double fastest = 0.0;
  for (const PlaneVelocity& v : problem_.free_velocity) fastest = std::max(fastest, speed_of(v));
  return part_of_speed * fastest + norm(model_.gravity) * h;
}

bool ContactImpulses::solve(double h) {
  const ImpulseSolution s = solver_.solve(problem_, speed_scale(h));
  ++statistics_.solves;
  statistics_.iterations += s.iterations;
  statistics_.most_iterations = std::max(statistics_.most_iterations, s.iterations);
  if (s.converged)
    statistics_.worst_residual = std::max(statistics_.worst_residual, s.residual / speed_scale(h));
  if (!s.converged)
    trouble_ = "the contact impulses did not converge: a point fails its law by " + number(s.residual) +
               " m/s after " + std::to_string(s.iterations) + " iterations";
  return s.converged;
}

// Energy that the impulses gave, over that which they turned over.
double ContactImpulses::work_gained() const {
  double gained = 0.0, turned_over = 0.0;
  for (const ImpulsePoint& p : problem_.points) {
    const Vec2 mean =
        0.5 * (relative_velocity(p, problem_.free_velocity) + relative_velocity(p, problem_.velocity));
    const double work = dot(p.impulse, mean);
    gained += work, turned_over += std::abs(work);
  }
  return turned_over > 0.0 ? gained / turned_over : 0.0;
}

void ContactImpulses::guess(double part) {
  for (std::size_t k = 0; k < approaches_.size(); ++k)
    problem_.points[k].impulse = part * approaches_[k].guess;
}

void ContactImpulses::add_to_total() {
  for (std::size_t k = 0; k < approaches_.size(); ++k) approaches_[k].total += problem_.points[k].impulse;
}

// Half of what the smooth forces give, from the velocities as they are.
void ContactImpulses::give_half() {
  for (std::size_t i = 0; i < problem_.bodies; ++i) {
    PlaneVelocity& v = problem_.free_velocity[i];
    const PlaneVelocity &now = problem_.velocity[i], &given = given_[i];
    v = {now.x + 0.5 * given.x, now.y + 0.5 * given.y, now.spin + 0.5 * given.spin};
  }
}

void ContactImpulses::solve_whole(double h) {
  set_biases(h, Stage::after_impacts, false);
  guess(1.0);
  solve(h);
  add_to_total();
}

// The contacts that last through the first half of the step, the impacts, the second half.
void ContactImpulses::solve_with_impacts(double h) {
  std::copy_n(before_.begin(), problem_.bodies, problem_.velocity.begin());
  give_half();
  set_biases(h, Stage::before_impacts, false);
  guess(0.5);
  solve(h);
  add_to_total();

  problem_.free_velocity = problem_.velocity;
  for (const bool plastic : {false, true}) {
    set_biases(h, Stage::impacts, plastic);
    guess(0.0);
    solve(h);
    if (work_gained() <= gain_by_rounding) break;
    statistics_.plastic_instead += plastic ? 0 : 1;
  }
  add_to_total();

  give_half();
  set_biases(h, Stage::after_impacts, false);
  guess(0.5);
  solve(h);
  add_to_total();
}

Powers ContactImpulses::apply(ContactPoints& points, std::span<const Frame> frames, double h,
                              std::span<const Vec2> terrains_before, std::span<const double> before,
                              std::span<double> v) {
  read_velocities(frames, terrains_before, before, v);
  collect(points, frames, h);
  const bool impacts = std::any_of(approaches_.begin(), approaches_.end(), [](auto& a) { return a.impact; });
  if (impacts)
    solve_with_impacts(h);
  else
    solve_whole(h);
  const std::size_t n = model_.body_count;
  for (std::size_t i = 0; i < n; ++i) {
    const PlaneVelocity& u = problem_.velocity[i];
    v[i] = u.x, v[n + i] = u.y, v[2 * n + i] = u.spin;
  }
  return commit(points, frames, h);
}

// The impulses' work on the bodies by way of terrains that move.
double ContactImpulses::input_of(const ImpulsePoint& p, Vec2 total) const {
  const Vec2 impulse = total.x * p.normal + total.y * turned(p.normal);
  const auto carried = [&](Index body) {
    const PlaneVelocity &after = problem_.velocity[body], &before = before_[body];
    return model_.is_terrain(body) ? 0.5 * Vec2{before.x + after.x, before.y + after.y} : Vec2{};
  };
  return dot(impulse, carried(p.edge) - carried(p.corner));
}

void ContactImpulses::commit_point(ContactPoints& points, const ImpulsePoint& p, const Approach& a,
                                   Vec2 after, double h) const {
  PointHistory history = points.history(p.source);
  PointPast past = points.past(p.source);
  // Where it will be at the next mid-step if it slides; where it stuck first if it does not.
  if (std::abs(a.total.y) >= (1.0 - rounding) * p.friction * a.total.x)
    history.anchor = a.position + h * after.y;
  else if (history.open)
    history.anchor = a.position;
  past.dashpot = a.total.x / h, past.friction = -a.total.y / h;
  history.open = !(a.total.x > 0.0);
  if (history.open)
    past.overlap = std::clamp(a.overlap, 0.0, std::max(0.0, past.overlap));
  else if (a.impact)
    past.overlap = a.overlap;
  else
    past.overlap = a.gap + a.overlap;
  points.set_history(p.source, history), points.set_past(p.source, past);
}

Powers ContactImpulses::commit(ContactPoints& points, std::span<const Frame> frames, double h) {
  last_step_ = h;
  Powers work{};
  std::size_t k = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (k < problem_.points.size() && problem_.points[k].source == i) {
      const ImpulsePoint& p = problem_.points[k];
      const Approach& a = approaches_[k++];
      const Vec2 after = relative_velocity(p, problem_.velocity), mean = 0.5 * (a.before + after);
      work = work + Powers{{input_of(p, a.total), -a.total.x * mean.x, -a.total.y * mean.y, 0.0}};
      commit_point(points, p, a, after, h);
    } else {
      PointHistory history = points.history(i);
      history.open = true;
      points.set_history(i, history), points.set_past(i, {});
    }
    if (points.kind[i] == FeatureKind::round) rebase(points, i, frames);
  }
  return work;
}

void ContactImpulses::mean_forces(const ContactPoints& points, std::span<const Frame> frames,
                                  std::span<PairLoad> loads) {
  std::fill(loads.begin(), loads.end(), PairLoad{});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    const PointPast past = points.past(i);
    const Vec2 force = past.dashpot * g.normal - past.friction * turned(g.normal);
    loads[i / 2].add(points.corner_is_b(i), force, cross(g.arm_corner, force), -cross(g.arm_edge, force));
  }
}

}  // namespace dougong::engine
