// C09: stick-slip of a block under a sinusoidal force.
#include <fmt/format.h>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/stick_slip.h"

namespace dougong::comparisons {
namespace {

std::string table(const scenes::StickSlipHistory& h, const oracles::HarmonicSlider& exact) {
  std::string out =
      "| slip | starts (s) | ours | stops (s) | ours | then at (mm) | ours | peak speed (mm/s) | ours |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < h.slips.size(); ++i) {
    const oracles::Slip& e = exact.slips()[i];
    const scenes::MeasuredSlip& m = h.slips[i];
    out += fmt::format("| {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.5f} | {:.5f} | {:.4f} | {:.4f} |\n",
                       i + 1, e.start, m.start, e.end, m.end, 1e3 * exact.displacement(e.end), 1e3 * m.to,
                       1e3 * exact.peak_speed(e), 1e3 * m.peak_speed);
  }
  return out;
}

}  // namespace

Comparison stick_slip() {
  const scenes::StickSlip c{1.0, 0.8, 8.0, 1.0};
  const oracles::HarmonicSlider exact = c.exact();
  const scenes::StickSlipHistory h = scenes::measured(c);
  std::vector<double> times, reference;
  for (double t = 0.0; t <= c.until; t += 0.02)
    times.push_back(t), reference.push_back(exact.displacement(t));
  app::Figure figure;
  figure.script = look +
                  "set xlabel 'time (s)'\nset ylabel 'displacement (mm)'\n"
                  "plot 'exact' using 1:($2*1e3) with lines lw 5 lc rgb '#cccccc' title 'closed form', "
                  "'ours' using 1:($2*1e3) with lines lw 1.2 lc rgb '" +
                  app::to_hex(app::category(0)) + "' title 'Dougong'\n";
  figure.data["exact"] = columns({times, reference});
  figure.data["ours"] = columns({h.times, h.places}, 200);
  return {table(h, exact), figure};
}

}  // namespace dougong::comparisons
