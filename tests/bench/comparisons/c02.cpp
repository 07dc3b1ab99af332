// C02: the least thickness of a semicircular arch of 27 voussoirs, by friction.
#include <fmt/format.h>

#include "structures/collapse_multiplier.h"
#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/arches.h"

namespace dougong::comparisons {
namespace {

bool stands(double thickness_ratio, double friction, double young_modulus) {
  const engine::Scene scene = scenes::semicircle_of_27(thickness_ratio, friction, young_modulus).scene();
  engine::State state = engine::initial_state(engine::compile(scene), scene);
  return structures::hold(scene, state).result == structures::TrialResult::stands;
}

struct Bracket {
  double falls, stands;  // t/R
};

/// Bisected to a part of 0.002.
Bracket least_thickness(double friction, double young_modulus, double guess) {
  Bracket b{0.9 * guess, 1.1 * guess};
  while (b.stands - b.falls > 0.002 * guess) {
    const double middle = 0.5 * (b.falls + b.stands);
    (stands(middle, friction, young_modulus) ? b.stands : b.falls) = middle;
  }
  return b;
}

struct Row {
  double friction, published, exact;  // -, t/R
};

constexpr Row rows[] = {{0.31, 0.196, 0.1960},  {0.325, 0.179, 0.1782},  {0.35, 0.152, 0.1512},
                        {0.375, 0.127, 0.1260}, {0.396, 0.107, 0.10672}, {0.6, 0.107, 0.10672}};

}  // namespace

Comparison arch_thickness() {
  Comparison comparison;
  comparison.table =
      "| friction | published t/R | linear programme | falls at (10 GPa) | stands at | middle against the "
      "programme "
      "| middle at 1 GPa |\n|---|---|---|---|---|---|---|\n";
  std::vector<std::vector<double>> curve(3), points(2);
  for (const Row& row : rows) {
    const Bracket stiff = least_thickness(row.friction, 1e10, row.exact);
    const Bracket soft = least_thickness(row.friction, 1e9, row.exact);
    const double middle = 0.5 * (stiff.falls + stiff.stands);
    comparison.table +=
        fmt::format("| {:g} | {:g} | {:.5g} | {:.5f} | {:.5f} | {:+.2f} % | {:+.2f} % |\n", row.friction,
                    row.published, row.exact, stiff.falls, stiff.stands, 100.0 * (middle / row.exact - 1.0),
                    100.0 * (0.5 * (soft.falls + soft.stands) / row.exact - 1.0));
    curve[0].push_back(row.friction), curve[1].push_back(row.published), curve[2].push_back(row.exact);
    points[0].push_back(row.friction), points[1].push_back(middle);
  }
  app::Figure& figure = comparison.figure;
  figure.script =
      look +
      "set xlabel 'friction'\nset ylabel 'least t/R'\nset xrange [0.29:0.62]\nset yrange [0.08:0.22]\n"
      "plot 'curve' using 1:3 with lines lw 4 lc rgb '#cccccc' title 'linear programme', 'curve' "
      "using 1:2 with points pt 4 ps 1.2 lc rgb '#555555' title 'published, read off', 'points' "
      "with points pt 7 ps 0.6 lc rgb '" +
      app::to_hex(app::category(0)) + "' title 'Dougong'\n";
  figure.data["curve"] = columns(curve);
  figure.data["points"] = columns(points);
  return comparison;
}

}  // namespace dougong::comparisons
