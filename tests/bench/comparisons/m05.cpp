// M05: casks that an earthquake moved and did not fell, under the shipped motions at 0.3 g.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/casks.h"

namespace dougong::comparisons {

Comparison casks(const Arguments& arguments) {
  if (arguments.empty())
    throw std::runtime_error("expected the folder of the shipped records behind the folder");
  const std::vector<std::string> records{"wenchuan", "tohoku", "kobe", "chichi", "kocaeli", "elcentro"};
  Comparison comparison;
  comparison.table =
      fmt::format("| friction | {} |\n|---|{}\n", fmt::join(records, " | "), "---|---|---|---|---|---|");
  comparison.figure.script =
      look +
      "set logscale y\nset xrange [0:0.55]\nset yrange [0.01:1000]\nset xlabel 'friction'\n"
      "set ylabel 'farthest from where it stood (mm)'\n"
      "set object rectangle from graph 0, first 25 to graph 1, first 115 behind fc rgb "
      "'#eeeeee' fs solid noborder\nset label 'seen at North Anna' at 0.52,55 right\nplot NaN notitle";
  std::vector<std::string> data(records.size());
  for (const double friction : {0.05, 0.1, 0.2, 0.3, 0.5}) {
    comparison.table += fmt::format("| {} |", friction);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const scenes::CaskMotion motion = scenes::shaken_cask(records[i], "0.3 g", friction, arguments[0]);
      comparison.table +=
          fmt::format(" {:.2f}{} |", 1e3 * motion.farthest,
                      motion.verdict == structures::VerdictKind::survived ? "" : ", not standing");
      data[i] += fmt::format("{} {}\n", friction, 1e3 * motion.farthest);
    }
    comparison.table += "\n";
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    comparison.figure.data[records[i]] = data[i];
    comparison.figure.script += fmt::format(", '{0}' with linespoints pt 7 lw 1.2 lc rgb '{1}' title '{0}'",
                                            records[i], app::to_hex(app::category(i)));
  }
  comparison.figure.script += "\n";
  return comparison;
}

}  // namespace dougong::comparisons
