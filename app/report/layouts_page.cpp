#include "app/report/layouts_page.h"

#include "app/report/html.h"
#include "app/report/model_svg.h"
#include "app/report/page_frame.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr int drawing_width = 520;  // px

Html table_of_all(const std::vector<LayoutEntry>& entries) {
  std::vector<std::vector<std::string>> rows;
  for (const LayoutEntry& e : entries)
    rows.push_back({e.model.layout, e.model.title, std::to_string(e.model.blocks.size()),
                    std::to_string(e.model.bonded.size()), std::to_string(e.model.storeys.size()),
                    mass_text(e.model.mass), e.period});
  return table("The layouts with their defaults",
               {{"Layout", "", false},
                {"What it is", "", false},
                {"Blocks", ""},
                {"Bonds", ""},
                {"Storeys", ""},
                {"Mass", ""},
                {"Period", ""}},
               rows);
}

Html section_of(const LayoutEntry& e) {
  const Picture drawing{e.model.layout + ".svg", "image/svg+xml", model_svg(e.model),
                        "Elevation of " + e.model.layout, drawing_width};
  return paragraph(e.model.title + ".") + paragraph(e.counting, "quiet") +
         figure(drawing, "Elevation to scale, coloured by storey.", {}) +
         table(
             "Parameters of " + e.model.layout,
             {{"Parameter", "", false}, {"Default", "", false}, {"Range", "", false}, {"Meaning", "", false}},
             e.parameters);
}

}  // namespace

std::string layouts_page(const std::vector<LayoutEntry>& entries) {
  const Html answer = raw("<header id=\"answer\">\n<h1>Layouts</h1>\n") +
                      paragraph("Period: small vibrations after settling, every contact stuck.") +
                      table_of_all(entries) + raw("</header>\n");
  std::vector<PagePart> parts;
  for (const LayoutEntry& e : entries)
    parts.push_back({e.model.layout.c_str(), e.model.layout.c_str(), section_of(e)});
  return framed_page("Layouts", answer, parts);
}

}  // namespace dougong::app
