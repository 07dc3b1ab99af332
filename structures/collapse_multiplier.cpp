#include "structures/collapse_multiplier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dougong::structures {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("collapse multiplier: " + what);
}

void check(const engine::Scene& scene, const TrialOptions& options) {
  require(!scene.bodies.empty(), "expected a scene with blocks, found none");
  require(engine::norm(scene.gravity) > 0.0, "expected a scene with gravity, found none");
  require(options.hold_time > 0.0 && options.longest_time > 0.0, "expected positive times of a trial");
  require(options.away > 0.0, "expected a positive movement that counts as falling");
}

/// The least width of the smallest block is what a movement is measured by.
double away_distance(const engine::Model& model, const TrialOptions& options) {
  double width = infinity;
  for (std::size_t i = 0; i < model.body_count; ++i) width = std::min(width, model.minimum_width[i]);
  return options.away * width;
}

void note_movement(const engine::Model& model, const engine::State& state, const std::vector<double>& before,
                   Trial& trial) {
  const std::size_t n = model.body_count;
  trial.greatest_movement = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double movement = engine::norm({state.y[i] - before[i], state.y[n + i] - before[n + i]});
    if (movement <= trial.greatest_movement) continue;
    trial.greatest_movement = movement;
    trial.moved_most = model.names[i];
  }
}

/// Returns whether the blocks are at rest.
bool come_to_rest(const engine::Model& model, engine::State& state, double away, const TrialOptions& options,
                  Trial& trial) {
  engine::SettleOptions settle_options;
  settle_options.longest_time = options.longest_time;
  settle_options.unbalanced_ratio = options.unbalanced_ratio;
  settle_options.local_damping = options.local_damping;
  settle_options.longest_movement = away;
  const engine::SettleReport report = engine::settle(model, state, settle_options);
  trial.duration = report.duration;
  trial.unbalanced_ratio = report.unbalanced_ratio;
  trial.detail = report.detail;
  if (report.outcome == engine::Outcome::diverged) trial.result = TrialResult::numerically_invalid;
  return report.settled;
}

/// Movements are those since `before`; the trial stands if none is too long in that time (s).
void watch(const engine::Model& model, engine::State& state, double away, double time,
           const std::vector<double>& before, Trial& trial) {
  engine::DriveOptions drive_options;
  drive_options.end_time = time;
  drive_options.terrain_held_still = true;
  const engine::RunOutcome run =
      engine::drive(model, state, drive_options, [&](const engine::Sample& sample) {
        note_movement(model, sample.state, before, trial);
        return trial.greatest_movement > away ? engine::Wish::stop : engine::Wish::go_on;
      });
  trial.duration += run.end_time;
  trial.watched += run.end_time;
  trial.detail = run.detail;
  trial.kinetic_energy = engine::energies_of(model, state).kinetic;
  trial.result = TrialResult::undecided;
  if (run.outcome == engine::Outcome::diverged) trial.result = TrialResult::numerically_invalid;
  if (run.outcome == engine::Outcome::completed) trial.result = TrialResult::stands;
}

void conclude(const engine::Model& model, const engine::State& state, double away,
              const std::vector<double>& before, Trial& trial) {
  note_movement(model, state, before, trial);
  if (trial.result == TrialResult::undecided && trial.greatest_movement > away)
    trial.result = TrialResult::falls;
}

std::vector<BlockMotion> motion_between(const engine::State& before, const engine::State& after) {
  const std::size_t n = before.q().size() / 3;
  std::vector<BlockMotion> motions(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto moved = [&](std::size_t k) { return after.q()[k] - before.q()[k]; };
    motions[i] = {{moved(i), moved(n + i)}, moved(2 * n + i)};
  }
  return motions;
}

/// A multiplier that a trial stood, with the state it left and the poses from which it began.
struct Stood {
  Trial trial;
  engine::State state;
  std::vector<double> before;
  bool to_the_end = false;  // it was watched for the whole of hold_time
};

/// The bracket as it is, and the trials that stood below it, the lower the earlier.
class Search {
 public:
  Search(const engine::Scene& scene, const LoadedScene& loaded, const TiltOptions& options)
      : loaded_(loaded), options_(options), step_(options.first_increment) {
    start_ = engine::initial_state(engine::compile(scene), scene);
    found_.falls = infinity;
  }

  CollapseMultiplier run() {
    attempt(0.0);
    while (!ended_ && !stood_.empty()) {
      if (!finished())
        attempt(next());
      else if (is_sure() || watch_on())
        break;
    }
    if (ended_) found_.end = TrialResult::undecided;
    if (stood_.empty()) found_.falls = 0.0;
    found_.stands = stands();
    found_.standing = standing();
    return std::move(found_);
  }

 private:
  double stands() const { return stood_.empty() ? 0.0 : stood_.back().trial.multiplier; }
  const engine::State& standing() const { return stood_.empty() ? start_ : stood_.back().state; }

  bool narrow() const { return found_.falls - stands() <= options_.precision * found_.falls; }
  bool finished() const {
    if (found_.end == TrialResult::numerically_invalid || stands() >= options_.largest) return true;
    return std::isfinite(found_.falls) && narrow() && fell_from_ == stands();
  }
  bool is_sure() const { return found_.end == TrialResult::numerically_invalid || stood_.back().to_the_end; }
  double next() const {
    if (!std::isfinite(found_.falls)) return std::min(options_.largest, stands() + step_);
    return narrow() ? found_.falls : 0.5 * (stands() + found_.falls);
  }

  void attempt(double multiplier) {
    engine::State state = standing();
    std::vector<double> before = state.y;
    TrialOptions shortly = options_.trial;
    shortly.hold_time *= options_.preliminary_hold;
    Trial trial = hold(loaded_(multiplier), state, shortly);
    trial.multiplier = multiplier;
    note(trial, state);
    trial.result == TrialResult::stands
        ? stood({trial, std::move(state), std::move(before), options_.preliminary_hold == 1.0})
        : fell(trial, state);
  }

  /// The rest of the watch of the lower end; whether it stood.
  bool watch_on() {
    Stood last = std::move(stood_.back());
    stood_.pop_back();
    const engine::Model model = engine::compile(loaded_(last.trial.multiplier));
    const double away = away_distance(model, options_.trial);
    const double rest = (1.0 - options_.preliminary_hold) * options_.trial.hold_time;
    watch(model, last.state, away, rest, last.before, last.trial);
    conclude(model, last.state, away, last.before, last.trial);
    note(last.trial, last.state);
    if (last.trial.result != TrialResult::stands) {
      fell(last.trial, last.state);
      return false;
    }
    last.to_the_end = true;
    stood_.push_back(std::move(last));
    return true;
  }

  void note(Trial& trial, const engine::State& state) {
    trial.broken_points = state.bonds.broken;
    found_.trials.push_back(trial);
    ended_ = options_.go_on && !options_.go_on(trial);
  }

  void stood(Stood trial) {
    const double multiplier = trial.trial.multiplier;
    // The upper end did not hold on the slower path: look further up, from its distance.
    if (multiplier == found_.falls)
      step_ = multiplier - stands(), found_.falls = infinity;
    else
      step_ = std::min(2.0 * step_, options_.first_increment);
    stood_.push_back(std::move(trial));
    found_.end = TrialResult::stands;
  }
  void fell(const Trial& trial, const engine::State& state) {
    found_.falls = trial.multiplier;
    found_.end = trial.result;
    found_.mechanism = motion_between(standing(), state);
    fell_from_ = stands();
  }

  const LoadedScene& loaded_;
  const TiltOptions& options_;
  bool ended_ = false;
  double step_;
  double fell_from_ = infinity;
  engine::State start_;
  std::vector<Stood> stood_;
  CollapseMultiplier found_;
};

}  // namespace

std::string to_string(TrialResult result) {
  switch (result) {
    case TrialResult::stands:
      return "stands";
    case TrialResult::falls:
      return "falls";
    case TrialResult::undecided:
      return "undecided";
    case TrialResult::numerically_invalid:
      return "numerically invalid";
  }
  return "";
}

engine::Scene tilted(const engine::Scene& scene, double multiplier, Direction towards) {
  engine::Scene turned = scene;
  const double cosine = 1.0 / std::sqrt(1.0 + multiplier * multiplier);
  const double sine = (towards == Direction::right ? 1.0 : -1.0) * multiplier * cosine;
  const engine::Vec2 g = scene.gravity;
  turned.gravity = {cosine * g.x - sine * g.y, sine * g.x + cosine * g.y};
  return turned;
}

Trial hold(const engine::Scene& scene, engine::State& state, const TrialOptions& options) {
  check(scene, options);
  const engine::Model model = engine::compile(scene);
  const std::vector<double> before = state.y;
  const double away = away_distance(model, options);
  Trial trial;
  if (come_to_rest(model, state, away, options, trial))
    watch(model, state, away, options.hold_time, before, trial);
  conclude(model, state, away, before, trial);
  return trial;
}

CollapseMultiplier find_collapse_multiplier(const engine::Scene& scene, const TiltOptions& options) {
  return find_collapse_multiplier(
      scene, [&](double multiplier) { return tilted(scene, multiplier, options.towards); }, options);
}

CollapseMultiplier find_collapse_multiplier(const engine::Scene& scene, const LoadedScene& loaded,
                                            const TiltOptions& options) {
  check(scene, options.trial);
  require(options.first_increment > 0.0 && options.largest > 0.0, "expected positive steps of the load");
  require(options.precision > 0.0 && options.precision < 1.0, "expected a precision between 0 and 1");
  require(options.preliminary_hold > 0.0 && options.preliminary_hold <= 1.0,
          "expected a preliminary hold of a part of the whole, above 0");
  return Search(scene, loaded, options).run();
}

}  // namespace dougong::structures
