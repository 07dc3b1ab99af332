// C04: a multi-drum column under a double pulse.
#include <fmt/format.h>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/drum_column.h"

namespace dougong::comparisons {
namespace {

constexpr double g = 9.81;

struct Variant {
  double friction = 0.7, damping_ratio = 0.0, quiet_time = 6.0, step_fraction = 0.25;
};

double least(double duration, const Variant& v = {}) {
  scenes::DrumColumn column;
  column.friction = v.friction, column.damping_ratio = v.damping_ratio;
  // Below the static limit of the base joint, 0.1933 g, nothing can move.
  return scenes::least_collapse(column, duration, 0.19 * g, 8.0 * g, 0.02, v.quiet_time, v.step_fraction) / g;
}

/// What the choices that are ours move, where the column behaves like a monolith and where it does not.
std::string variants() {
  std::string out =
      "| t_p (s) | as above | half the step | watched 12 s | damping ratio 0.1 |\n|---|---|---|---|---|\n";
  for (const double t : {0.35, 0.5})
    out += fmt::format("| {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", t, least(t),
                       least(t, {0.7, 0.0, 6.0, 0.125}), least(t, {0.7, 0.0, 12.0, 0.25}),
                       least(t, {0.7, 0.1, 6.0, 0.25}));
  return out;
}

}  // namespace

Comparison drum_column() {
  Comparison comparison;
  comparison.table =
      "| t_p (s) | UDEC | LMGC90 | HybriDFEM | ours, friction 0.7 | ours, no slip | monolith, exact |\n"
      "|---|---|---|---|---|---|---|\n";
  std::vector<std::vector<double>> published(5), ours(2);
  for (const scenes::DrumColumnRow& row : scenes::drum_column_rows) {
    const double t = row.duration, a = least(t);
    comparison.table += fmt::format("| {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} |\n", t,
                                    row.udec, row.lmgc90, row.hybridfem, a, least(t, {10.0}), row.monolith);
    const double values[] = {t, row.udec, row.lmgc90, row.hybridfem, row.monolith};
    for (std::size_t i = 0; i < 5; ++i) published[i].push_back(values[i]);
    ours[0].push_back(t), ours[1].push_back(a);
  }
  comparison.table += "\n" + variants();
  for (const double t : {0.15, 0.25, 0.32, 0.34, 0.36}) ours[0].push_back(t), ours[1].push_back(least(t));
  app::Figure& figure = comparison.figure;
  figure.script = look +
                  "set logscale y\nset xlabel 't_p (s)'\nset ylabel 'least acceleration for collapse (g)'\n"
                  "set xrange [0.05:0.85]\nset yrange [0.15:10]\n"
                  "plot 'published' using 1:5 with lines dt 2 lc rgb '#888888' title 'monolith', "
                  "'published' using 1:2 with points pt 6 ps 1.2 lc rgb '#555555' title 'UDEC', "
                  "'published' using 1:3 with points pt 8 ps 1.2 lc rgb '#555555' title 'LMGC90', "
                  "'published' using 1:4 with points pt 4 ps 1.2 lc rgb '#555555' title 'HybriDFEM', "
                  "'ours' smooth unique with linespoints pt 7 ps 0.5 lw 1.4 lc rgb '" +
                  app::to_hex(app::category(0)) + "' title 'Dougong'\n";
  figure.data["published"] = columns(published);
  figure.data["ours"] = columns(ours);
  return comparison;
}

}  // namespace dougong::comparisons
