// The differences to the reference with their intervals, a row a metric.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/comparison_figures.h"
#include "app/report/comparison_legend.h"
#include "app/report/comparison_text.h"
#include "app/report/histories.h"

namespace dougong::app {
namespace {

constexpr int width = 880, left = 212, right = 30, top = 62, axis_room = 74;  // px
constexpr double most = 400.0;       // %, where the axis ends at the latest
constexpr double lane = 0.7;         // of a row, shared by the variants
constexpr int full = 7, hollow = 6;  // point types of gnuplot

struct Point {
  double value, low, high;  // % of the reference's mean
  double row;
  std::size_t variant;
  bool different;
};

struct Rows {
  std::vector<std::string> metrics;  // from above
  std::vector<Point> points;
};

Rows rows_of(const Comparison& c, const std::vector<Difference>& differences) {
  Rows rows;
  const std::size_t drawn = drawn_variants(c);
  for (const Difference& d : differences) {
    if (!is_of_the_building(d) || d.variant >= drawn || d.pairs == 0 || !(d.reference_mean > 0.0)) continue;
    auto it = std::ranges::find(rows.metrics, d.metric);
    const auto row = static_cast<double>(it - rows.metrics.begin());
    if (it == rows.metrics.end()) rows.metrics.push_back(d.metric);
    const double percent = 100.0 / d.reference_mean;
    const double place = (static_cast<double>(d.variant) - 0.5 * static_cast<double>(drawn)) /
                         std::max(1.0, static_cast<double>(drawn - 1));
    rows.points.push_back({percent * d.interval.mean, percent * d.interval.low, percent * d.interval.high,
                           row + lane * place, d.variant, d.finding == Finding::different});
  }
  return rows;
}

Range reach_of(const std::vector<Point>& points) {
  std::vector<double> ends{0.0};
  for (const Point& p : points) ends.insert(ends.end(), {p.value, p.low, p.high});
  const Range range = padded(range_of(ends), 0.06, 1.0);
  return {std::max(range.low, -most), std::min(range.high, most)};
}

std::string names_of_rows(const std::vector<std::string>& metrics) {
  std::string list;
  for (std::size_t i = 0; i < metrics.size(); ++i)
    list += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_text(metrics[i]), i);
  return "set ytics (" + list + ")\n";
}

std::string marks(const std::vector<Point>& points, Figure& figure) {
  std::string plot = "plot NaN notitle";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const std::string name = fmt::format("d{}.txt", i), colour = to_hex(variant_colour(p.variant));
    const bool has_interval = std::isfinite(p.low);
    figure.data[name] = fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", p.value, p.row,
                                    has_interval ? p.low : p.value, has_interval ? p.high : p.value);
    plot += fmt::format(
        ", '{0}' using 1:2:3:4 with xerrorbars pt 0 lw 1.6 lc rgb '{1}' notitle"
        ", '{0}' using 1:2 with points pt {2} ps 0.8 lw 1.6 lc rgb '{1}' notitle",
        name, colour, p.different ? full : hollow);
  }
  return plot + "\n";
}

}  // namespace

std::vector<NamedFigure> difference_figure(const Comparison& c, View view,
                                           const std::vector<Difference>& differences) {
  const Rows rows = rows_of(c, of_view(differences, view));
  if (rows.points.empty()) return {};
  const auto count = static_cast<double>(rows.metrics.size());
  const int plot_height =
      static_cast<int>(count * std::max(34.0, 15.0 * static_cast<double>(drawn_variants(c) - 1) + 12.0));
  Figure figure{width, top + plot_height + axis_room + legend_height(c), "", {}};
  const Range reach = reach_of(rows.points);
  figure.script =
      plain_style() +
      heading("Mean difference to the reference, with its interval of 95 %",
              to_string(view) + "; full marks: different; hollow: not distinguishable, or too few runs",
              width, figure.height) +
      legend_labels(c, width, figure.height) +
      margins({left, width - right, top, top + plot_height}, width, figure.height) +
      fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:-0.5]\nset xtics {:.6g}\n", reach.low,
                  reach.high, count - 0.5, round_step(reach.span(), 9)) +
      names_of_rows(rows.metrics) + "unset xzeroaxis\nset yzeroaxis lt 1 lw 1.2 lc rgb '#5a5a5a'\n" +
      "set xlabel 'Mean paired difference over the mean of the reference (%)'\n" + marks(rows.points, figure);
  return {{view == View::same_sa ? "differences_same_sa" : "differences",
           "Mean difference of each metric to the reference with its interval, " + to_string(view) + ".",
           figure}};
}

}  // namespace dougong::app
