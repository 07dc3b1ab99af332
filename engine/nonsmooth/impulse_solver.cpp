#include "engine/nonsmooth/impulse_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::engine {
namespace {

// Of the residual, over the speed: what is aimed at, what a guess need not be improved below, and what will
// do where the aim is out of reach.
constexpr double aim = 1e-7, good_guess = 1e-6, tolerance = 1e-3;
// Of Newton's method. Rounding leaves about kappa times 1e-16 of the speeds.
constexpr double kappa = 1e6;
constexpr std::size_t first_iterations = 30, later_iterations = 8;
// Of the descents, one after the other: a soft one needs no good guess, a stiff one ends nearer.
constexpr double softest = 1e2, stiffest = 1e4;
constexpr std::size_t rounds_between = 4, most_rounds = 80;

// What an iteration leaves outside, by no more than its residual, must not pull or hold.
Vec2 within_cone(Vec2 impulse, double friction) {
  const double normal = std::max(0.0, impulse.x), limit = friction * normal;
  return {normal, std::clamp(impulse.y, -limit, limit)};
}

}  // namespace

ImpulseSolver::Status ImpulseSolver::status_of(const ImpulsePoint& p, Vec2 u) const {
  const double normal = p.impulse.x - (u.x + p.bias.x) / p.compliance.x;
  if (!(normal > 0.0)) return Status::open;
  const double tangential = p.impulse.y - (u.y + p.bias.y) / p.compliance.y;
  if (std::abs(tangential) < p.friction * normal) return Status::sticks;
  return tangential > 0.0 ? Status::slides_forward : Status::slides_back;
}

void ImpulseSolver::find_statuses(const ImpulseProblem& problem) {
  for (std::size_t i = 0; i < problem.points.size(); ++i)
    statuses_[i] = status_of(problem.points[i], relative_velocity(problem.points[i], problem.velocity));
}

void ImpulseSolver::prepare(const ImpulseProblem& problem) {
  matrix_.prepare(problem);
  change_.resize(problem.velocity.size());
  statuses_.resize(problem.points.size());
  best_.resize(problem.points.size()), start_.resize(problem.points.size());
  factorised_.clear();
  cone_.restart();
  best_residual_ = std::numeric_limits<double>::infinity();
}

void ImpulseSolver::assemble(const ImpulseProblem& problem) {
  matrix_.set_mass(problem);
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ImpulsePoint& p = problem.points[i];
    if (statuses_[i] == Status::open) continue;
    const double n = kappa / p.compliance.x, t = kappa / p.compliance.y;
    const double side = statuses_[i] == Status::slides_forward ? p.friction : -p.friction;
    matrix_.add(
        p, statuses_[i] == Status::sticks ? PointGain{n, 0.0, 0.0, t} : PointGain{n, 0.0, side * n, 0.0});
  }
}

void ImpulseSolver::add_to_right_side(const ImpulseProblem& problem, const ImpulsePoint& p, Vec2 impulse) {
  const Vec2 f = impulse.x * p.normal + impulse.y * turned(p.normal);
  PlaneVelocity &c = change_[p.corner], &e = change_[p.edge];
  if (p.corner < problem.bodies) c.x += f.x, c.y += f.y, c.spin += cross(p.arm_corner, f);
  if (p.edge < problem.bodies) e.x -= f.x, e.y -= f.y, e.spin -= cross(p.arm_edge, f);
}

// dP that the laws ask for once the relative velocity is u.
Vec2 ImpulseSolver::change_of(std::size_t i, const ImpulsePoint& p, Vec2 u) const {
  if (statuses_[i] == Status::open) return -p.impulse;
  const double normal = -kappa / p.compliance.x * (u.x + p.bias.x);
  if (statuses_[i] == Status::sticks) return {normal, -kappa / p.compliance.y * (u.y + p.bias.y)};
  const double side = statuses_[i] == Status::slides_forward ? p.friction : -p.friction;
  return {normal, side * (p.impulse.x + normal) - p.impulse.y};
}

// One iteration with the statuses as they are. Returns false where the system has no solution.
bool ImpulseSolver::step(ImpulseProblem& problem) {
  if (statuses_ != factorised_) {
    assemble(problem);
    factorised_.clear();
    if (!matrix_.factorise()) return false;
    factorised_ = statuses_;
  }
  std::fill(change_.begin(), change_.end(), PlaneVelocity{});
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ImpulsePoint& p = problem.points[i];
    add_to_right_side(problem, p, change_of(i, p, relative_velocity(p, problem.velocity)));
  }
  matrix_.solve(change_);
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    ImpulsePoint& p = problem.points[i];
    p.impulse += change_of(i, p, relative_velocity(p, problem.velocity) + relative_velocity(p, change_));
  }
  apply_impulses(problem);
  return true;
}

double ImpulseSolver::note(const ImpulseProblem& problem) {
  const double residual = residual_of(problem);
  if (residual < best_residual_) {
    best_residual_ = residual;
    for (std::size_t i = 0; i < problem.points.size(); ++i) best_[i] = problem.points[i].impulse;
  }
  return residual;
}

// From the impulses as they are, to which it returns if it does not get there.
void ImpulseSolver::iterate(ImpulseProblem& problem, std::size_t most, ImpulseSolution& solution) {
  for (std::size_t i = 0; i < problem.points.size(); ++i) start_[i] = problem.points[i].impulse;
  factorised_.clear();
  for (std::size_t k = 0; k < most && best_residual_ > target_; ++k) {
    find_statuses(problem);
    if (!step(problem)) break;
    ++solution.iterations;
    if (!std::isfinite(note(problem))) break;
  }
  set_impulses(problem, start_);
}

void ImpulseSolver::set_impulses(ImpulseProblem& problem, std::span<const Vec2> impulses) const {
  for (std::size_t i = 0; i < problem.points.size(); ++i) problem.points[i].impulse = impulses[i];
  apply_impulses(problem);
}

ImpulseSolution ImpulseSolver::solve(ImpulseProblem& problem, double speed) {
  prepare(problem);
  find_compliances(problem);
  apply_impulses(problem);
  note(problem);
  target_ = aim * speed;
  ImpulseSolution solution;
  double descent = softest;
  if (best_residual_ <= good_guess * speed) target_ = best_residual_;  // what rests costs nothing
  for (; solution.rounds < most_rounds && best_residual_ > target_; ++solution.rounds) {
    if (solution.rounds % rounds_between == 0)
      iterate(problem, solution.rounds == 0 ? first_iterations : later_iterations, solution);
    if (best_residual_ <= tolerance * speed) break;
    solution.iterations += cone_.step(problem, matrix_, descent, 0.3 * best_residual_);
    note(problem);
    descent = std::min(10.0 * descent, stiffest);
  }
  for (std::size_t i = 0; i < best_.size(); ++i) best_[i] = within_cone(best_[i], problem.points[i].friction);
  set_impulses(problem, best_);
  solution.residual = residual_of(problem);
  solution.converged = solution.residual <= tolerance * speed;
  return solution;
}

}  // namespace dougong::engine
