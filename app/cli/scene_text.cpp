#include "app/cli/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/text.h"
#include "app/study/quantity.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

std::string counts_text(const PreparedScene& p) {
  std::string text = fmt::format("{}, {}, {}", plural(p.model.body_count, "body"),
                                 mass_text(p.model.total_mass()), plural(p.scene.terrains.size(), "terrain"));
  if (!p.scene.joints.empty()) text += ", " + plural(p.scene.joints.size(), "joint");
  if (!p.scene.bonds.empty()) text += ", " + plural(p.scene.bonds.size(), "bond");
  return text;
}

bool has_rigid_contacts(const PreparedScene& p) {
  return engine::traits_of(p.drive.integrator).rigid_contacts;
}

std::string frequency_text(const PreparedScene& p) {
  if (!(p.highest_frequency > 0.0))
    return has_rigid_contacts(p) ? "none: contacts are rigid" : "none yet: nothing touches";
  return fmt::format("at most {} Hz, by Gershgorin's bound", significant(p.highest_frequency, 3));
}

std::string step_text(const PreparedScene& p) {
  if (has_rigid_contacts(p) && !std::isfinite(p.plan.bound))
    return fmt::format("{}, {}; contacts are rigid: no stability bound, fast bodies shorten the step",
                       p.drive.integrator, time_text(p.plan.step));
  if (!std::isfinite(p.plan.bound))
    return fmt::format("{}, {} until something touches; then the step follows the contacts",
                       p.drive.integrator, time_text(p.plan.step));
  return fmt::format("{}, {}, {:.0f} % of the stability bound of {}", p.drive.integrator,
                     time_text(p.plan.step), 100.0 * p.plan.step / p.plan.bound, time_text(p.plan.bound));
}

std::string settle_text(const engine::SettleReport& settle) {
  if (!settle.settled) return fmt::format("did not come to rest in {:.1f} s", settle.duration);
  return fmt::format("at rest after {:.2f} s, {} moved most: {}", settle.duration, settle.moved_most,
                     length(settle.greatest_movement));
}

// "gravitation: forces off by 0.14 % of the direct sum's (rms of all 2000 bodies)"
std::vector<std::string> tree_rows(const std::vector<engine::TreeError>& errors, const std::string& when) {
  std::vector<std::string> rows;
  for (const engine::TreeError& e : errors)
    rows.push_back(
        row("tree", fmt::format("{}, {}: forces off by {} % of the direct sum's (rms of {} bodies, "
                                "opening angle {})",
                                e.field, when, significant(100.0 * e.relative, 2),
                                e.compared == e.bodies ? fmt::format("all {}", e.bodies)
                                                       : fmt::format("{} of {}", e.compared, e.bodies),
                                e.opening_angle)));
  return rows;
}

ToneLine headline(const SceneResult& r) {
  const Numerics& n = r.run.numerics;
  if (!r.valid) return {fmt::format("Numerically invalid at {:.4g} s: {}.", n.end_time, r.reason), Tone::bad};
  if (r.run.partial)
    return {
        fmt::format("Interrupted at {:.4g} s of {:.4g} s: the results end there.", n.end_time, n.asked_time),
        Tone::doubtful};
  return {fmt::format("Completed: {:.4g} s simulated.", n.end_time), Tone::good};
}

// ", 1 crushed" or nothing.
std::string crushed_text(const std::vector<DrawnBond>& bonds) {
  const auto crushed = std::ranges::count_if(bonds, [](const DrawnBond& b) { return b.crushed < b.never; });
  return crushed > 0 ? fmt::format(", {} crushed", crushed) : "";
}

// "3 of 5 cracked, 2 broken; the first, joint 2, at 1.24 s"
std::string bonds_text(const std::vector<DrawnBond>& bonds) {
  const auto cracked = std::ranges::count_if(bonds, [](const DrawnBond& b) { return b.cracked < b.never; });
  const auto broken = std::ranges::count_if(bonds, [](const DrawnBond& b) { return b.broken < b.never; });
  if (cracked == 0) return plural(bonds.size(), "bond") + ", none cracked" + crushed_text(bonds);
  const DrawnBond& first = *std::ranges::min_element(bonds, {}, &DrawnBond::cracked);
  return fmt::format("{} of {} cracked{}, {} broken; the first, {}, at {:.4g} s", cracked, bonds.size(),
                     crushed_text(bonds), broken, first.name, first.cracked);
}

}  // namespace

std::vector<std::string> scene_text(const PreparedScene& p) {
  std::vector<std::string> lines{
      row("scene", p.description.head.title.empty() ? "without a title" : p.description.head.title),
      row("model", counts_text(p)), row("modelled", heads_of(modelled_terms(p))),
      row("left out", heads_of(missing_terms(p)))};
  if (p.description.solve.settle && p.settle.duration > 0.0)
    lines.push_back(row("settle", settle_text(p.settle)));
  lines.push_back(row("frequency", frequency_text(p)));
  lines.push_back(row("numerics", step_text(p)));
  if (!p.accuracy.empty()) lines.push_back(row("accuracy", p.accuracy));
  for (std::string& text : tree_rows(p.tree_errors, "at the start")) lines.push_back(std::move(text));
  for (const std::string& finding : p.findings) lines.push_back(row("warning", finding));
  for (const TerrainMotion& motion : p.motions)
    for (const std::string& warning : motion.warnings) lines.push_back(row("warning", warning));
  return lines;
}

std::string cost_text(const PreparedScene& p) {
  if (!std::isfinite(p.plan.bound) && !has_rigid_contacts(p))
    return row("cost", fmt::format("at least {}; contacts that close need shorter steps",
                                   time_text(p.estimated_seconds)));
  return row("cost",
             fmt::format("about {} for {:.4g} s simulated ({:.0f} steps), measured on a short trial",
                         time_text(p.estimated_seconds), p.drive.end_time, p.drive.end_time / p.plan.step));
}

std::vector<ToneLine> scene_answer_text(const SceneResult& r) {
  const Numerics& n = r.run.numerics;
  std::vector<ToneLine> lines{{"", Tone::plain}, headline(r)};
  lines.push_back({row("numbers", fmt::format("energy error {} % of the energy turned over, deepest overlap "
                                              "{} % of a body, {} steps in {:.1f} s",
                                              significant(100.0 * r.run.energy.relative_error, 2),
                                              significant(100.0 * n.deepest_overlap_ratio, 2), n.steps,
                                              r.run.reproducibility.wall_seconds))});
  for (std::string& text : tree_rows(r.tree_at_start, "at the start")) lines.push_back({std::move(text)});
  for (std::string& text : tree_rows(r.tree_at_end, "at the end")) lines.push_back({std::move(text)});
  if (!r.run.model.bonded.empty()) lines.push_back({row("bonds", bonds_text(r.run.model.bonded))});
  lines.push_back({row("state", r.run.reproducibility.state_hash + " (the same bits, the same hash)")});
  for (const std::string& warning : n.warnings) lines.push_back({row("warning", warning), Tone::doubtful});
  return lines;
}

}  // namespace dougong::app
