#include "app/cli/run_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/screening_text.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"
#include "app/report/weight_joints_report.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

std::string period_text(const Preparation& p) {
  if (p.period == 0.0) return "none found (no stable horizontal mode)";
  return fmt::format("{:.3f} s for small amplitudes, carrying {:.0f} % of the mass", p.period,
                     100.0 * p.participation);
}

std::string settle_text(const Preparation& p) {
  if (!p.scenario.solve.settle) return "left out (solve.settle = false)";
  if (p.settle.outcome == engine::Outcome::diverged) return "failed: " + p.settle.detail;
  if (!p.settle.settled) return fmt::format("did not come to rest in {:.1f} s", p.settle.duration);
  return fmt::format("at rest after {:.2f} s, {} moved most: {}", p.settle.duration, p.settle.moved_most,
                     length(p.settle.greatest_movement));
}

std::string motion_text(const Preparation& p) {
  double pga = 0.0;
  for (const double a : p.motion.ground->horizontal().acceleration) pga = std::max(pga, std::abs(a));
  return fmt::format("{}, {} applied, {:.4g} s every {:.4g} s{}", p.motion.conditioned.title,
                     acceleration_g(pga).substr(pga > 0.0 ? 1 : 0), p.motion.ground->duration(),
                     p.motion.ground->knot_interval(),
                     p.motion.ground->vertical() ? ", with its vertical component" : "");
}

std::string step_text(const Preparation& p) {
  if (engine::traits_of(p.drive.integrator).adaptive)
    return fmt::format("{}, steps by their error, {:.0e} each", p.drive.integrator, p.drive.tolerance);
  if (engine::traits_of(p.drive.integrator).rigid_contacts && !std::isfinite(p.plan.bound))
    return fmt::format("{}, step {} (rigid contacts: no stability bound)", p.drive.integrator,
                       time_text(p.plan.step));
  if (!std::isfinite(p.plan.bound))
    return fmt::format("{}, step {} (nothing touches: no stability bound)", p.drive.integrator,
                       time_text(p.plan.step));
  return fmt::format("{}, step {}, {:.0f} % of the stability bound of {}", p.drive.integrator,
                     time_text(p.plan.step), 100.0 * p.plan.step / p.plan.bound, time_text(p.plan.bound));
}

Tone tone_of(structures::VerdictKind kind) {
  switch (kind) {
    case structures::VerdictKind::survived:
      return Tone::good;
    case structures::VerdictKind::undecided:
      return Tone::doubtful;
    default:
      return Tone::bad;
  }
}

std::string drift_text(const structures::Response& response) {
  const structures::StoreyResponse* worst = structures::storey_of_peak_drift(response);
  if (!worst) return "no storeys";
  const structures::Peak peak = worst->peak_drift.largest();
  return fmt::format("{} ({}) in {} at {:.2f} s{}", drift_percent(peak.value), drift_fraction(peak.value),
                     worst->name, peak.time, worst->lost_at ? ", before the storey was lost" : "");
}

std::string residual_text(const structures::Response& response) {
  const structures::StoreyResponse* worst = structures::storey_of_residual_drift(response);
  if (!worst) return "none: no storey stands at the end";
  return fmt::format("{} in {}", drift_percent(worst->residual_drift), worst->name);
}

std::string shear_text(const structures::Response& response) {
  const structures::Peak roof = response.peak_roof_displacement.largest();
  const structures::Peak shear = response.peak_base_shear.largest();
  return fmt::format("roof {} at {:.2f} s, base shear {} kN (V/W {}) at {:.2f} s", displacement(roof.value),
                     roof.time, signed_fixed(shear.value / 1000.0, 1),
                     signed_fixed(response.weight > 0.0 ? shear.value / response.weight : 0.0, 3),
                     shear.time);
}

std::string losses_text(const structures::Response& response, std::size_t blocks) {
  std::string lost;
  for (const auto& storey : response.storeys)
    if (storey.lost_at)
      lost += fmt::format("{}{} at {:.2f} s", lost.empty() ? "" : ", ", storey.name, *storey.lost_at);
  return fmt::format("{} of {} blocks fell ({:.0f} % of the mass); storeys lost: {}", response.losses.size(),
                     blocks, 100.0 * response.fallen_mass_fraction, lost.empty() ? "none" : lost);
}

std::string moment_text(const char* name, const std::optional<double>& time) {
  return time ? fmt::format(", {} {:.2f} s", name, *time) : "";
}

std::string collapse_text(const structures::Collapse& c) {
  return to_string(c.mode) + moment_text("began", c.initiation) + moment_text("no return", c.no_return) +
         moment_text("complete", c.complete);
}

std::string debris_text(const structures::Collapse& c) {
  return fmt::format(
      "{:.2f} m beyond the left face, {:.2f} m beyond the right; hits of {} kJ in all; {} m2 of "
      "voids remain",
      c.footprint.left.reach, c.footprint.right.reach, significant(c.impact_energy / 1e3, 3),
      significant(c.void_area, 3));
}

std::string numbers_text(const RunResult& r) {
  return fmt::format(
      "energy error {} % of the input{}, deepest overlap {} % of a block, {} steps in {:.1f} s",
      significant(100.0 * r.energy.standing_error, 2),
      r.response.first_loss_of_support
          ? fmt::format(" while it stood, {} % in all", significant(100.0 * r.energy.input_error, 2))
          : "",
      significant(100.0 * r.numerics.deepest_overlap_ratio, 2), r.numerics.steps,
      r.reproducibility.wall_seconds);
}

}  // namespace

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("  {:<13}{}", name, value);
}

std::string heads_of(const std::vector<std::string>& terms) {
  std::string heads;
  for (const std::string& term : terms) heads += (heads.empty() ? "" : "; ") + term.substr(0, term.find(':'));
  return heads;
}

std::string time_text(double value) {
  if (value < 1e-3) return fmt::format("{:.3g} us", 1e6 * value);
  if (value < 1.0) return fmt::format("{:.3g} ms", 1e3 * value);
  if (value < 100.0) return fmt::format("{:.3g} s", value);
  if (value < 6000.0) return fmt::format("{:.0f} min", value / 60.0);
  return fmt::format("{:.3g} h", value / 3600.0);
}

std::vector<std::string> preparation_text(const Preparation& p) {
  const ModelSheet sheet = model_sheet(p);
  std::vector<std::string> lines{
      row("building", fmt::format("{}: {}", p.building.layout, sheet.title)),
      row("model", fmt::format("{} rigid blocks, {} bonds, {} touching contact points, {}, {} storeys",
                               p.model.body_count, p.building.scene.bonds.size(), p.contact_points,
                               mass_text(p.model.total_mass()), p.building.storeys.size())),
      row("modelled", heads_of(sheet.modelled)),
      row("left out", heads_of(sheet.not_modelled)),
      row("settle", settle_text(p)),
      row("period", period_text(p)),
      row("motion", motion_text(p)),
      row("numerics", step_text(p)),
      row("cost", fmt::format("about {} for {:.1f} s simulated ({:.0f} steps), measured on a short trial",
                              time_text(p.estimated_seconds), p.duration, p.duration / p.plan.step))};
  if (!p.accuracy.empty()) lines.insert(lines.end() - 1, row("accuracy", p.accuracy));
  for (const structures::Finding& finding : p.findings)
    lines.push_back(row(to_string(finding.severity), finding.message));
  for (const std::string& warning : p.motion.conditioned.warnings) lines.push_back(row("warning", warning));
  return lines;
}

std::vector<ToneLine> answer_text(const RunResult& r) {
  std::vector<ToneLine> lines{{"", Tone::plain}, {r.verdict.headline, tone_of(r.verdict.kind)}};
  if (r.partial)
    lines.push_back({"  INTERRUPTED: the results end where the run was stopped", Tone::doubtful});
  if (!r.weight_joints.empty()) lines.push_back({row("weight alone", weight_text(r.weight_joints))});
  lines.push_back({row("peak drift", drift_text(r.response))});
  lines.push_back({row("residual", residual_text(r.response))});
  lines.push_back({row("response", shear_text(r.response))});
  lines.push_back({row("losses", losses_text(r.response, r.model.blocks.size()))});
  if (r.collapse.happened()) {
    lines.push_back({row("fall", collapse_text(r.collapse))});
    lines.push_back({row("debris", debris_text(r.collapse))});
  }
  for (const std::string& line : screening_lines(r.screening)) lines.push_back({row("screening", line)});
  if (!r.screening.checks.empty())
    lines.push_back({row("", "(screening, not code compliance: a plane model of rigid blocks, one motion)")});
  lines.push_back({row("numbers", numbers_text(r))});
  if (r.ensemble.members.size() > 1) {
    lines.push_back({row("ensemble", collapse_text(r.ensemble))});
    lines.push_back({row("spread", drift_spread_text(r.ensemble))});
  }
  for (const std::string& warning : r.numerics.warnings)
    lines.push_back({row("warning", warning), Tone::doubtful});
  return lines;
}

std::vector<ToneLine> half_step_line(const RunResult& r) {
  const EnsembleSheet& e = r.ensemble;
  if (e.members.size() != 1 || !e.half_step.done) return {};
  const bool same = e.half_step.verdict == r.verdict.kind;
  return {{row("half step", half_step_text(e)), same ? Tone::plain : Tone::doubtful}};
}

std::vector<std::string> files_text(const std::filesystem::path& directory, std::size_t files) {
  return {row("report", (directory / "report.html").string()),
          row("files", fmt::format("{} in {}", files, directory.string()))};
}

}  // namespace dougong::app
