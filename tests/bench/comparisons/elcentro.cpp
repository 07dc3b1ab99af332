// C05 and C06: single-degree systems and a five-storey frame under the recording of El Centro 1940, which is
// read from a folder that the project does not hold.
#include <fmt/format.h>

#include <stdexcept>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/el_centro.h"

namespace dougong::comparisons {
namespace {

scenes::RecordedMotion recording(const Arguments& arguments, double gravity) {
  if (arguments.empty()) throw std::runtime_error("expected the path of elCentro.AT2 behind the folder");
  return scenes::el_centro(arguments[0], gravity);
}

std::vector<double> times_of(const scenes::ChainHistory& history) {
  std::vector<double> times;
  for (std::size_t k = 0; k < history.displacement[0].size(); ++k)
    times.push_back(static_cast<double>(k) * history.interval);
  return times;
}

}  // namespace

Comparison single_degree(const Arguments& arguments) {
  const scenes::RecordedMotion motion = recording(arguments, scenes::gravity_in_inches);
  Comparison comparison;
  comparison.table =
      "| T (s) | damping (%) | published (in) | exact (in) | ours (in) | ours/exact "
      "|\n|---|---|---|---|---|---|\n";
  comparison.figure.script =
      look +
      "set xlabel 'time (s)'\nset ylabel 'relative displacement (in)'\nplot 0 lc rgb '#888888' notitle";
  for (std::size_t i = 0; i < scenes::single_degree_cases.size(); ++i) {
    const scenes::SingleDegreeCase& c = scenes::single_degree_cases[i];
    const scenes::ChainHistory history =
        scenes::by_engine(c.level(), {c.ratio}, motion.acceleration, motion.interval, motion.interval);
    const double peak = scenes::peaks_of(history, c.level(), 1.0).roof / 0.0254;
    comparison.table += fmt::format("| {:g} | {:g} | {:.2f} | {:.3f} | {:.3f} | {:.5f} |\n", c.period,
                                    100.0 * c.ratio, c.published, c.exact, peak, peak / c.exact);
    if (c.ratio != 0.02) continue;
    std::vector<double> inches = history.displacement[0];
    for (double& u : inches) u /= 0.0254;
    const std::string name = fmt::format("case{}", i);
    comparison.figure.data[name] = columns({times_of(history), inches});
    comparison.figure.script += fmt::format(", '{}' with lines lw 1.2 lc rgb '{}' title 'T {:g} s, 2 %'",
                                            name, app::to_hex(app::category(i)), c.period);
  }
  comparison.figure.script += "\n";
  return comparison;
}

Comparison five_storey_frame(const Arguments& arguments) {
  const scenes::RecordedMotion motion = recording(arguments, scenes::gravity_in_metres);
  const auto& levels = scenes::five_storeys;
  const scenes::ChainHistory ours =
      scenes::by_engine(levels, scenes::five_percent, motion.acceleration, motion.interval, 0.002);
  const scenes::FramePeaks p = scenes::peaks_of(ours, levels, 4.0);
  Comparison comparison;
  comparison.table = "| quantity | published | exact | ours | ours/exact |\n|---|---|---|---|---|\n";
  const auto add = [&](const std::string& what, const std::string& published, double exact, double found) {
    comparison.table +=
        fmt::format("| {} | {} | {:g} | {:.5g} | {:.5f} |\n", what, published, exact, found, found / exact);
  };
  add("roof displacement (cm)", "17.383", 17.396, 100.0 * p.roof);
  add("base shear (kN)", "323.062", 323.18, p.base_shear / 1e3);
  add("top-storey shear (kN)", "155.308", 155.53, p.top_shear / 1e3);
  add("base moment (kN m)", "3811.79", 3814.5, p.base_moment / 1e3);
  for (std::size_t i = 0; i < 5; ++i)
    add(fmt::format("drift of storey {} (mm)", i + 1), "", scenes::five_storey_drifts[i], 1e3 * p.drift[i]);
  const scenes::ChainHistory exact =
      scenes::by_superposition(levels, scenes::five_percent, motion.acceleration, motion.interval, 10);
  comparison.figure.data["exact"] = columns({times_of(exact), exact.displacement[4]}, 5);
  comparison.figure.data["ours"] = columns({times_of(ours), ours.displacement[4]}, 5);
  comparison.figure.script =
      look +
      "set xlabel 'time (s)'\nset ylabel 'roof displacement (cm)'\n"
      "plot 'exact' using 1:($2*100) with lines lw 5 lc rgb '#cccccc' title 'superposition of "
      "modes', 'ours' using 1:($2*100) with lines lw 1.2 lc rgb '" +
      app::to_hex(app::category(0)) + "' title 'bonded storeys'\n";
  return comparison;
}

}  // namespace dougong::comparisons
