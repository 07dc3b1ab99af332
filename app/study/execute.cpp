#include "app/study/execute.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/study/code_screens.h"
#include "app/study/moments.h"
#include "app/study/output_times.h"
#include "app/study/recorder.h"
#include "app/study/run_sheets.h"
#include "app/study/stopwatch.h"
#include "app/study/weight_joints.h"

namespace dougong::app {
namespace {

bool stands(const Preparation& p) {
  return !p.scenario.solve.settle || p.settle.settled;
}

Numerics numerics_of(const Preparation& p, const engine::RunOutcome& run, const Recorder& recorder) {
  Numerics n = app::numerics_of(p.model, p.state, p.drive, run);
  n.asked_time = p.duration;
  n.overlap_ratio = recorder.overlap_ratio;
  n.mean_overlap_ratio = recorder.mean_overlap_ratio;
  if (!stands(p) && p.settle.outcome == engine::Outcome::completed)
    n.warnings.push_back(fmt::format("the building did not come to rest under its own weight within {:.1f} s",
                                     p.settle.duration));
  return n;
}

structures::NumericalEvidence evidence_of(const Numerics& n, const engine::RunOutcome& run,
                                          const Recorder& recorder) {
  using Outcome = structures::NumericalEvidence::Outcome;
  structures::NumericalEvidence e;
  e.outcome = run.outcome == engine::Outcome::completed              ? Outcome::completed
              : run.outcome == engine::Outcome::interrupted          ? Outcome::interrupted
              : run.outcome == engine::Outcome::stopped_by_criterion ? Outcome::stopped
                                                                     : Outcome::diverged;
  e.outcome_detail = run.detail;
  e.finite = std::isfinite(recorder.energies.energy.relative_error);
  e.energy_error_ratio = recorder.energies.energy.relative_error;
  e.deepest_overlap_ratio = n.deepest_overlap_ratio;
  e.deepest_overlap_where = n.deepest_overlap_where;
  e.end_time = n.end_time;
  e.asked_time = n.asked_time;
  e.greatest_speed_at_end = recorder.greatest_speed();
  return e;
}

// Two times: as described, and where the settle left it.
structures::Trajectory movement_of_settle(const Preparation& p) {
  structures::Trajectory t;
  t.times = {0.0, p.settle.duration};
  t.blocks = p.model.body_count;
  for (const engine::Body& body : p.building.scene.bodies)
    t.poses.insert(t.poses.end(), {body.position.x, body.position.y, body.angle});
  for (const engine::Frame& frame : engine::frames_of(p.model, p.state)) {
    if (t.poses.size() == 6 * t.blocks) break;  // the terrains follow
    const engine::Vec2 position = frame.position() + p.model.origin;
    t.poses.insert(t.poses.end(), {position.x, position.y, frame.angle});
  }
  t.ground_displacement.resize(2);
  t.ground_reaction.resize(2);
  t.accelerations.resize(2 * t.blocks);
  return t;
}

structures::VerdictKind kind_before_shaking(const Preparation& p, const structures::Response& response) {
  if (p.settle.outcome != engine::Outcome::completed) return structures::VerdictKind::numerically_invalid;
  const bool lost =
      std::ranges::any_of(response.storeys, [](const auto& storey) { return storey.lost_at.has_value(); });
  return lost || response.fallen_mass_fraction > p.scenario.verdict.fallen_mass
             ? structures::VerdictKind::collapsed
             : structures::VerdictKind::undecided;
}

std::string headline_before_shaking(structures::VerdictKind kind) {
  switch (kind) {
    case structures::VerdictKind::collapsed:
      return "Collapsed: the building does not stand under its own weight; it was not shaken.";
    case structures::VerdictKind::undecided:
      return "Undecided: the building did not come to rest under its own weight; it was not shaken.";
    default:
      return "Numerically invalid: the numbers failed while the building settled under its own weight; it "
             "was not "
             "shaken.";
  }
}

// A building that does not stand under its own weight has its verdict before anything shakes it.
structures::Verdict verdict_before_shaking(const Preparation& p) {
  const auto response = structures::compute_response(p.building, movement_of_settle(p), p.scenario.loss);
  structures::Verdict verdict;
  verdict.kind = kind_before_shaking(p, response);
  verdict.headline = headline_before_shaking(verdict.kind);
  verdict.evidence.push_back(fmt::format(
      "After {:.1f} s under gravity alone {} had moved {:.3g} m and the largest unbalanced force was {:.2g} "
      "of the "
      "weight.",
      p.settle.duration, p.settle.moved_most, p.settle.greatest_movement, p.settle.unbalanced_ratio));
  verdict.evidence.push_back(
      fmt::format("{} of {} blocks fell by then.", response.losses.size(), p.model.body_count));
  if (!p.settle.detail.empty()) verdict.evidence.push_back(p.settle.detail);
  return verdict;
}

// Greatest |error| over the greatest |input| of the first `count` samples.
double input_error(const EnergyHistory& energy, std::size_t count) {
  double error = 0.0, input = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    error = std::max(error, std::abs(energy.error[k]));
    input = std::max(input, std::abs(energy.input[k]));
  }
  return input > 0.0 ? error / input : 0.0;
}

double standing_error(const EnergyHistory& energy, const structures::Response& response) {
  const auto& times = response.times;
  if (!response.first_loss_of_support) return input_error(energy, times.size());
  const auto lost = std::upper_bound(times.begin(), times.end(), *response.first_loss_of_support);
  return input_error(energy, static_cast<std::size_t>(lost - times.begin()));
}

// Ends the run once every storey is lost and the debris has had its time.
class CollapseWatch {
 public:
  explicit CollapseWatch(const Preparation& p) : p_(p) {}

  bool over(const structures::Trajectory& trajectory) {
    const double now = trajectory.times.back();
    if (!p_.scenario.solve.after_collapse) return false;
    if (!lost_at_ && now >= next_look_) {
      // The whole trajectory is read only when its ends tell that there is something to find.
      if (loss_of(structures::at_steps(trajectory, {0, trajectory.times.size() - 1})))
        lost_at_ = loss_of(trajectory);
      next_look_ = now + 1.0;  // s
    }
    return lost_at_ && now >= *lost_at_ + *p_.scenario.solve.after_collapse;
  }
  std::string reason() const {
    return fmt::format("every storey was lost by {:.2f} s, and solve.after_collapse is {:.3g} s", *lost_at_,
                       *p_.scenario.solve.after_collapse);
  }

 private:
  std::optional<double> loss_of(const structures::Trajectory& trajectory) const {
    return structures::total_loss(p_.building, trajectory, p_.scenario.loss);
  }

  const Preparation& p_;
  double next_look_ = 0.0;  // s
  std::optional<double> lost_at_;
};

/// The sheets that are known before the building is shaken.
RunResult begun(const Preparation& p, const std::string& command) {
  RunResult result;
  result.reproducibility =
      reproducibility_of(to_toml(p.scenario), p.motion.records.horizontal().provenance.sha256, command);
  result.model = model_sheet(p);
  result.motion = motion_sheet(p.motion, p.period);
  result.settle = settle_sheet(p.settle);
  if (p.settle.settled)
    result.weight_joints = weight_joints(p.building.scene, p.model, structures::face_loads(p.model, p.state));
  if (!stands(p)) result.verdict = verdict_before_shaking(p);
  return result;
}

structures::Trajectory kept_states(const structures::Trajectory& all, const OutputChoice& output,
                                   const std::vector<Moment>& moments) {
  return structures::at_steps(all, kept_steps(all.times, output.state_rate, moments));
}

RunResult gathered(RunResult result, const Preparation& p, const engine::RunOutcome& run, Recorder recorder) {
  result.reproducibility.state_hash = engine::state_hash(p.state);
  result.partial = run.outcome == engine::Outcome::interrupted;
  result.numerics = numerics_of(p, run, recorder);
  result.response = structures::compute_response(p.building, recorder.trajectory, p.scenario.loss);
  if (stands(p))
    result.verdict =
        structures::judge(result.response, evidence_of(result.numerics, run, recorder), p.scenario.verdict);
  if (result.verdict.kind != structures::VerdictKind::numerically_invalid)
    result.collapse = structures::describe_collapse(p.building, recorder.trajectory, p.scenario.loss);
  result.screening = screening_of(p.scenario.screening, p.building, result.response, result.verdict);
  result.moved_joints =
      moved_joints(p.building.scene, p.model, recorder.joints, recorder.trajectory, result.response.losses);
  if (p.settle.settled && result.verdict.kind != structures::VerdictKind::numerically_invalid)
    result.end_joints =
        weight_joints(p.building.scene, p.model,
                      structures::face_loads(p.model, p.state, engine::frames_of(p.model, p.state)));
  result.model.bonded = std::move(recorder.bonds);
  result.energy = std::move(recorder.energies.energy);
  result.energy.standing_error = standing_error(result.energy, result.response);
  result.energy.input_error = input_error(result.energy, result.energy.error.size());
  result.moments = moments_of(result);
  result.trajectory = kept_states(recorder.trajectory, p.scenario.output, result.moments);
  return result;
}

/// When the next snapshot is due: they take a fiftieth of the time at most.
class SnapshotClock {
 public:
  explicit SnapshotClock(double interval) : interval_(interval), next_(interval) {}

  bool due() const { return clock_.wall() >= next_; }
  template <class Take>
  void taken(const Take& take) {
    const double before = clock_.wall();
    take();
    const double after = clock_.wall();
    next_ = after + std::max(interval_, 49.0 * (after - before));
  }
  const Stopwatch& clock() const { return clock_; }

 private:
  Stopwatch clock_;
  double interval_, next_;  // s, of the clock
};

class Shaking {
 public:
  Shaking(Preparation& p, const RunResult& start, const ProgressObserver& progress,
          const SnapshotObserver& snapshot)
      : recorder(p, start.model.bonded),
        p_(p),
        start_(start),
        progress_(progress),
        snapshot_(snapshot),
        collapse_(p),
        snapshots_(p.scenario.output.save_every) {}

  engine::RunOutcome run() {
    engine::DriveOptions options = p_.drive;
    if (!stands(p_)) options.end_time = 0.0;
    engine::RunOutcome run =
        engine::drive(p_.model, p_.state, options, [&](const engine::Sample& s) { return note(s); });
    if (run.outcome == engine::Outcome::stopped_by_criterion) run.detail = collapse_.reason();
    if (run.outcome == engine::Outcome::step_too_large)
      throw std::invalid_argument("solve.step: " + run.detail);
    return run;
  }
  void note_cost(RunResult& result) const {
    result.reproducibility.wall_seconds = snapshots_.clock().wall();
    result.reproducibility.cpu_seconds = snapshots_.clock().cpu();
  }

  Recorder recorder;

 private:
  engine::Wish note(const engine::Sample& sample) {
    recorder.note(sample);
    if (progress_ && !progress_(recorder.progress())) return engine::Wish::interrupt;
    if (snapshot_ && snapshots_.due()) snapshots_.taken([&] { take_snapshot(sample.so_far); });
    return collapse_.over(recorder.trajectory) ? engine::Wish::stop : engine::Wish::go_on;
  }
  void take_snapshot(engine::RunOutcome so_far) const {
    so_far.outcome = engine::Outcome::interrupted;
    RunResult result = gathered(start_, p_, so_far, recorder);
    note_cost(result);
    snapshot_(result);
  }

  Preparation& p_;
  const RunResult& start_;
  const ProgressObserver& progress_;
  const SnapshotObserver& snapshot_;
  CollapseWatch collapse_;
  SnapshotClock snapshots_;
};

}  // namespace

RunResult execute(Preparation& p, const std::string& command, const ProgressObserver& progress,
                  const SnapshotObserver& snapshot) {
  const RunResult start = begun(p, command);
  Shaking shaking(p, start, progress, snapshot);
  const engine::RunOutcome run = shaking.run();
  RunResult result = start;
  shaking.note_cost(result);
  return gathered(std::move(result), p, run, std::move(shaking.recorder));
}

}  // namespace dougong::app
