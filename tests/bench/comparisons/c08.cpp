// C08: periods and sway of a seven-storey steel frame, by the number of blocks a member is cut into.
#include <fmt/format.h>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/steel_frame.h"
#include "tests/scenes/steel_frame_response.h"

namespace dougong::comparisons {
namespace {

struct Row {
  const char* what;
  double published;
  std::size_t place;  // in the list of quantities
};
constexpr Row rows[] = {{"T1 (s)", 1.2732, 0},
                        {"T2 (s)", 0.4313, 1},
                        {"T3 (s)", 0.2420, 2},
                        {"T4 (s)", 0.1602, 3},
                        {"T5 (s)", 0.1190, 4},
                        {"T6 (s)", 0.0951, 5},
                        {"T7 (s)", 0.0795, 6},
                        {"roof displacement (in)", 1.45076, 7},
                        {"axial force, left column (kip)", 69.99, 8},
                        {"moment at its foot (kip in)", 2324.68, 9}};

std::vector<double> quantities(int parts) {
  const scenes::SteelFrame frame(parts);
  std::vector<double> out = scenes::periods_of(frame);
  const scenes::Sway sway = scenes::sway_of(frame);
  out.insert(out.end(), {sway.roof, sway.axial, sway.moment});
  return out;
}

}  // namespace

Comparison steel_frame() {
  Comparison comparison;
  std::vector<std::vector<double>> found;
  const int parts[] = {4, 8, 12, 16, 24};
  for (const int n : parts) found.push_back(quantities(n));
  comparison.table =
      "| quantity | published | 4 blocks a member | 8 | 12 | 16 | 24 | at 12 "
      "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    comparison.table += fmt::format("| {} | {:g} |", row.what, row.published);
    for (const auto& column : found) comparison.table += fmt::format(" {:.5g} |", column[row.place]);
    comparison.table += fmt::format(" {:+.2f} % |\n", 100.0 * (found[2][row.place] / row.published - 1.0));
  }
  std::vector<double> blocks, period, roof;
  for (std::size_t k = 0; k < found.size(); ++k) {
    blocks.push_back(parts[k]);
    period.push_back(100.0 * (found[k][0] / rows[0].published - 1.0));
    roof.push_back(100.0 * (found[k][7] / rows[7].published - 1.0));
  }
  comparison.figure.data["error"] = columns({blocks, period, roof});
  comparison.figure.script =
      look +
      "set logscale xy\nset xrange [3:32]\nset yrange [0.1:20]\nset xtics (4,8,12,16,24)\nset xlabel 'blocks "
      "a member'\nset "
      "ylabel 'above the published value (%)'\nplot 'error' using 1:2 with linespoints pt 7 lw 1.4 lc rgb '" +
      app::to_hex(app::category(0)) +
      "' title 'first period', '' using 1:3 with linespoints pt 7 lw 1.4 lc rgb '" +
      app::to_hex(app::category(1)) +
      "' title 'roof displacement', 2.0*(8/x)**2 lc rgb '#999999' dt (4,4) title 'second order'\n";
  return comparison;
}

}  // namespace dougong::comparisons
