#include "engine/settle.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {
namespace {

double largest_translation(const Model& model, std::span<const double> a) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.body_count; ++i)
    largest = std::max(largest, norm({a[i], a[model.body_count + i]}));
  return largest;
}

/// Of the body that is furthest from where it was.
void note_movement(const Model& model, const std::vector<double>& before, const State& state,
                   SettleReport& report) {
  const std::size_t n = model.body_count;
  report.greatest_movement = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double movement = norm({state.y[i] - before[i], state.y[n + i] - before[n + i]});
    if (movement <= report.greatest_movement) continue;
    report.greatest_movement = movement;
    report.moved_most = model.names[i];
  }
}

void start_afresh(const Model& model, State& state, std::span<const double> velocities) {
  state.time = 0.0;
  std::copy(velocities.begin(), velocities.end(), state.v().begin());
  state.work = {};
  // What the springs store now has been lost to nothing.
  const auto frames = frames_of(model, state, true);
  state.work.tangential = stored_energy(state.contacts.points, frames).tangential;
  state.work.bonds = bond_energy(model, state.bonds, frames);
  state.deepest_ratio = state.deepest_time = 0.0;
  put_to_rest(state.contacts.points);
}

// Looks for rest from where the state is, for what is left of the time.
void seek_rest(const Model& model, State& state, const SettleOptions& options,
               const std::vector<double>& before, SettleReport& report) {
  DriveOptions drive_options;
  drive_options.integrator = "symplectic-euler";
  drive_options.end_time = options.longest_time - report.duration;
  drive_options.terrain_held_still = true;
  drive_options.local_damping = options.local_damping;
  std::fill(state.v().begin(), state.v().end(), 0.0);
  const RunOutcome run = drive(model, state, drive_options, [&](const Sample& sample) {
    report.unbalanced_ratio = largest_translation(model, sample.accelerations) / norm(model.gravity);
    // At t = 0 nothing touches yet: free fall is unbalanced by 1.
    report.settled = sample.state.time > 0.0 && report.unbalanced_ratio < options.unbalanced_ratio;
    note_movement(model, before, sample.state, report);
    const bool given_up = report.greatest_movement > options.longest_movement;
    return report.settled || given_up ? Wish::stop : Wish::go_on;
  });
  report.outcome = run.outcome;
  report.detail = run.detail;
  report.duration += run.end_time;
}

bool has_sound_bonds(const Model& model, const BondState& bonds) {
  for (std::size_t i = 0; i < model.bond_points.size(); ++i)
    if (has_cracked(model.bond_points[i].law, bonds.history[i])) return false;
  return !model.bond_points.empty();
}

// Weight that comes all at once strains a bond up to twice as far as it does at rest.
void seek_elastic_rest(Model model, State& state, const SettleOptions& options,
                       const std::vector<double>& before, SettleReport& report) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  for (BondPoint& point : model.bond_points)
    point.law.tension = point.law.cohesion = point.law.yield = point.law.crushing = endless;
  seek_rest(model, state, options, before, report);
  for (BondHistory& history : state.bonds.history) history.widest = 0.0;
}

}  // namespace

SettleReport settle(const Model& model, State& state, const SettleOptions& options) {
  SettleReport report;
  if (norm(model.gravity) == 0.0 || model.body_count == 0) return report.settled = true, report;
  const std::vector<double> before = state.y;
  const std::vector<double> velocities(state.v().begin(), state.v().end());
  const bool elastic_first = has_sound_bonds(model, state.bonds);
  if (elastic_first) seek_elastic_rest(model, state, options, before, report);
  if (!elastic_first || report.settled) seek_rest(model, state, options, before, report);
  start_afresh(model, state, velocities);
  return report;
}

}  // namespace dougong::engine
