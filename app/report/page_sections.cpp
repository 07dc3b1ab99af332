// The sections of the report after the answer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/page.h"
#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::Envelope;
using structures::StoreyResponse;

std::vector<std::string> files_of(const std::string& figure, const std::string& csv) {
  std::vector<std::string> files{"figures/" + figure + ".svg", "figures/" + figure + ".png"};
  if (!csv.empty()) files.push_back(csv);
  return files;
}

Html plot(const std::vector<Picture>& pictures, const std::string& name, std::string_view caption,
          const std::string& csv) {
  return figure_named(pictures, "figures/" + name + ".svg", caption, files_of(name, csv));
}

Html named_values(std::string_view caption, const char* first, const std::vector<NamedValue>& values) {
  if (values.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  bool meanings = false;
  for (const NamedValue& v : values) meanings = meanings || !v.meaning.empty();
  for (const NamedValue& v : values) {
    rows.push_back({v.name, v.value});
    if (meanings) rows.back().push_back(v.meaning);
  }
  std::vector<Heading> headings{{first, "", false}, {"Value", "", false}};
  if (meanings) headings.push_back({"Meaning", "", false});
  return table(caption, headings, rows);
}

// ---- the building ----

Html storey_table(const ModelSheet& model) {
  if (model.storeys.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  const auto bonds_of = [&](const StoreySheet& storey) {
    return std::ranges::count(model.bonded, storey.name,
                              [&](const DrawnBond& bond) { return storey_of(model, bond); });
  };
  for (auto s = model.storeys.rbegin(); s != model.storeys.rend(); ++s) {
    rows.push_back({s->name, fixed(s->base, 2), fixed(s->height, 2), fixed(s->mass / 1e3, 2),
                    std::to_string(s->blocks), std::to_string(bonds_of(*s))});
  }
  rows.push_back({"all", "", "", fixed(model.mass / 1e3, 2), std::to_string(model.blocks.size()),
                  std::to_string(model.bonded.size())});
  return table("Storeys, top first",
               {{"Storey", "", false},
                {"Base", "m"},
                {"Height, h", "m"},
                {"Mass", "t"},
                {"Blocks", ""},
                {"Bonds", ""}},
               rows);
}

std::string period_words(const ModelSheet& model) {
  if (model.period <= 0.0) return "No small-amplitude period was found.";
  return "Small-amplitude period T₁ = " + significant(model.period, 3) + " s, moving " +
         fixed(100 * model.period_participation, 0) +
         " % of the mass. It lengthens when joints open, so it holds for weak shaking only.";
}

Html settle_words(const SettleSheet& s) {
  const std::string how =
      fmt::format("{} simulated; greatest movement {}; largest net force {} of the block's own weight.",
                  seconds(s.duration), length(s.greatest_movement), significant(s.unbalanced_ratio, 2));
  if (s.settled)
    return paragraph("The building came to rest under its own weight before the motion began: " + how);
  return raw("<p><span class=\"bad\">The building did not come to rest under its own weight</span> ") +
         text("before the motion began: " + how) + raw("</p>\n");
}

// ---- the response ----

std::string lost_words(const StoreyResponse& s) {
  return s.lost_at ? "lost at " + seconds(*s.lost_at) : "stands";
}

Html drift_table(const RunResult& run) {
  std::vector<std::vector<std::string>> rows;
  for (auto s = run.response.storeys.rbegin(); s != run.response.storeys.rend(); ++s) {
    if (s->is_base) continue;
    const auto& [plus, minus] = s->peak_drift;
    rows.push_back({s->name, signed_fixed(100 * plus.value, 3), drift_fraction(plus.value),
                    fixed(plus.time, 2), signed_fixed(100 * minus.value, 3), drift_fraction(minus.value),
                    fixed(minus.time, 2), signed_fixed(100 * s->residual_drift, 3),
                    signed_fixed(100 * s->peak_shear_drift.largest().value, 3), lost_words(*s)});
  }
  return table(
      "Peak interstorey drift ratio of both signs, before any loss; residual: mean of the last second, or "
      "the value at the loss; sheared: the peak without the rotation of the storey's base",
      {{"Storey", "", false},
       {"Peak +", "%"},
       {"as", "1/n"},
       {"at", "s"},
       {"Peak −", "%"},
       {"as", "1/n"},
       {"at", "s"},
       {"Residual", "%"},
       {"Sheared", "%"},
       {"State", ""}},
      rows);
}

// Of isolators: how far the building went over them.
Html base_words(const RunResult& run) {
  Html out;
  for (const auto& storey : run.response.storeys) {
    if (!storey.is_base || storey.floor_displacement.empty()) continue;
    const auto [least, most] = std::ranges::minmax(storey.floor_displacement);
    out += paragraph(
        storey.name + ": displaced over the ground by " + displacement(most) + " and " + displacement(least) +
        ", " + displacement(storey.floor_displacement.back()) +
        " at the end. It is the level of the isolators; the drifts are those of the storeys above.");
  }
  return out;
}

Html acceleration_table(const RunResult& run) {
  constexpr double g = engine::standard_gravity;
  std::vector<std::vector<std::string>> rows;
  for (auto s = run.response.storeys.rbegin(); s != run.response.storeys.rend(); ++s) {
    const auto& [plus, minus] = s->peak_acceleration;
    rows.push_back({s->name, signed_fixed(plus.value / g, 3), signed_fixed(plus.value, 2),
                    fixed(plus.time, 2), signed_fixed(minus.value / g, 3), signed_fixed(minus.value, 2),
                    fixed(minus.time, 2)});
  }
  return table("Peak floor acceleration, absolute, before any loss (1 g = 9.80665 m/s²)",
               {{"Floor of", "", false},
                {"Peak +", "g"},
                {"", "m/s²"},
                {"at", "s"},
                {"Peak −", "g"},
                {"", "m/s²"},
                {"at", "s"}},
               rows);
}

std::vector<std::string> envelope_row(const std::string& name, const Envelope& e, double factor,
                                      int decimals) {
  return {name, signed_fixed(factor * e.positive.value, decimals), fixed(e.positive.time, 2),
          signed_fixed(factor * e.negative.value, decimals), fixed(e.negative.time, 2)};
}

Html building_table(const RunResult& run) {
  const auto& r = run.response;
  std::vector<std::vector<std::string>> rows{
      envelope_row("Roof displacement, relative to the ground (mm)", r.peak_roof_displacement, 1e3, 1),
      envelope_row("Base shear, V (kN)", r.peak_base_shear, 1e-3, 1)};
  if (r.weight > 0)
    rows.push_back(envelope_row("Base shear over weight, V/W (-)", r.peak_base_shear, 1 / r.weight, 3));
  if (!r.overturning_moment.empty())
    rows.push_back(
        envelope_row("Overturning moment about the foot, M (kN m)", r.peak_overturning_moment, 1e-3, 1));
  return table("The whole building, both signs; W = " + fixed(r.weight / 1e3, 1) + " kN",
               {{"Quantity", "", false}, {"Peak +", ""}, {"at", "s"}, {"Peak −", ""}, {"at", "s"}}, rows);
}

Html loss_table(const RunResult& run) {
  constexpr std::size_t most = 20;
  const auto& losses = run.response.losses;
  if (losses.empty()) return paragraph("No block lost its support.");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(most, losses.size()); ++i) {
    const auto& loss = losses[i];
    const std::string name = loss.block < run.model.blocks.size() ? run.model.blocks[loss.block].name
                                                                  : "block " + std::to_string(loss.block);
    rows.push_back({fixed(loss.time, 2) + " s", name, loss.reason});
  }
  const std::string shown = losses.size() > most
                                ? fmt::format("The first {} of {} blocks lost", most, losses.size())
                                : plural(losses.size(), "block") + " lost, in order of time";
  return table(shown, {{"Time", "", false}, {"Block", "", false}, {"How", "", false}}, rows);
}

}  // namespace

Html page_model(const RunResult& run, const std::vector<Picture>& pictures) {
  const ModelSheet& m = run.model;
  Html out = paragraph(m.title);
  out += figure_named(pictures, "figures/model.svg", "Elevation to scale, as described, coloured by storey.",
                      {"figures/model.svg", "figures/model.png"});
  out += storey_table(m) + named_values("Parameters of the layout", "Parameter", m.parameters) +
         named_values("Materials", "Material", m.materials);
  out += paragraph(period_words(m)) +
         paragraph(fmt::format("{}, {} touching after the settle.", plural(m.bonds, "bond"),
                               plural(m.contact_points, "contact point")));
  out +=
      heading3("Settling under gravity") + settle_words(run.settle) + heading3("Findings of the model check");
  return out + (m.findings.empty() ? raw("<p class=\"fine\">None.</p>\n") : list(m.findings));
}

Html page_motion(const RunResult& run, const std::vector<Picture>& pictures) {
  Html out = plot(pictures, "motion",
                  "What the terrain did: absolute ground motion. Dots: peaks of both signs.", "motion.csv");
  out += named_values("Measures of the motion as applied", "Measure", run.motion.measures);
  out += plot(
      pictures, "spectrum",
      "Pseudo-acceleration (left) and displacement (right, thin) of a 5 % damped oscillator; dashed: the "
      "building's period.",
      "spectrum.csv");
  out += named_values("Where the record comes from", "Item", run.motion.provenance) +
         heading3("Processing, in order");
  return out + (run.motion.processing.empty() ? paragraph("None: the motion was applied as found.")
                                              : list(run.motion.processing));
}

Html page_response(const RunResult& run, const std::vector<Picture>& pictures) {
  Html out = run.response.storeys.empty() ? paragraph("The building has no storeys, so no drift is measured.")
                                          : drift_table(run) + base_words(run) + acceleration_table(run);
  out +=
      plot(pictures, "floor_profiles",
           "Dashed verticals: the drift limits nearest to what was found (screening, not code compliance).",
           "storeys.csv");
  out += building_table(run) + heading3("Blocks lost") + loss_table(run);
  out += plot(pictures, "drift_histories",
              "Each storey on its own axis, all on one time axis. A lost storey's drift is frozen at its "
              "loss (cross, dashed).",
              "drift.csv");
  out += plot(pictures, "roof_and_base_shear",
              "Ground acceleration, roof displacement relative to the ground, base shear over weight, "
              "overturning moment of the horizontal inertia forces over weight times height.",
              "roof_and_base_shear.csv");
  out += plot(pictures, "hysteresis",
              "Base shear and overturning moment against roof drift, with the sign of the resistance, until "
              "the first "
              "storey was lost: the area "
              "of a loop is what a cycle dissipates.",
              "roof_and_base_shear.csv");
  return out +
         plot(pictures, "floor_spectra",
              "What equipment on a floor feels: 5 % damped pseudo-acceleration of each floor's absolute "
              "acceleration, until its storey was lost; black: the ground.",
              "floor_spectra.csv");
}

Html page_energy(const RunResult& run, const std::vector<Picture>& pictures) {
  return paragraph(
             "What the ground put in equals what moves, was lifted, is stored in contacts or was dissipated. "
             "The rest is error: " +
             energy_error_words(run) + " (the input and what gravity gave).") +
         plot(pictures, "energy_stack", "Where the energy is and went, stacked; lines: what came in.",
              "energy.csv") +
         plot(pictures, "energy", "Cumulated energies; below, the error of their balance.", "energy.csv");
}

Html page_film(const RunResult& run, const std::vector<Picture>& pictures) {
  const Html strip =
      figure_named(pictures, "figures/film_strip.png",
                   "Moments that matter, not equal intervals; same camera, fixed to the moving ground.",
                   {"figures/film_strip.png"});
  return strip.code.empty() ? paragraph("No positions were stored in this run" +
                                        std::string(run.partial ? ", which was interrupted." : "."))
                            : strip;
}

Html page_limits(const RunResult& run) {
  const auto part = [](const std::vector<std::string>& items) {
    return items.empty() ? paragraph("Not stated.") : list(items);
  };
  return heading3("Modelled") + part(run.model.modelled) + heading3("Not modelled") +
         part(run.model.not_modelled) +
         paragraph("This is screening by a plane rigid-block model, not a check against a building code.");
}

Html page_reproducibility(const RunResult& run) {
  const Reproducibility& r = run.reproducibility;
  Html out = table("", {{"Item", "", false}, {"Value", "", false}},
                   {{"Version", r.version + " (" + r.git_hash + ")"},
                    {"Compiler", r.compiler},
                    {"Command", r.command},
                    {"Scenario, SHA-256", r.scenario_sha256},
                    {"Record, SHA-256", r.record_sha256},
                    {"Final state, hash", r.state_hash},
                    {"Started", r.started},
                    {"Time taken", fixed(r.wall_seconds, 1) + " s on the clock, " + fixed(r.cpu_seconds, 1) +
                                       " s of processor"}});
  if (!r.scenario.empty())
    out += heading3("Scenario") + raw("<pre tabindex=\"0\">") + text(r.scenario) + raw("</pre>\n");
  return out +
         paragraph(
             "All numbers of this page: results.h5 (everything), summary.json, and the CSV files beside it.",
             "quiet");
}

}  // namespace dougong::app
