#include "app/report/page.h"

#include <algorithm>

#include "app/report/moved_joints_report.h"
#include "app/report/page_frame.h"
#include "app/report/weight_joints_report.h"

namespace dougong::app {

Html figure_named(const std::vector<Picture>& pictures, std::string_view name, std::string_view caption,
                  const std::vector<std::string>& links) {
  const auto found =
      std::find_if(pictures.begin(), pictures.end(), [&](const Picture& p) { return p.name == name; });
  return found == pictures.end() ? Html{} : figure(*found, caption, links);
}

std::string report_page(const RunResult& run, const std::vector<Picture>& pictures) {
  const std::vector<PagePart> parts{{"model", "The building", page_model(run, pictures)},
                                    {"weight", "Under its own weight", page_weight(run, pictures)},
                                    {"motion", "The ground motion", page_motion(run, pictures)},
                                    {"response", "The response", page_response(run, pictures)},
                                    {"screening", "Against the limits of standards", page_screening(run)},
                                    {"joints", "The joints", page_moved_joints(run, pictures)},
                                    {"damage", "Damage of the bonds", page_damage(run, pictures)},
                                    {"fall", "How it fell", page_collapse(run, pictures)},
                                    {"spread", "How sure", page_spread(run, pictures)},
                                    {"energy", "Energy balance", page_energy(run, pictures)},
                                    {"film", "What it looked like", page_film(run, pictures)},
                                    {"numerics", "Numerical quality", page_numerics(run, pictures)},
                                    {"limits", "What was modelled and what was not", page_limits(run)},
                                    {"reproduce", "To reproduce this run", page_reproducibility(run)}};
  return framed_page(
      run.model.layout + " on " + run.motion.title + ": " + structures::to_string(run.verdict.kind),
      page_answer(run, pictures), parts);
}

}  // namespace dougong::app
