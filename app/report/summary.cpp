#include "app/report/summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/spread_text.h"
#include "app/report/weight_joints_report.h"

namespace dougong::app {
namespace {

using Json = nlohmann::ordered_json;
using structures::Envelope;
using structures::Peak;

/// JSON has no infinity and no NaN.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json metric(double value, const char* unit, Json time = nullptr) {
  return {{"value", number(value)}, {"unit", unit}, {"time", std::move(time)}};
}
Json metric(const Peak& peak, const char* unit) {
  return metric(peak.value, unit, number(peak.time));
}
Json both_signs(const Envelope& envelope, const char* unit) {
  return {{"positive", metric(envelope.positive, unit)}, {"negative", metric(envelope.negative, unit)}};
}

Json verdict_part(const RunResult& run) {
  return {{"kind", structures::to_string(run.verdict.kind)},
          {"headline", run.verdict.headline},
          {"evidence", run.verdict.evidence}};
}

Json storey_part(const structures::StoreyResponse& storey) {
  return {{"name", storey.name},
          {"height", metric(storey.height, "m")},
          {"peak_drift_ratio", both_signs(storey.peak_drift, "1")},
          {"peak_shear_drift_ratio", both_signs(storey.peak_shear_drift, "1")},
          {"residual_drift_ratio", metric(storey.residual_drift, "1")},
          {"peak_floor_acceleration", both_signs(storey.peak_acceleration, "m/s2")},
          {"mass_lost", metric(storey.mass_lost.empty() ? 0.0 : storey.mass_lost.back(), "1")},
          {"lost_at", number(storey.lost_at)}};
}

/// The largest drift of any storey before its loss, sign kept.
Json largest_drift(const structures::Response& response) {
  Peak largest;
  std::string storey;
  for (const auto& s : response.storeys) {
    const Peak peak = s.peak_drift.largest();
    if (!storey.empty() && std::abs(peak.value) <= std::abs(largest.value)) continue;
    largest = peak;
    storey = s.name;
  }
  Json out = metric(largest, "1");
  out["storey"] = storey;
  return out;
}

/// The joint that a peak is largest of: the peak, with its joint's name.
Json joint_peak(const RunResult& run, Peak MovedJoint::*peak) {
  const auto size = [&](const MovedJoint& joint) { return std::abs((joint.*peak).value); };
  const auto most = std::ranges::max_element(run.moved_joints, {}, size);
  const bool none = most == run.moved_joints.end();
  Json out = none ? metric(0.0, "m") : metric((*most).*peak, "m");
  out["joint"] = none ? "" : most->name;
  return out;
}

Json joints_part(const RunResult& run) {
  return {{"count", run.moved_joints.size()},
          {"widest_opening", joint_peak(run, &MovedJoint::opening)},
          {"farthest_slip", joint_peak(run, &MovedJoint::slip)}};
}

Json metrics_part(const RunResult& run) {
  const auto& r = run.response;
  Json storeys = Json::array();
  for (const auto& storey : r.storeys) storeys.push_back(storey_part(storey));
  return {{"largest_drift_ratio", largest_drift(r)},
          {"peak_roof_displacement", both_signs(r.peak_roof_displacement, "m")},
          {"peak_base_shear", both_signs(r.peak_base_shear, "N")},
          {"weight", metric(r.weight, "N")},
          {"peak_overturning_moment", both_signs(r.peak_overturning_moment, "N m")},
          {"period", metric(run.model.period, "s")},
          {"spectral_acceleration_at_period", metric(run.motion.spectrum_at_period, "m/s2")},
          {"first_loss_of_support", number(r.first_loss_of_support)},
          {"blocks_lost", metric(static_cast<double>(r.losses.size()), "1")},
          {"fallen_mass_fraction", metric(r.fallen_mass_fraction, "1")},
          {"joints", joints_part(run)},
          {"storeys", storeys}};
}

Json side_part(const structures::Side& side) {
  return {{"reach", metric(side.reach, "m")}, {"mass", metric(side.mass, "kg")}};
}

Json footprint_part(const structures::Footprint& f) {
  return {{"height", metric(f.height, "m")},
          {"left", side_part(f.left)},
          {"right", side_part(f.right)},
          {"over_the_edge", f.over_the_edge}};
}

Json voids_part(const structures::Collapse& c) {
  return {{"count", c.voids.size()},
          {"area", metric(c.void_area, "m2")},
          {"area_before", metric(c.void_area_before, "m2")},
          {"largest_diameter", metric(c.voids.empty() ? 0.0 : c.voids.front().diameter, "m")}};
}

Json collapse_part(const structures::Collapse& c) {
  const auto hardest = std::ranges::max_element(c.falls, {}, &structures::Fall::energy);
  return {{"mode", to_string(c.mode)},
          {"reasons", c.reasons},
          {"initiation", number(c.initiation)},
          {"no_return", number(c.no_return)},
          {"complete", number(c.complete)},
          {"first_touch", number(c.first_touch)},
          {"footprint", footprint_part(c.footprint)},
          {"impact_energy", metric(c.impact_energy, "J")},
          {"hardest_hit",
           hardest == c.falls.end() ? metric(0.0, "J") : metric(hardest->energy, "J", hardest->hit)},
          {"voids", voids_part(c)}};
}

Json check_part(const structures::CodeCheck& c) {
  return {{"standard", c.standard},   {"clause", c.clause},     {"subject", c.subject},
          {"limit", c.limit_name},    {"measure", c.measure},   {"value", number(c.limit)},
          {"found", number(c.found)}, {"exceeded", c.exceeded}, {"source", c.status}};
}

/// Screening, not code compliance.
Json screening_part(const ScreeningSheet& sheet) {
  Json checks = Json::array();
  for (const structures::CodeCheck& check : sheet.checks) checks.push_back(check_part(check));
  return {{"structural_type", sheet.structural_type}, {"notes", sheet.notes}, {"checks", checks}};
}

Json joint_part(const WeightJoint& joint) {
  return {{"name", joint.name},
          {"bonded", joint.bonded},
          {"normal", metric(joint.normal, "N")},
          {"shear", metric(joint.shear, "N")},
          {"compression", metric(joint.compression, "Pa")},
          {"tension", metric(joint.tension, "Pa")},
          {"used", metric(joint.used, "1")},
          {"limit", joint.limit}};
}

Json self_weight_part(const std::vector<WeightJoint>& joints) {
  Json part{{"joints", joints.size()}, {"most_used", joint_part(joints.front())}};
  if (const WeightJoint* most = most_compressed(joints)) part["most_compressed"] = joint_part(*most);
  return part;
}

double last(const std::vector<double>& values) {
  return values.empty() ? 0.0 : values.back();
}

Json energy_part(const EnergyHistory& energy) {
  return {{"input", metric(last(energy.input), "J")},
          {"kinetic", metric(last(energy.kinetic), "J")},
          {"gravity", metric(last(energy.gravity), "J")},
          {"elastic", metric(last(energy.elastic), "J")},
          {"friction", metric(last(energy.friction), "J")},
          {"damping", metric(last(energy.damping), "J")},
          {"error", metric(last(energy.error), "J")},
          {"largest_input", metric(energy.largest_input, "J")},
          {"relative_error", metric(energy.relative_error, "1")},
          {"standing_error", metric(energy.standing_error, "1")},
          {"input_error", metric(energy.input_error, "1")}};
}

Json half_step_part(const EnsembleSheet& ensemble) {
  if (!ensemble.half_step.done) return nullptr;
  Json metrics = Json::array();
  const EnsembleMember &described = ensemble.members.front(), &half = ensemble.half_step;
  for (std::size_t i = 0; i < std::min(half.values.size(), ensemble.metrics.size()); ++i)
    metrics.push_back({{"name", ensemble.metrics[i]},
                       {"unit", ensemble.units[i]},
                       {"described", number(described.values.at(i))},
                       {"half_step", number(half.values[i])}});
  return {{"verdict", structures::to_string(half.verdict)}, {"metrics", metrics}};
}

Json numerics_part(const RunResult& run) {
  const Numerics& n = run.numerics;
  return {{"integrator", n.integrator},
          {"step", metric(n.step, "s")},
          {"stability_bound", metric(n.bound, "s")},
          {"steps", n.steps},
          {"step_reductions", n.step_reductions},
          {"outcome", n.outcome},
          {"outcome_detail", n.outcome_detail},
          {"end_time", metric(n.end_time, "s")},
          {"asked_time", metric(n.asked_time, "s")},
          {"deepest_overlap", metric(n.deepest_overlap, "m")},
          {"deepest_overlap_ratio", metric(n.deepest_overlap_ratio, "1")},
          {"deepest_overlap_where", n.deepest_overlap_where},
          {"mean_overlap_ratio", metric(mean_of(n.mean_overlap_ratio), "1")},
          {"settled", run.settle.settled},
          {"half_step", half_step_part(run.ensemble)},
          {"warnings", n.warnings}};
}

Json provenance_part(const RunResult& run) {
  Json record = Json::array();
  for (const NamedValue& entry : run.motion.provenance)
    record.push_back({{"name", entry.name}, {"value", entry.value}});
  return {{"layout", run.model.layout},
          {"motion", run.motion.title},
          {"record", record},
          {"processing", run.motion.processing},
          {"modelled", run.model.modelled},
          {"not_modelled", run.model.not_modelled}};
}

Json spread_part(const EnsembleSheet& ensemble, std::size_t metric) {
  const Spread s = spread_of_metric(ensemble, metric);
  const auto of = [&](const EnsembleMember& member) {
    return member.done && metric < member.values.size() ? number(member.values[metric]) : Json(nullptr);
  };
  return {{"name", ensemble.metrics[metric]},
          {"unit", ensemble.units[metric]},
          {"runs", s.count},
          {"described", of(ensemble.members.front())},
          {"half_step", of(ensemble.half_step)},
          {"least", number(s.least)},
          {"low", number(s.low)},
          {"median", number(s.median)},
          {"high", number(s.high)},
          {"most", number(s.most)}};
}

Json ensemble_part(const EnsembleSheet& ensemble) {
  const VerdictCount count = count_verdicts(ensemble);
  const Share collapse = count.collapse();
  Json metrics = Json::array(), changes = Json::array();
  for (std::size_t i = 0; i < ensemble.metrics.size(); ++i) metrics.push_back(spread_part(ensemble, i));
  for (const NamedValue& p : ensemble.perturbations)
    changes.push_back({{"name", p.name}, {"value", p.value}, {"meaning", p.meaning}});
  return {{"runs", ensemble.members.size()},
          {"survived", count.survived},
          {"collapsed", count.collapsed},
          {"undecided", count.undecided},
          {"numerically_invalid", count.invalid},
          {"left_out", count.left_out},
          {"collapse_probability", collapse.trials > 0 ? number(collapse.value()) : Json(nullptr)},
          {"collapse_interval", {number(collapse.low), number(collapse.high)}},
          {"metrics", metrics},
          {"changes", changes}};
}

Json reproducibility_part(const Reproducibility& r) {
  return {{"version", r.version},
          {"git_hash", r.git_hash},
          {"compiler", r.compiler},
          {"command", r.command},
          {"scenario_sha256", r.scenario_sha256},
          {"record_sha256", r.record_sha256},
          {"state_hash", r.state_hash},
          {"started", r.started},
          {"wall_time", metric(r.wall_seconds, "s")},
          {"processor_time", metric(r.cpu_seconds, "s")}};
}

}  // namespace

std::string summary_json(const RunResult& run, const std::vector<std::string>& files) {
  Json out{{"format", "dougong summary"},
           {"format_version", summary_format_version},
           {"partial", run.partial},
           {"verdict", verdict_part(run)},
           {"metrics", metrics_part(run)},
           {"energy", energy_part(run.energy)},
           {"numerics", numerics_part(run)},
           {"provenance", provenance_part(run)},
           {"reproducibility", reproducibility_part(run.reproducibility)},
           {"files", files}};
  if (!run.weight_joints.empty()) out["self_weight"] = self_weight_part(run.weight_joints);
  if (run.collapse.happened()) out["collapse"] = collapse_part(run.collapse);
  if (!run.screening.notes.empty()) out["screening"] = screening_part(run.screening);
  if (run.ensemble.members.size() > 1) out["ensemble"] = ensemble_part(run.ensemble);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace dougong::app
