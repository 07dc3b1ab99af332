// C03: the tilt at which an arch of 25 voussoirs falls.
#include <fmt/format.h>

#include <cmath>

#include "tests/bench/comparisons/comparison.h"
#include "tests/bench/comparisons/drawing.h"
#include "tests/scenes/arches.h"

namespace dougong::comparisons {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double exact_tilt = 17.106;  // deg, linear programme

struct Setting {
  double young_modulus, damping_ratio, local_damping;  // Pa, -, -
};

structures::CollapseMultiplier measure(const Setting& setting) {
  structures::TiltOptions options;
  options.precision = 0.0025;
  options.trial.local_damping = setting.local_damping;
  return structures::find_collapse_multiplier(
      scenes::tilting_arch(setting.young_modulus, setting.damping_ratio).scene(), options);
}

std::string row(const Setting& setting, const structures::CollapseMultiplier& found) {
  const double stands = std::atan(found.stands) / degree, falls = std::atan(found.falls) / degree;
  return fmt::format("| {:g} | {:g} | {:g} | {:.3f} | {:.3f} | {:+.2f} to {:+.2f} % | {} |\n",
                     setting.young_modulus / 1e9, setting.damping_ratio, setting.local_damping, stands, falls,
                     100.0 * (stands / exact_tilt - 1.0), 100.0 * (falls / exact_tilt - 1.0),
                     found.trials.size());
}

}  // namespace

Comparison tilting_arch() {
  const Setting settings[] = {
      {1.0, 1.0, 0.8}, {0.1, 1.0, 0.8}, {0.01, 1.0, 0.8}, {0.1, 0.2, 0.8}, {0.1, 1.0, 0.4}};
  Comparison comparison;
  comparison.table =
      "| E (GPa) | damping ratio | local damping | stands at (deg) | falls at (deg) | against 17.106 deg | "
      "trials "
      "|\n|---|---|---|---|---|---|---|\n";
  for (Setting setting : settings) {
    setting.young_modulus *= 1e9;
    const structures::CollapseMultiplier found = measure(setting);
    comparison.table += row(setting, found);
    if (comparison.figure.data.empty()) {
      const engine::Scene scene = scenes::tilting_arch(setting.young_modulus).scene();
      comparison.figure.data["before"] = outlines(scene);
      comparison.figure.data["after"] =
          outlines(scene, found.mechanism, magnification(found.mechanism, 0.04));
    }
  }
  comparison.figure.height = 460;
  comparison.figure.script =
      look +
      "set size ratio -1\nset xlabel 'm'\nset ylabel 'm'\n"
      "plot 'before' with lines lw 1 lc rgb '#bbbbbb' title 'at rest', 'after' with lines "
      "lw 1.4 lc rgb '" +
      app::to_hex(app::category(0)) + "' title 'mechanism, magnified'\n";
  return comparison;
}

}  // namespace dougong::comparisons
