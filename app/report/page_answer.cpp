// The first screen of the report: verdict with its evidence, four numbers, one drawing, one profile.
#include <algorithm>
#include <cmath>

#include "app/report/page.h"
#include "app/report/spread_text.h"
#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::Peak;
using structures::StoreyResponse;
using structures::VerdictKind;

struct Number {
  std::string name;
  std::string value;
  std::string more;
  std::string meaning;
};

const char* style_of(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::survived:
      return "survived";
    case VerdictKind::collapsed:
      return "collapsed";
    case VerdictKind::numerically_invalid:
      return "invalid";
    case VerdictKind::undecided:
      return "undecided";
  }
  return "undecided";
}

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z')
    words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

Html partial_notice(const RunResult& run) {
  if (!run.partial) return {};
  return raw("<div class=\"notice\" role=\"note\"><strong>Partial run.</strong> ") +
         text("It was interrupted at " + seconds(run.numerics.end_time) + " of " +
              seconds(run.numerics.asked_time) + ". Everything below covers only the time up to then.") +
         raw("</div>\n");
}

Html warnings_notice(const RunResult& run) {
  const std::size_t count = run.numerics.warnings.size() + run.model.findings.size();
  if (count == 0) return {};
  return raw("<div class=\"notice\" role=\"note\"><strong>") + text(plural(count, "warning") + ".") +
         raw("</strong> ") +
         text(capitalised(run.numerics.warnings.empty() ? run.model.findings.front()
                                                        : run.numerics.warnings.front())) +
         raw(count > 1 ? " … All are under <a href=\"#numerics\">numerical quality</a> and <a "
                         "href=\"#model\">the building</a>."
                       : "") +
         raw("</div>\n");
}

Html verdict_box(const RunResult& run) {
  return raw(std::string("<div class=\"verdict ") + style_of(run.verdict.kind) + "\">\n<p class=\"kind\">") +
         text("Verdict: " + capitalised(structures::to_string(run.verdict.kind))) + raw("</p>\n") +
         paragraph(run.verdict.headline) + list(run.verdict.evidence) + raw("</div>\n");
}

const StoreyResponse* storey_of_peak_acceleration(const RunResult& run) {
  const auto& storeys = run.response.storeys;
  const auto size = [](const StoreyResponse& s) { return std::abs(s.peak_acceleration.largest().value); };
  const auto found = std::ranges::max_element(storeys, {}, size);
  return found == storeys.end() ? nullptr : &*found;
}

Number drift_number(const RunResult& run) {
  const StoreyResponse* storey = structures::storey_of_peak_drift(run.response);
  Number n{"Largest interstorey drift", "n/a", "no storeys",
           "Horizontal displacement of a floor against the one below, over the storey height; before any "
           "loss of the storey"};
  if (storey == nullptr) return n;
  const Peak peak = storey->peak_drift.largest();
  n.value = drift_percent(peak.value);
  n.more = drift_fraction(peak.value) + " in " + storey->name + " at " + seconds(peak.time);
  return n;
}

Number roof_number(const RunResult& run) {
  const Peak peak = run.response.peak_roof_displacement.largest();
  return {"Peak roof displacement", displacement(peak.value), "at " + seconds(peak.time),
          "Of the uppermost floor, relative to the ground"};
}

Number shear_number(const RunResult& run) {
  const Peak peak = run.response.peak_base_shear.largest();
  const double weight = run.response.weight;
  return {"Peak base shear, V/W", weight > 0 ? signed_fixed(peak.value / weight, 3) : "n/a",
          signed_fixed(peak.value / 1e3, 1) + " kN at " + seconds(peak.time),
          "Horizontal force of the ground on the building, over its weight; before any storey is lost"};
}

Number acceleration_number(const RunResult& run) {
  const StoreyResponse* storey = storey_of_peak_acceleration(run);
  Number n{"Peak floor acceleration", "n/a", "no storeys",
           "Absolute horizontal acceleration of a floor, before any loss of its storey"};
  if (storey == nullptr) return n;
  const Peak peak = storey->peak_acceleration.largest();
  n.value = acceleration_g(peak.value);
  n.more = signed_fixed(peak.value, 2) + " m/s², " + storey->name + " at " + seconds(peak.time);
  return n;
}

Number fallen_number(const RunResult& run) {
  std::string more = plural(run.response.losses.size(), "block") + " lost";
  if (run.response.first_loss_of_support)
    more += ", the first at " + seconds(*run.response.first_loss_of_support);
  return {"Fallen mass", fixed(100 * run.response.fallen_mass_fraction, 0) + " %", more,
          "Share of the building's mass that lost its place by the end"};
}

Html number_box(const Number& n) {
  return raw("<div class=\"number\"><dt>") + explained(n.name, n.meaning) +
         raw("</dt>\n<dd class=\"value\">") + text(n.value) + raw("</dd><dd>") + text(n.more) +
         raw("</dd></div>\n");
}

Html numbers_caveat(const RunResult& run) {
  const bool ensemble = run.ensemble.members.size() > 1;
  if (ensemble && run.verdict.kind != VerdictKind::numerically_invalid)
    return paragraph("With small changes of the building and the motion it " + collapse_text(run.ensemble) +
                     "; " + drift_spread_text(run.ensemble) + ".");
  if (run.verdict.kind != VerdictKind::numerically_invalid) {
    const std::string half = half_step_text(run.ensemble);
    return paragraph(
        "Single run: no spread computed. How far these numbers would move under small changes is not known "
        "from this run." +
            (half.empty() ? "" : " With half the step: " + half + "."),
        "quiet small");
  }
  return raw("<p class=\"bad\">") +
         text(
             "The numbers of this run failed: what is shown here and below explains the failure and says "
             "nothing "
             "about the building.") +
         raw("</p>\n") + paragraph("Single run: no spread computed.", "quiet small");
}

Html numbers(const RunResult& run) {
  const bool fell = !run.response.losses.empty();
  Html out = raw("<dl class=\"numbers\">\n");
  for (const Number& n : {drift_number(run), roof_number(run), shear_number(run),
                          fell ? fallen_number(run) : acceleration_number(run)}) {
    out += number_box(n);
  }
  return out + raw("</dl>\n") + numbers_caveat(run);
}

}  // namespace

Html page_answer(const RunResult& run, const std::vector<Picture>& pictures) {
  Html out = raw("<header id=\"answer\">\n<h1>") + text(run.model.layout + " on " + run.motion.title) +
             raw("</h1>\n");
  out += paragraph(run.model.title + (run.model.mass > 0 ? "; " + plural(run.model.blocks.size(), "block") +
                                                               ", " + mass_text(run.model.mass)
                                                         : ""),
                   "quiet");
  out += partial_notice(run) + verdict_box(run) + warnings_notice(run) + numbers(run) +
         raw("<div class=\"first\">\n");
  const Html scene =
      figure_named(pictures, "figures/scene.png", "What stood where, and what happened: drawn to scale.");
  out += scene.code.empty() ? figure_named(pictures, "figures/model.svg", "What stood where: drawn to scale.")
                            : scene;
  out += figure_named(pictures, "figures/drift_profile.svg", "How far each storey drifted.", {"drift.csv"});
  return out + raw("</div>\n</header>\n");
}

}  // namespace dougong::app
