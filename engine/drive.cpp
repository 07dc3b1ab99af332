#include "engine/drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/dynamics.h"
#include "engine/integrators/table.h"

namespace dougong::engine {
namespace {

// Once gravity has given this many times what the ground put in, debris hits hard and the error of its
// impacts counts beside the input: the step is this part of what it was, their error a tenth
// (docs/validation.md).
constexpr double gravity_driven = 10.0, step_of_impacts = 0.5;
// A method of first order errs by 1/(2 n) of what it turned over in n steps from rest.
constexpr std::size_t steps_before_judging = 20;
constexpr double no_bound = std::numeric_limits<double>::infinity();

void check_options(const DriveOptions& options) {
  if (!(options.end_time >= 0.0) || !std::isfinite(options.end_time))
    throw std::invalid_argument("end time must not be negative");
  if (!(options.output_interval > 0.0)) throw std::invalid_argument("output interval must be positive");
  if (!(options.step_fraction > 0.0 && options.step_fraction < 1.0))
    throw std::invalid_argument("step fraction must lie between 0 and 1");
  if (!(options.tolerance >= 1e-15 && options.tolerance <= 0.1))
    throw std::invalid_argument("tolerance must lie between 1e-15 and 0.1");
  if (options.threads == 0) throw std::invalid_argument("threads must be at least 1");
  if (options.step && !(*options.step > 0.0)) throw std::invalid_argument("step must be positive");
}

// Output times and record samples must both be multiples of the base interval.
struct Intervals {
  double base, output;
  std::size_t bases_per_output;
};

Intervals choose_intervals(double knot, double output) {
  if (knot <= 0.0) return {output, output, 1};
  if (output >= knot) {
    const auto k = static_cast<std::size_t>(std::llround(output / knot));
    return {knot, static_cast<double>(k) * knot, k};
  }
  const double parts = std::max(1.0, std::round(knot / output));
  return {knot / parts, knot / parts, 1};
}

double bound_of(const AnyIntegrator& integrator, const SpectralBound& spectrum) {
  if (spectrum.stiffness <= 0.0 && spectrum.damping <= 0.0) return no_bound;
  return std::visit([&](const auto& i) { return i.stable_step(spectrum.stiffness, spectrum.damping); },
                    integrator);
}

std::size_t steps_per_interval(double interval, double largest_step) {
  return std::max<std::size_t>(1,
                               static_cast<std::size_t>(std::ceil(interval / largest_step * (1.0 - 1e-12))));
}

// One run: the loop and what it needs at hand.
class Runner {
 public:
  Runner(const Model& model, State& state, const DriveOptions& options)
      : model_(model),
        state_(state),
        options_(options),
        integrator_(make_integrator(options.integrator)),
        crew_(options.threads),
        dynamics_(model, state, options.terrain_held_still, options.local_damping),
        stability_(model),
        accelerations_(3 * model.body_count),
        frames_(model.size()),
        intervals_(choose_intervals(options.terrain_held_still ? 0.0 : model.knot_interval(),
                                    options.output_interval)) {
    std::visit(
        [&]<class I>(I& i) {
          longest_step_ = I::traits.longest_step, rigid_ = I::traits.rigid_contacts;
          adaptive_ = I::traits.adaptive, name_ = I::traits.name;
          dynamics_.evaluated_once_a_step(I::traits.evaluations == 1);
          if constexpr (I::traits.adaptive) i.set_tolerance(options.tolerance);
        },
        integrator_);
    dynamics_.work_with(crew_);
    state_.contacts.make_rigid(model, place(), rigid_);
    if (rigid_ && model.has_rocking_restitution())
      throw std::invalid_argument(std::string(name_) +
                                  ": rigid contacts know no rocking restitution; leave it out, or choose "
                                  "an integrator with contact springs");
    if (rigid_) dynamics_.make_contacts_rigid();
  }

  StepPlan plan() {
    refresh_bound();
    if (bound_ == 0.0) return {intervals_.base, intervals_.output, 0.0, 0.0};
    divide(steps_per_interval(intervals_.base, largest_step()));
    return {intervals_.base, intervals_.output, step_size(), bound_};
  }

  RunOutcome run(const Observer& observe) {
    state_.time = 0.0;
    const StepPlan start = plan();
    outcome_.step = outcome_.smallest_step = start.step;
    outcome_.bound = start.bound;
    outcome_.output_interval = start.output_interval;
    if (bound_ == 0.0) return end(Outcome::step_too_large, no_stable_step());
    if (options_.step && *options_.step > start.bound)
      return end(Outcome::step_too_large, "a step of " + std::to_string(*options_.step) +
                                              " s is above the stability bound of " +
                                              std::to_string(start.bound) + " s");
    if (const std::string trouble = health_problem(); !trouble.empty())
      return end(Outcome::diverged, trouble);
    if (const Wish wish = sample(observe); wish != Wish::go_on) return end_as_wished(wish);
    const auto outputs = static_cast<std::size_t>(std::ceil(options_.end_time / intervals_.output - 1e-9));
    for (std::size_t output = 0; output < outputs; ++output) {
      for (std::size_t k = 0; k < intervals_.bases_per_output && bound_ > 0.0; ++k) advance_interval();
      if (bound_ == 0.0) return end(Outcome::step_too_large, no_stable_step());
      if (const std::string trouble = health_problem(); !trouble.empty())
        return end(Outcome::diverged, trouble);
      if (const Wish wish = sample(observe); wish != Wish::go_on) return end_as_wished(wish);
    }
    return end(Outcome::completed, "");
  }

 private:
  std::string no_stable_step() const {
    return std::string(name_) + " has no stable step here: any undamped vibration grows under it";
  }

  double largest_step() const {
    // A step that was asked for gives way when a contact appears that it would be unstable for.
    const bool as_asked = options_.step && *options_.step <= bound_;
    const double own = std::min(step_fraction() * bound_, longest_step_);
    return std::min(as_asked ? *options_.step : own, travel_);
  }

  double step_fraction() const { return options_.step_fraction * (falling_ ? step_of_impacts : 1.0); }

  // Everything where it is now.
  std::span<const Frame> place() {
    place_all(model_, state_, options_.terrain_held_still, frames_, crew_);
    return frames_;
  }

  void refresh_bound() {
    const std::span<const Frame> frames = place();
    if (!adaptive_) bound_ = bound_of(integrator_, stability_.assemble(model_, state_, frames, crew_));
    travel_ = state_.contacts.longest_step(model_, fastest_rim(model_, frames));
  }

  // After contacts have come, gone or changed.
  void renew_bound() {
    const std::span<const Frame> frames = place();
    const std::vector<Index> disturbed = state_.contacts.take_disturbed();
    if (!adaptive_) bound_ = bound_of(integrator_, stability_.renew(model_, state_, frames, disturbed));
    travel_ = state_.contacts.longest_step(model_, fastest_rim(model_, frames));
  }

  // A base interval in equal steps; what is left of it may be divided anew on the way.
  void advance_interval() {
    start_interval();
    while (left_ > 0 && bound_ > 0.0) {
      const bool changed = countdown_ == 0 && update_contacts();
      if (dynamics_.take_roused() || changed) refine();
      state_.time =
          (static_cast<double>(interval_) + from_ + static_cast<double>(taken_) * part_) * intervals_.base;
      step(step_size());
      ++taken_, --left_, --countdown_;
    }
    ++interval_;
    state_.time = static_cast<double>(interval_) * intervals_.base;
  }

  double step_size() const { return part_ * intervals_.base; }

  // What is left of the interval becomes so many steps.
  void divide(std::size_t steps) {
    part_ = (1.0 - from_) / static_cast<double>(steps);
    taken_ = 0, left_ = steps;
  }

  // The step that the contacts of now allow, unless the present one is about right.
  void start_interval() {
    refresh_bound();
    from_ = 0.0;
    if (bound_ == 0.0) return;
    const double before = step_size();
    const std::size_t wanted = steps_per_interval(intervals_.base, largest_step());
    const std::size_t present = steps_per_interval(intervals_.base, before);
    const bool changes = before > tolerated_step() || 4 * wanted < 3 * present;
    divide(changes ? wanted : present);
    if (changes) note_step(before);
  }

  // A bound that wanders a little must not change the step: a tenth of it is spare below the bound.
  double tolerated_step() const {
    const double stable = options_.step ? bound_ : std::min(1.1 * step_fraction() * bound_, bound_);
    return std::min(stable, travel_);
  }

  void note_step(double before) {
    countdown_ = 0;
    if (step_size() >= before) return;
    ++outcome_.step_reductions;
    outcome_.smallest_step = std::min(outcome_.smallest_step, largest_step());
  }

  // Divides what is left of the interval anew if the contacts no longer allow the step.
  void refine() {
    renew_bound();
    countdown_ = std::max<std::size_t>(countdown_, 1);
    if (bound_ == 0.0 || step_size() <= tolerated_step()) return;
    const double before = step_size();
    from_ += static_cast<double>(taken_) * part_;
    divide(steps_per_interval((1.0 - from_) * intervals_.base, largest_step()));
    note_step(before);
    countdown_ = 1;
  }

  // Whether bodies have become so fast since the interval began that the step is too long for them. It may
  // be half as long again as longest_step() says: that leaves the bodies less than the margin.
  bool runs_away(double speed) {
    travel_ = state_.contacts.longest_step(model_, speed);
    return step_size() > 1.5 * travel_;
  }

  // Returns whether the step may have to change.
  bool update_contacts() {
    const std::span<const Frame> frames = place();
    const bool changed = state_.contacts.update(model_, frames, crew_);
    state_.work.bonds -= state_.contacts.take_inherited();
    const double speed = fastest_rim(model_, frames);
    countdown_ = state_.contacts.steps_until_update(model_, speed, step_size());
    // Many evaluations a step: looking at the contacts before each costs little.
    if (adaptive_) countdown_ = 1;
    if (changed && adaptive_) restart();
    return changed || runs_away(speed);
  }

  void restart() {
    std::visit([](auto& i) { i.restart(); }, integrator_);
  }

  void step(double h) {
    const Powers work = std::visit(
        [&](auto& i) { return i.step(dynamics_, state_.time, h, state_.q(), state_.v()); }, integrator_);
    state_.work.input += work.values[0];
    state_.work.damping += work.values[1];
    state_.work.tangential += work.values[2];
    state_.work.bonds += work.values[3];
    state_.work.stagger += work.values[4];
    ++outcome_.steps;
    if (state_.bonds.cracked) let_go();
    if (state_.bonds.loosened) loosen();
  }

  // What nothing ties any longer is damped as any contact.
  void loosen() {
    state_.contacts.limit_damping(tied_pairs(model_, state_.bonds));
    state_.bonds.loosened = false;
    countdown_ = 1;
  }

  // What a joined face held touches from now on; the contacts store what its points had stored.
  void let_go() {
    const std::span<const Frame> frames = place();
    for (const ReleasedPair& pair : release_cracked(model_, state_.bonds, frames))
      if (!rigid_) state_.contacts.inherit(pair.bodies, pair.energy);
    state_.contacts.keep_apart(held_pairs(model_, state_.bonds));
    loosen();  // the step that ends now is counted yet
    restart();
  }

  std::string_view trouble() const {
    if (dynamics_.impulses() && !dynamics_.impulses()->trouble().empty())
      return dynamics_.impulses()->trouble();
    return std::visit(
        [](const auto& i) -> std::string_view {
          if constexpr (requires { i.trouble(); }) return i.trouble();
          return "";
        },
        integrator_);
  }

  std::string health_problem() {
    const std::size_t n = model_.body_count;
    if (!trouble().empty()) return std::string(name_) + ": " + std::string(trouble());
    for (std::size_t i = 0; i < state_.y.size(); ++i)
      if (!std::isfinite(state_.y[i])) return "the motion of " + model_.names[i % n] + " is not finite";
    if (state_.deepest_ratio > options_.largest_overlap_ratio)
      return model_.names[state_.deepest_pair.a] + " and " + model_.names[state_.deepest_pair.b] +
             " overlap by more than " + std::to_string(options_.largest_overlap_ratio) +
             " of the smaller one";
    // Local damping takes energy that no ledger follows.
    if (options_.local_damping == 0.0) turnover_.note(energies_of(model_, state_));
    falling_ =
        turnover_.turnover() > gravity_driven * turnover_.largest_input() && turnover_.largest_input() > 0.0;
    if (outcome_.steps >= steps_before_judging && turnover_.largest_error() > energy_of_rest() &&
        turnover_.relative_error() > options_.largest_energy_error)
      return "the energy balance is off by " + std::to_string(turnover_.relative_error()) +
             " of the energy turned over";
    return "";
  }

  // Of all bodies at a micrometre a second: where a record begins, so little moves that nothing is wrong yet.
  double energy_of_rest() const {
    constexpr double speed = 1e-6;  // m/s
    return 0.5 * model_.total_mass() * speed * speed;
  }

  Wish sample(const Observer& observe) {
    if (!observe) return Wish::go_on;
    dynamics_.observe(state_.time, state_.q(), state_.v(), accelerations_);
    note_progress();
    return observe({state_, accelerations_, dynamics_.terrain_reaction(), outcome_});
  }

  RunOutcome end_as_wished(Wish wish) {
    return end(wish == Wish::stop ? Outcome::stopped_by_criterion : Outcome::interrupted, "");
  }

  RunOutcome end(Outcome outcome, const std::string& detail) {
    outcome_.outcome = outcome;
    outcome_.detail = detail;
    note_progress();
    return outcome_;
  }

  void note_progress() {
    outcome_.end_time = state_.time;
    outcome_.evaluations = dynamics_.evaluations();
    if (dynamics_.impulses()) outcome_.impulses = dynamics_.impulses()->statistics();
  }

  const Model& model_;
  State& state_;
  DriveOptions options_;
  AnyIntegrator integrator_;
  bool adaptive_ = false;
  std::string_view name_;
  Crew crew_;
  Dynamics dynamics_;
  StabilityRows stability_;
  std::vector<double> accelerations_;
  std::vector<Frame> frames_;
  Intervals intervals_;
  RunOutcome outcome_;
  EnergyTurnover turnover_;
  double bound_ = no_bound;
  double travel_ = no_bound;        // s, ContactSet::longest_step
  double longest_step_ = no_bound;  // s, of the integrator's traits
  bool rigid_ = false, falling_ = false;
  std::size_t interval_ = 0, countdown_ = 0;
  // Of the interval: where the present steps began, the length of one; and how many were taken, are left.
  double from_ = 0.0, part_ = 1.0;
  std::size_t taken_ = 0, left_ = 1;
};

}  // namespace

std::string to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::completed:
      return "completed";
    case Outcome::diverged:
      return "diverged";
    case Outcome::step_too_large:
      return "step too large";
    case Outcome::stopped_by_criterion:
      return "stopped by criterion";
    case Outcome::interrupted:
      return "interrupted";
  }
  return "";
}

StepPlan plan_steps(const Model& model, const State& state, const DriveOptions& options) {
  check_options(options);
  State copy = state;
  return Runner(model, copy, options).plan();
}

RunOutcome drive(const Model& model, State& state, const DriveOptions& options, const Observer& observe) {
  check_options(options);
  return Runner(model, state, options).run(observe);
}

}  // namespace dougong::engine
