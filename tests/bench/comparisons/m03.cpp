// M03: a laboratory frame of three storeys, whose modes have damping ratios of their own.
#include <fmt/format.h>

#include <cmath>

#include "engine/modes.h"
#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/laboratory_frame.h"

namespace dougong::comparisons {
namespace {

std::string row(std::size_t mode, const engine::Mode& found, double ratio) {
  const scenes::PublishedMode& p = scenes::laboratory_modes[mode];
  const double sign = found.shape[0] < 0.0 ? -1.0 : 1.0;
  return fmt::format(
      "| {} | {:.3f} | {:.3f} | {:.4f}, {:.4f}, {:.4f} | {:.4f}, {:.4f}, {:.4f} | {:.2f} | {:.3f} |\n",
      mode + 1, p.frequency, std::sqrt(found.angular_frequency_squared), p.shape[0], p.shape[1], p.shape[2],
      sign * found.shape[0], sign * found.shape[1], sign * found.shape[2], 100.0 * p.ratio, 100.0 * ratio);
}

}  // namespace

Comparison laboratory_frame() {
  const scenes::Running r(scenes::shear_building_scene(scenes::laboratory_levels(), nullptr));
  const auto modes = engine::horizontal_modes(r.model, r.state, 3);
  Comparison comparison;
  comparison.table =
      "| mode | measured (rad/s) | ours | shape | ours | damping ratio (%) | ours, by the decay |\n"
      "|---|---|---|---|---|---|---|\n";
  comparison.figure.script = look +
                             "set xlabel 'time over the mode''s period'\nset ylabel 'modal coordinate over "
                             "its first peak'\nplot 0 lc rgb '#888888' notitle";
  for (std::size_t j = 0; j < 3; ++j) {
    const scenes::Decay decay = scenes::decay_of_mode(j);
    comparison.table += row(j, modes[j], decay.ratio);
    const std::string name = "mode" + std::to_string(j);
    comparison.figure.data[name] = columns({decay.cycles, decay.swing});
    comparison.figure.script += fmt::format(", '{}' with lines lw 1.4 lc rgb '{}' title 'mode {}'", name,
                                            app::to_hex(app::category(j)), j + 1);
  }
  comparison.figure.script += "\n";
  return comparison;
}

}  // namespace dougong::comparisons
