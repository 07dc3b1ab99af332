// C01: the collapse multipliers of four dry running-bond walls.
#include <fmt/format.h>

#include "structures/load_pattern.h"
#include "structures/pushover.h"
#include "tests/bench/comparisons/comparison.h"
#include "tests/bench/comparisons/drawing.h"
#include "tests/scenes/ferris_walls.h"

namespace dougong::comparisons {
namespace {

struct Row {
  int number;
  double associative;
  const char* coulomb;   // published
  double young_modulus;  // Pa: wall 5, slender and open, sways too far at less
};

constexpr Row rows[] = {{1, 0.64286, "0.643 (0.6398)", 1e8},
                        {2, 0.58000, "0.564 (0.5626)", 1e8},
                        {3, 0.40369, "0.356", 1e8},
                        {5, 0.23964, "0.20-0.23", 1e9}};

structures::CollapseMultiplier tilt(int number, double young_modulus, double damping_ratio = 1.0) {
  return structures::find_collapse_multiplier(scenes::ferris_wall(number, young_modulus, damping_ratio));
}

structures::CollapseMultiplier push(int number, double young_modulus) {
  const engine::Scene scene = scenes::ferris_wall(number, young_modulus);
  const engine::Model model = engine::compile(scene);
  const std::vector<double> weights =
      structures::pattern_forces(model, engine::initial_state(model, scene), structures::LoadPattern::mass);
  const auto pushed = [&](double multiplier) { return structures::pushed(scene, weights, multiplier); };
  return structures::find_collapse_multiplier(scene, pushed, {});
}

std::string bracket(const structures::CollapseMultiplier& found) {
  return fmt::format("{:.4f} - {:.4f}", found.stands, found.falls);
}

std::string against(const structures::CollapseMultiplier& found, double associative) {
  return fmt::format("{:+.1f} %", 100.0 * (found.falls / associative - 1.0));
}

std::string table_row(const Row& row, const structures::CollapseMultiplier& tilted) {
  const auto pushed = push(row.number, row.young_modulus);
  return fmt::format("| {} | {} | {:g} | {:.5f} | {} | {} | {} | {} | {} |\n", row.number,
                     tilted.mechanism.size(), row.young_modulus / 1e9, row.associative, row.coulomb,
                     bracket(tilted), against(tilted, row.associative), bracket(pushed),
                     against(pushed, row.associative));
}

void add_panel(app::Figure& figure, int number, const structures::CollapseMultiplier& found) {
  const engine::Scene scene = scenes::ferris_wall(number, 1e8);
  const std::string name = "wall" + std::to_string(number);
  figure.data[name + "-before"] = outlines(scene);
  figure.data[name] = outlines(scene, found.mechanism, magnification(found.mechanism, 0.12));
  figure.script += fmt::format(
      "set title 'wall {0}, falls at {1:.3f}'\nplot [-1.1:1.3] [-0.05:3.4] 'wall{0}-before' with lines lc "
      "rgb "
      "'#cccccc', 'wall{0}' with lines lw 1.2 lc rgb '{2}'\n",
      number, found.falls, app::to_hex(app::category(0)));
}

}  // namespace

Comparison dry_walls() {
  Comparison comparison;
  comparison.table =
      "| wall | blocks | E (GPa) | associative | published Coulomb | tilt: stands - falls | against "
      "associative | pushover: stands - falls | against associative |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  app::Figure& figure = comparison.figure;
  figure.height = 330;
  figure.script =
      look + "set size ratio -1\nunset key\nset xtics 0.8\nset ytics 0.7\nset multiplot layout 1,4\n";
  for (const Row& row : rows) {
    const auto found = tilt(row.number, row.young_modulus);
    comparison.table += table_row(row, found);
    add_panel(figure, row.number, found);
  }
  figure.script += "unset multiplot\n";
  comparison.table += "\nWall 1 with a damping ratio of 0.2: " + bracket(tilt(1, 1e8, 0.2)) + ".\n";
  return comparison;
}

}  // namespace dougong::comparisons
