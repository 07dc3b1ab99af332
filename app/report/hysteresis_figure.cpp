// The loops of base shear and of overturning moment against roof drift, with the sign of the resistance: the
// ground pushes a building that leans to the right back to the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr int width = 880, height = 430, left = 84, gap = 84, right = 30, top = 70, bottom = 58;  // px
constexpr double seen = 0.0015;  // of the axes' spans: a smaller move is not drawn

struct Loop {
  std::vector<double> x, y;
};

Loop loop_of(const structures::Response& r, const std::vector<double>& force, double unit) {
  Loop loop;
  const std::size_t end = std::min(until_first_loss(r, r.times).size(), force.size());
  for (std::size_t k = 0; k < end; ++k) {
    loop.x.push_back(100.0 * r.roof_displacement[k] / r.height);
    loop.y.push_back(-force[k] / unit);
  }
  return loop;
}

std::string data_of(const Loop& loop, Range x, Range y) {
  std::string out;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < loop.x.size(); ++k) {
    const bool moved = std::abs(loop.x[k] - loop.x[kept]) > seen * x.span() ||
                       std::abs(loop.y[k] - loop.y[kept]) > seen * y.span();
    if (k > 0 && !moved) continue;
    out += fmt::format("{:.6g} {:.6g}\n", loop.x[k], loop.y[k]);
    kept = k;
  }
  return out.empty() ? "0 0\n" : out;
}

std::string panel(const Loop& loop, const std::string& name, const std::string& label, bool second,
                  Figure& figure) {
  const int wide = (width - left - gap - right) / 2, from = second ? left + wide + gap : left;
  const Range x = padded(range_of(loop.x), 0.06, 0.1), y = padded(range_of(loop.y), 0.06, 0.1);
  figure.data[name] = data_of(loop, x, y);
  return margins({from, from + wide, top, height - bottom}, width, height) +
         fmt::format(
             "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:.6g}\nset ytics {:.6g}\n",
             x.low, x.high, y.low, y.high, round_step(x.span(), 6), round_step(y.span(), 6)) +
         fmt::format("set xlabel 'Roof drift, u/H (%)'\nset ylabel {}\n", gnuplot_text(label)) +
         fmt::format("plot '{}' using 1:2 with lines lw 0.9 lc rgb '{}' notitle\n", name,
                     to_hex(category(second ? 2 : 1)));
}

}  // namespace

Figure hysteresis_figure(const RunResult& run) {
  const auto& r = run.response;
  Figure figure{width, height, "", {}};
  const std::string shear = panel(loop_of(r, r.base_shear, r.weight), "shear.txt",
                                  "Resisting shear, −V/W (-)", false, figure),
                    moment = panel(loop_of(r, r.overturning_moment, r.weight * r.height), "moment.txt",
                                   "Resisting moment, −M/WH (-)", true, figure);
  figure.script =
      plain_style() + "set multiplot\n" +
      heading("Base shear and overturning moment against roof drift", run_line(run), width, height) +
      "set xzeroaxis lt 1 lw 0.6 lc rgb '#8a8a8a'\nset yzeroaxis lt 1 lw 0.6 lc rgb '#8a8a8a'\n" + shear +
      "unset label\n" + moment + "unset multiplot\n";
  return figure;
}

}  // namespace dougong::app
