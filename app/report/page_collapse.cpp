// The section of the report on how a building fell: when, in which mode, in which order, where to.
#include <algorithm>

#include "app/report/collapse_sequence.h"
#include "app/report/page.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using structures::Collapse;
using structures::CollapseMode;

constexpr std::size_t listed = 20;  // of the sequence and the hits; the CSV files have all

const char* meaning_of(CollapseMode mode) {
  switch (mode) {
    case CollapseMode::none:
      return "nothing was lost";
    case CollapseMode::partial:
      return "single blocks fell, every storey kept its floor";
    case CollapseMode::pounding:
      return "neighbours hit each other just before the first block lost its support";
    case CollapseMode::overturning:
      return "what fell turned over as one body";
    case CollapseMode::sliding:
      return "blocks left their places sideways without turning";
    case CollapseMode::out_of_support:
      return "a floor or beam came off what carried it, which stood";
    case CollapseMode::partial_wall:
      return "part of a wall fell from what carried it, which stood";
    case CollapseMode::pancake:
      return "floors came straight down on one another";
    case CollapseMode::soft_storey:
      return "one storey took most of the sideways displacement";
    case CollapseMode::sway:
      return "the sideways displacement was spread over the storeys";
  }
  return "";
}

std::string time_or_none(const std::optional<double>& time) {
  return time ? seconds(*time) : "none";
}

Html times_table(const Collapse& c) {
  std::vector<std::vector<std::string>> rows{
      {"Initiation", time_or_none(c.initiation), "the first support of the storeys that were lost was gone"},
      {"Point of no return", time_or_none(c.no_return),
       "from here gravity drove, to the end; known with hindsight"},
      {"Complete", time_or_none(c.complete), "the last storey that was lost was lost"}};
  if (c.first_touch)
    rows.push_back({"Neighbours touched", time_or_none(c.first_touch), "for the first time"});
  return table("", {{"Moment", "", false}, {"Time", ""}, {"Meaning", "", false}}, rows);
}

Html sequence_table(const RunResult& run) {
  const auto events = collapse_sequence(run);
  std::vector<std::vector<std::string>> rows;
  for (const CollapseEvent& e : events) {
    if (rows.size() == listed) break;
    rows.push_back({fixed(e.time, 2), e.what, e.where, e.storey, e.how});
  }
  return table(
      events.size() > listed ? "The first " + std::to_string(listed) + " of " +
                                   std::to_string(events.size()) + " events, at the output times"
                             : "All events, at the output times",
      {{"Time", "s"}, {"Event", "", false}, {"Where", "", false}, {"Storey", "", false}, {"How", "", false}},
      rows);
}

std::vector<std::string> side_row(const char* name, const structures::Side& side, double height) {
  return {name, fixed(side.reach, 2), height > 0 ? fixed(side.reach / height, 2) : "n/a",
          fixed(side.mass / 1e3, 2)};
}

Html footprint_table(const structures::Footprint& f) {
  Html out = table("How far debris lies beyond the faces of the building as it stood, at the end; H = " +
                       fixed(f.height, 2) + " m",
                   {{"Side", "", false}, {"Reach", "m"}, {"Reach", "H"}, {"Mass beyond the face", "t"}},
                   {side_row("left", f.left, f.height), side_row("right", f.right, f.height)});
  if (f.over_the_edge > 0)
    out += paragraph(plural(f.over_the_edge, "block") +
                     " fell over the end of the modelled ground and is not counted in the reach.");
  return out;
}

Html hits_table(const RunResult& run) {
  std::vector<structures::Fall> hardest = run.collapse.falls;
  std::ranges::stable_sort(hardest, std::ranges::greater{}, &structures::Fall::energy);
  std::vector<std::vector<std::string>> rows;
  for (const structures::Fall& f : hardest) {
    if (rows.size() == listed) break;
    const std::string name = f.block < run.model.blocks.size() ? run.model.blocks[f.block].name : "";
    rows.push_back({name, fixed(f.hit, 2), fixed(f.speed, 2), fixed(f.energy / 1e3, 2)});
  }
  return table("Greatest kinetic energy of a block after it lost its support, hardest first; " +
                   fixed(run.collapse.impact_energy / 1e3, 1) + " kJ in all " +
                   plural(run.collapse.falls.size(), "block"),
               {{"Block", "", false}, {"At", "s"}, {"Speed", "m/s"}, {"Energy", "kJ"}}, rows);
}

Html voids_part(const Collapse& c) {
  const std::string share = c.void_area_before > 0
                                ? ", " + fixed(100 * c.void_area / c.void_area_before, 0) + " % of the " +
                                      fixed(c.void_area_before, 1) + " m² before"
                                : "";
  Html out = paragraph("Covered spaces in which a circle of 0.5 m fits: " + fixed(c.void_area, 1) + " m²" +
                       share + ".");
  std::vector<std::vector<std::string>> rows;
  for (const structures::Void& v : c.voids) {
    if (rows.size() == 5) break;
    rows.push_back(
        {fixed(v.diameter, 2), fixed(v.area, 2), signed_fixed(v.middle.x, 1), fixed(v.middle.y, 1)});
  }
  if (rows.empty()) return out;
  return out + table("The largest", {{"Circle", "m"}, {"Area", "m²"}, {"Middle, x", "m"}, {"Middle, y", "m"}},
                     rows);
}

Html load_at_the_end(const std::vector<Picture>& pictures) {
  return figure_named(
      pictures, "figures/load_path_end.svg",
      "The load path at the end of the run: what presses what, the blocks where they are then; "
      "pale outlines: where they stood. That before the motion is under The building.",
      {"figures/load_path_end.svg", "figures/load_path_end.png", "load_path_end.csv"});
}

const char* why_untold(const RunResult& run) {
  if (run.verdict.kind == structures::VerdictKind::numerically_invalid)
    return "Not told: the numbers failed, so nothing is said of a fall.";
  if (!run.response.losses.empty())
    return "Blocks were lost, and this results file is from before it was told how: run the scenario again.";
  return "No block was lost during the run.";
}

}  // namespace

Html page_collapse(const RunResult& run, const std::vector<Picture>& pictures) {
  const Collapse& c = run.collapse;
  if (!c.happened())
    return paragraph(why_untold(run)) +
           (c.first_touch ? paragraph("The neighbours touched first at " + seconds(*c.first_touch) + ".")
                          : Html{}) +
           load_at_the_end(pictures);
  return paragraph("Mode: " + to_string(c.mode) + ", " + meaning_of(c.mode) + ".") + list(c.reasons) +
         times_table(c) + heading3("What gave way, in order") + sequence_table(run) +
         figure_named(pictures, "figures/mass_lost.svg", "Part of each storey's mass that was lost.",
                      {"figures/mass_lost.svg", "figures/mass_lost.png", "mass_lost.csv"}) +
         load_at_the_end(pictures) + heading3("Where the debris lies") + footprint_table(c.footprint) +
         heading3("How hard it hit") + hits_table(run) + heading3("Remaining voids") + voids_part(c) +
         paragraph(
             "All events: collapse_sequence.csv; all hits: falls.csv. The definitions are those of "
             "docs/theory/response.md.",
             "quiet");
}

}  // namespace dougong::app
