#include "app/study/execute.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "app/study/moments.h"
#include "app/study/recorder.h"
#include "app/study/version.h"
#include "seismic/formats/file_text.h"

namespace dougong::app {
namespace {

// Wall and processor time of the run.
class Stopwatch {
 public:
  double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  double cpu() const { return static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC; }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  std::clock_t cpu_ = std::clock();
};

bool stands(const Preparation& p) {
  return !p.scenario.solve.settle || p.settle.settled;
}

std::string pair_name(const engine::Model& model, engine::BodyPair pair) {
  return model.names[pair.a] + " / " + model.names[pair.b];
}

void describe_deepest(const Preparation& p, Numerics& n) {
  n.deepest_overlap_ratio = p.state.deepest_ratio;
  if (p.state.deepest_ratio == 0.0) return;
  const auto [a, b] = p.state.deepest_pair;
  n.deepest_overlap = p.state.deepest_ratio * std::min(p.model.minimum_width[a], p.model.minimum_width[b]);
  n.deepest_overlap_where =
      fmt::format("{} at {:.2f} s", pair_name(p.model, p.state.deepest_pair), p.state.deepest_time);
}

Numerics numerics_of(const Preparation& p, const engine::RunOutcome& run, const Recorder& recorder) {
  Numerics n;
  n.integrator = p.drive.integrator;
  n.step = run.smallest_step;
  n.bound = run.bound;
  n.steps = run.steps;
  n.step_reductions = run.step_reductions;
  n.outcome = to_string(run.outcome);
  n.outcome_detail = run.detail;
  n.end_time = run.end_time;
  n.asked_time = p.duration;
  n.overlap_ratio = recorder.overlap_ratio;
  describe_deepest(p, n);
  if (run.step_reductions > 0)
    n.warnings.push_back(
        fmt::format("the step was reduced {} times, to {:.3g} s, when stiffer contacts appeared",
                    run.step_reductions, run.smallest_step));
  if (!stands(p) && p.settle.outcome == engine::Outcome::completed)
    n.warnings.push_back(fmt::format("the building did not come to rest under its own weight within {:.1f} s",
                                     p.settle.duration));
  return n;
}

SettleSheet settle_sheet(const engine::SettleReport& report) {
  return {report.settled, report.duration, report.greatest_movement, report.unbalanced_ratio};
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
  e.finite = std::isfinite(recorder.energy.relative_error);
  e.energy_error_ratio = recorder.energy.relative_error;
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

double standing_error(const EnergyHistory& energy, const structures::Response& response) {
  double error = 0.0, input = 0.0;
  for (std::size_t k = 0; k < response.times.size(); ++k) {
    if (response.first_loss_of_support && response.times[k] > *response.first_loss_of_support) break;
    error = std::max(error, std::abs(energy.error[k]));
    input = std::max(input, std::abs(energy.input[k]));
  }
  return input > 0.0 ? error / input : 0.0;
}

Reproducibility reproducibility_of(const Preparation& p, const std::string& command) {
  Reproducibility r;
  r.version = program_version();
  r.git_hash = program_git_hash();
  r.compiler = program_compiler();
  r.command = command;
  r.scenario = to_toml(p.scenario);
  r.scenario_sha256 = seismic::sha256_hex(r.scenario);
  r.record_sha256 = p.motion.records.horizontal().provenance.sha256;
  r.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return r;
}

engine::RunOutcome shake(Preparation& p, Recorder& recorder, const ProgressObserver& progress) {
  engine::DriveOptions options = p.drive;
  if (!stands(p)) options.end_time = 0.0;
  engine::RunOutcome run = engine::drive(p.model, p.state, options, [&](const engine::Sample& sample) {
    recorder.note(sample);
    return !progress || progress(recorder.progress()) ? engine::Wish::go_on : engine::Wish::interrupt;
  });
  if (run.outcome == engine::Outcome::step_too_large)
    throw std::invalid_argument("solve.step: " + run.detail);
  return run;
}

}  // namespace

RunResult execute(Preparation& p, const std::string& command, const ProgressObserver& progress) {
  RunResult result;
  result.reproducibility = reproducibility_of(p, command);
  result.model = model_sheet(p);
  result.motion = motion_sheet(p.motion, p.period);
  result.settle = settle_sheet(p.settle);

  const structures::Verdict early_verdict = stands(p) ? structures::Verdict{} : verdict_before_shaking(p);
  const Stopwatch watch;
  Recorder recorder(p);
  const engine::RunOutcome run = shake(p, recorder, progress);
  result.reproducibility.wall_seconds = watch.wall();
  result.reproducibility.cpu_seconds = watch.cpu();
  result.reproducibility.state_hash = engine::state_hash(p.state);

  result.partial = run.outcome == engine::Outcome::interrupted;
  result.numerics = numerics_of(p, run, recorder);
  result.response = structures::compute_response(p.building, recorder.trajectory, p.scenario.loss);
  result.verdict = stands(p) ? structures::judge(result.response, evidence_of(result.numerics, run, recorder),
                                                 p.scenario.verdict)
                             : early_verdict;
  result.trajectory = std::move(recorder.trajectory);
  result.energy = std::move(recorder.energy);
  result.energy.standing_error = standing_error(result.energy, result.response);
  result.moments = moments_of(result);
  return result;
}

}  // namespace dougong::app
