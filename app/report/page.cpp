#include "app/report/page.h"

#include <algorithm>

#include "app/report/text.h"
#include "report_css.h"

namespace dougong::app {
namespace {

struct Part {
  const char* id;
  const char* title;
  Html body;
};

Html section(const Part& part) {
  return raw(std::string("<section id=\"") + part.id + "\">\n") + heading2(part.title) + part.body +
         raw("</section>\n");
}

Html contents(const std::vector<Part>& parts) {
  std::string out = "<nav aria-label=\"Contents\"><ol>\n";
  for (const Part& part : parts) {
    out += std::string("<li><a href=\"#") + part.id + "\">" + escape_markup(part.title) + "</a></li>\n";
  }
  return raw(out + "</ol></nav>\n");
}

Html head(const RunResult& run) {
  return raw("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>") +
         text(run.model.layout + " on " + run.motion.title + ": " + structures::to_string(run.verdict.kind)) +
         raw("</title>\n<style>\n") + raw(report_css) +
         raw("</style>\n</head>\n<body>\n"
             "<a class=\"skip\" href=\"#answer\">To the answer</a>\n<main>\n");
}

}  // namespace

Html figure_named(const std::vector<Picture>& pictures, std::string_view name, std::string_view caption,
                  const std::vector<std::string>& links) {
  const auto found =
      std::find_if(pictures.begin(), pictures.end(), [&](const Picture& p) { return p.name == name; });
  return found == pictures.end() ? Html{} : figure(*found, caption, links);
}

std::string report_page(const RunResult& run, const std::vector<Picture>& pictures) {
  const std::vector<Part> parts{{"model", "The building", page_model(run, pictures)},
                                {"motion", "The ground motion", page_motion(run, pictures)},
                                {"response", "The response", page_response(run, pictures)},
                                {"screening", "Against the limits of standards", page_screening(run)},
                                {"damage", "Damage of the bonds", page_damage(run)},
                                {"fall", "How it fell", page_collapse(run, pictures)},
                                {"spread", "How sure", page_spread(run)},
                                {"energy", "Energy balance", page_energy(run, pictures)},
                                {"film", "What it looked like", page_film(run, pictures)},
                                {"numerics", "Numerical quality", page_numerics(run, pictures)},
                                {"limits", "What was modelled and what was not", page_limits(run)},
                                {"reproduce", "To reproduce this run", page_reproducibility(run)}};
  Html page = head(run) + page_answer(run, pictures) + contents(parts);
  for (const Part& part : parts) page += section(part);
  return (page + raw("</main>\n</body>\n</html>\n")).code;
}

}  // namespace dougong::app
