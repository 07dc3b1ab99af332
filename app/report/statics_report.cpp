#include "app/report/statics_report.h"

#include <algorithm>

#include "app/report/safe_file.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

bool has_curve(const StaticResult& r) {
  return std::ranges::any_of(r.sides, [](const SideResult& s) { return s.curve.points.size() > 1; });
}

std::vector<NamedFigure> figures_of(const StaticResult& r) {
  std::vector<NamedFigure> figures{{"trials", "Every trial of the search and its result", trials_figure(r)}};
  if (has_curve(r))
    figures.push_back({"capacity", "Base shear over weight against roof drift", capacity_figure(r)});
  for (const SideResult& s : r.sides)
    if (!s.found.mechanism.empty())
      figures.push_back({"mechanism_" + to_string(s.side), mechanism_text(s, r.model.blocks.size()),
                         mechanism_figure(r, s)});
  return figures;
}

}  // namespace

std::vector<std::string> write_statics(const StaticResult& r, const std::string& command,
                                       const std::filesystem::path& folder) {
  make_directory(folder / "figures");
  Output output(folder);
  std::vector<Picture> pictures;
  const std::string kind = kind_of(r.choice);
  output.write(kind + ".json", statics_json(r, command));
  output.write("trials.csv", trials_csv(r));
  output.write("mechanism.csv", mechanism_csv(r));
  if (r.choice.pattern) output.write("capacity.csv", capacity_csv(r));
  if (r.choice.pattern) output.write("bond_events.csv", bond_events_csv(r));
  for (const NamedFigure& figure : figures_of(r)) write_figure(figure, output, pictures);
  output.write(kind + ".html", statics_page(r, pictures, command));
  std::vector<std::string> names = output.names();
  std::rotate(names.begin(), names.end() - 1, names.end());
  return names;
}

}  // namespace dougong::app
