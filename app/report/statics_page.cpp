// The page of a static analysis: the answer, the figures, the trials, what it does not say.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/page.h"
#include "app/report/page_frame.h"
#include "app/report/statics_report.h"
#include "app/report/text.h"
#include "app/study/version.h"

namespace dougong::app {
namespace {

constexpr std::size_t told_events = 20, told_joints = 30;

std::string title_of(const StaticResult& r) {
  return fmt::format("{}: {}", r.model.layout,
                     r.choice.pattern ? "pushover, " + to_string(*r.choice.pattern) + " pattern"
                                      : std::string("tilting table"));
}

std::string sentence(const StaticResult& r, const SideResult& s) {
  std::string out = fmt::format("Towards the {}: λ {}", to_string(s.side), bracket_text(s.found));
  if (!r.choice.pattern && std::isfinite(s.found.falls))
    out += fmt::format(", a tilt of {}° to {}°", fixed(tilt_degrees(s.found.stands), 2),
                       fixed(tilt_degrees(s.found.falls), 2));
  if (!s.found.mechanism.empty()) out += "; " + mechanism_text(s, r.model.blocks.size());
  return out + ".";
}

Html answer(const StaticResult& r) {
  std::vector<std::string> sentences;
  for (const SideResult& s : r.sides) sentences.push_back(sentence(r, s));
  Html out = raw("<header id=\"answer\">\n<h1>") + text(title_of(r)) + raw("</h1>\n") +
             paragraph(r.model.title, "quiet");
  out += raw("<div class=\"verdict undecided\">\n<p class=\"kind\">Collapse multiplier λ</p>\n") +
         list(sentences) + raw("</div>\n");
  if (r.interrupted)
    out += raw("<div class=\"notice\" role=\"note\"><strong>Interrupted.</strong> ") +
           text("Below is what was found up to then.") + raw("</div>\n");
  return out +
         paragraph(
             r.choice.pattern
                 ? "λ is the sum of the horizontal forces over the weight, V/W. Stated are the greatest "
                   "that stood and the least that did not."
                 : "λ = tan θ: the part of its weight that every block is pushed with sideways. Stated "
                   "are the greatest that stood and the least that did not.") +
         raw("</header>\n");
}

Html curve_part(const StaticResult& r, const std::vector<Picture>& pictures) {
  Html out =
      figure_named(pictures, "figures/capacity.svg",
                   "Points are equilibria, found with the loads pulled through a spring: past the peak the "
                   "building would go on by itself under dead loads.",
                   {"figures/capacity.svg", "figures/capacity.png", "capacity.csv"});
  for (const SideResult& s : r.sides) {
    if (s.curve.points.empty()) continue;
    out += paragraph(fmt::format("Towards the {}: {} points; {}.", to_string(s.side), s.curve.points.size(),
                                 to_string(s.curve.end)));
  }
  return out;
}

Html events_part(const StaticResult& r) {
  Html out;
  for (const SideResult& s : r.sides) {
    if (s.curve.events.empty()) continue;
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < std::min(told_events, s.curve.events.size()); ++i) {
      const auto& e = s.curve.events[i];
      const auto& p = s.curve.points[e.point];
      rows.push_back({std::to_string(i + 1), r.building.scene.bonds[e.bond].name, e.how,
                      fixed(p.multiplier, 4), fixed(1e3 * p.roof, 2), fixed(100.0 * p.roof / r.height, 3)});
    }
    out += table(fmt::format("Towards the {}, the first {} of {}", to_string(s.side), rows.size(),
                             s.curve.events.size()),
                 {{"", "", false},
                  {"Bond", "", false},
                  {"How", "", false},
                  {"V/W", "-"},
                  {"Roof", "mm"},
                  {"Drift", "%"}},
                 rows);
  }
  return out;
}

std::string name_of(const StaticResult& r, std::size_t body) {
  const std::size_t blocks = r.model.blocks.size();
  return body < blocks ? r.model.blocks[body].name : r.model.terrains[body - blocks].name;
}

Html joints_table(const StaticResult& r, const SideResult& s) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(told_joints, s.mechanism.joints.size()); ++i) {
    const auto& j = s.mechanism.joints[i];
    rows.push_back(
        {to_string(j.action), name_of(r, j.a), name_of(r, j.b), fixed(j.place.x, 3), fixed(j.place.y, 3)});
  }
  if (rows.empty()) return {};
  return table("", {{"Joint", "", false}, {"of", "", false}, {"and", "", false}, {"x", "m"}, {"y", "m"}},
               rows);
}

Html mechanism_part(const StaticResult& r, const std::vector<Picture>& pictures) {
  Html out;
  for (const SideResult& s : r.sides) {
    if (s.found.mechanism.empty()) continue;
    const std::string name = "figures/mechanism_" + to_string(s.side);
    out += figure_named(pictures, name + ".svg", mechanism_text(s, r.model.blocks.size()) + ".",
                        {name + ".svg", name + ".png", "mechanism.csv"}) +
           joints_table(r, s);
  }
  return out;
}

Html trials_part(const StaticResult& r, const std::vector<Picture>& pictures) {
  return figure_named(
             pictures, "figures/trials.svg",
             "Each trial starts where the last one stood, looks for its equilibrium and is then watched "
             "without damping.",
             {"figures/trials.svg", "figures/trials.png", "trials.csv"}) +
         paragraph(fmt::format("Bracket of {} %; what stands at its lower end was watched for {}.",
                               significant(100.0 * r.choice.precision, 2), seconds(r.choice.hold_time)));
}

Html limits_part() {
  return list(
      {"Blocks are rigid and the model is plane: what crushes or cracks within a block, and what goes out of "
       "the plane, is not seen.",
       "With friction the multiplier depends on the path; this is that of a load that grows slowly. It lies "
       "at "
       "or below that of limit analysis with dilatant joints.",
       "A static capacity is no seismic one: blocks that rock survive accelerations well above λ g for a "
       "short time, and fall below it when shaken for long.",
       "The capacity curve ends where no equilibrium is near: what is brittle jumps."});
}

}  // namespace

std::string bracket_text(const structures::CollapseMultiplier& found) {
  if (found.trials.empty()) return "not looked for";
  if (found.falls == 0.0) return "0: it does not stand under its weight";
  if (!std::isfinite(found.falls))
    return fmt::format("at least {} (the search ended there)", fixed(found.stands, 4));
  std::string out = fmt::format("{} stands, {} ", fixed(found.stands, 4), fixed(found.falls, 4));
  return out + (found.end == structures::TrialResult::falls ? "falls" : "is " + to_string(found.end));
}

std::string mechanism_text(const SideResult& side, std::size_t blocks) {
  std::size_t hinges = 0, slides = 0, parts = 0;
  for (const auto& joint : side.mechanism.joints) {
    hinges += joint.action == structures::JointAction::hinge;
    slides += joint.action == structures::JointAction::sliding;
    parts += joint.action == structures::JointAction::parting;
  }
  std::string out = fmt::format("{} of {} blocks in motion", side.mechanism.moving.size(), blocks);
  for (const auto& [count, noun] :
       {std::pair{hinges, "hinge"}, {slides, "sliding joint"}, {parts, "parting joint"}})
    if (count > 0) out += ", " + plural(count, noun);
  return out;
}

std::string statics_page(const StaticResult& r, const std::vector<Picture>& pictures,
                         const std::string& command) {
  std::vector<std::string> findings;
  for (const auto& finding : r.findings)
    findings.push_back(to_string(finding.severity) + ": " + finding.message);
  return framed_page(title_of(r), answer(r),
                     {{"curve", "The capacity curve", curve_part(r, pictures)},
                      {"events", "What cracks and yields, in which order", events_part(r)},
                      {"mechanism", "The mechanism", mechanism_part(r, pictures)},
                      {"trials", "The search", trials_part(r, pictures)},
                      {"findings", "Findings of the model check", list(findings)},
                      {"limits", "What this does not say", limits_part()},
                      {"reproduce", "To repeat it",
                       raw("<pre>") + text(command) + raw("</pre>\n") +
                           paragraph(fmt::format("dougong {} ({}, {})", program_version(), program_git_hash(),
                                                 program_compiler()),
                                     "small quiet")}});
}

}  // namespace dougong::app
