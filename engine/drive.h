// Runs a scene: owns time, the step, output sampling, health checks and stop criteria.
//
// The step divides the base interval (the motion's knot interval, or a part of it), so that no step
// straddles a sample of the record: h = base / k. k follows from the stability bound of the contacts as
// they are; it is checked again whenever contacts change and every base interval, and grows by halving
// when a stiffer contact appears: counted, never silent. Fast
// bodies shorten it too, so that a contact is found before it closes. Time is an integer number of intervals.
// An adaptive integrator divides each step by its own error, so only fast bodies bound it; an integrator
// whose bound is 0 is refused (step_too_large).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/energy.h"
#include "engine/nonsmooth/contact_impulses.h"
#include "engine/stability.h"

namespace dougong::engine {

enum class Outcome { completed, diverged, step_too_large, stopped_by_criterion, interrupted };
std::string to_string(Outcome outcome);

struct DriveOptions {
  std::string integrator = "velocity-verlet";
  double tolerance = 1e-8;             // -, of an adaptive integrator, a sub-step (integrators/adaptive.h)
  double end_time = 0.0;               // s
  double output_interval = 0.01;       // s; rounded to the motion's knots
  double step_fraction = 0.5;          // of the stability bound, in (0, 1)
  std::optional<double> step;          // s; instead of the fraction: refused above the bound. Of an adaptive
                                       // integrator, the longest between two looks for contacts
  double largest_overlap_ratio = 0.2;  // over the smaller width: deeper has passed through, not touched
  double largest_energy_error = 0.5;   // of the energy turned over: more has been made out of nothing
  std::size_t threads = 1;             // that share every step; the results are the same
  bool terrain_held_still = false;
  double local_damping = 0.0;  // of Dynamics; only for finding an equilibrium
};

struct RunOutcome {
  Outcome outcome = Outcome::completed;
  std::string detail;            // body, quantity, time
  double end_time = 0.0;         // s, reached
  double step = 0.0;             // s, the first
  double smallest_step = 0.0;    // s
  double bound = 0.0;            // s, stability bound at the start
  double output_interval = 0.0;  // s, as used
  std::size_t steps = 0;
  std::size_t step_reductions = 0;
  std::size_t evaluations = 0;  // of the forces
  ImpulseStatistics impulses;   // of rigid contacts
};

/// A state at an output time, with what only the running system knows.
struct Sample {
  const State& state;
  std::span<const double> accelerations;  // [x | y | angle], m/s2 and rad/s2
  Vec2 terrain_reaction;                  // N, of the terrains on the bodies
  const RunOutcome& so_far;               // as if the run ended here
};
/// What an observer wants next. The run's outcome tells which of the two ended it.
enum class Wish { go_on, stop, interrupt };
/// Called at t = 0 and at every output time.
using Observer = std::function<Wish(const Sample&)>;

/// What drive() would do: the step and bound it would start with. Throws std::invalid_argument for an
/// unknown integrator (naming the known ones) or options out of range.
struct StepPlan {
  double base_interval = 0.0, output_interval = 0.0, step = 0.0, bound = 0.0;  // s
};
StepPlan plan_steps(const Model& model, const State& state, const DriveOptions& options);

RunOutcome drive(const Model& model, State& state, const DriveOptions& options, const Observer& observe);

}  // namespace dougong::engine
