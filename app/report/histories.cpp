#include "app/report/histories.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/report/decimate.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr int width = stack_width, left = 84, top = 62, gap = 14, bottom = 60;  // px
constexpr std::size_t bins = 900;        // samples drawn across a panel, twice
constexpr double mark_room = 0.28;       // of the span, where labels of peaks stand
constexpr double character_width = 6.3;  // px, mean of the subtitle's font
constexpr double label_spacing = 15.0;   // px between labels at the ends

std::string data_text(const Curve& curve) {
  const Points points = decimated(curve.x, curve.y, bins);
  std::string out;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const bool fine = std::isfinite(points.x[i]) && std::isfinite(points.y[i]);
    out += fine ? fmt::format("{:.7g} {:.6g}\n", points.x[i], points.y[i]) : "\n";
  }
  return out;
}

Range y_range(const Panel& panel) {
  Range range;
  for (const Curve& curve : panel.curves) range = joined(range, range_of(curve.y));
  for (const Shade& shade : panel.shades)
    range = joined(range, joined(range_of(shade.low), range_of(shade.high)));
  return padded(range, panel.marks.empty() ? 0.08 : mark_room, panel.flat);
}

/// Wanted places (px, ascending order kept) moved so that neighbours keep their distance.
std::vector<double> spread(const std::vector<double>& wanted, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return wanted[a] < wanted[b]; });
  std::vector<double> places = wanted;
  double floor = low;
  for (const std::size_t i : order) {
    places[i] = std::max(places[i], floor);
    floor = places[i] + label_spacing;
  }
  double ceiling = high;
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    places[*it] = std::min(places[*it], ceiling);
    ceiling = places[*it] - label_spacing;
  }
  return places;
}

std::string end_labels(const Panel& panel, Range y) {
  std::vector<const Curve*> labelled;
  std::vector<double> wanted;
  for (const Curve& curve : panel.curves) {
    if (curve.end_label.empty() || curve.y.empty() || !std::isfinite(curve.y.back())) continue;
    labelled.push_back(&curve);
    wanted.push_back((curve.y.back() - y.low) / y.span() * panel.height);
  }
  const std::vector<double> places = spread(wanted, 0.0, panel.height);
  std::string out;
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    out += fmt::format("set label {} at graph 1.008, graph {:.4f} left front tc rgb '{}'\n",
                       gnuplot_text(labelled[i]->end_label), places[i] / panel.height,
                       to_hex(readable(labelled[i]->colour)));
  }
  return out;
}

/// Above a positive peak, below a negative one, leaning away from the nearer edge.
std::string mark_text(const Mark& mark, Range x, const char* symbol_data) {
  const bool right_half = x.span() > 0 && (mark.x - x.low) / x.span() > 0.75;
  const double lift = mark.y < 0 ? -0.85 : 0.85;
  return fmt::format(
      "set label {} at {:.7g},{:.6g} {} offset character {},{} front tc rgb '{}' point pt {} ps {} lc rgb "
      "'{}'\n",
      gnuplot_text(mark.label), mark.x, mark.y, right_half ? "right" : "left", right_half ? -0.6 : 0.6, lift,
      to_hex(mark.colour), symbol_data, mark.cross ? 0.9 : 0.5, to_hex(mark.colour));
}

std::string panel_frame(const Panel& panel, double from_top, int height, Range x, Range y, bool last) {
  const double up = 1.0 - from_top / height, down = 1.0 - (from_top + panel.height) / height;
  std::string out = fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n", up, down);
  out +=
      fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n", x.low, x.high, y.low, y.high);
  out += fmt::format("set xtics {:.9g}\nset ytics {:.9g}\n", round_step(x.span(), 10),
                     round_step(y.span(), panel.height > 110 ? 5 : 4));
  out += last ? "set format x '%g'\n" : "set format x ''\n";
  return out + fmt::format("set ylabel {}\n", gnuplot_text(panel.label));
}

std::string panel_shades(const Panel& panel, std::size_t index, Figure& figure) {
  std::string plot;
  for (std::size_t b = 0; b < panel.shades.size(); ++b) {
    const Shade& shade = panel.shades[b];
    if (shade.x.empty()) continue;
    const std::string name = fmt::format("p{}b{}.txt", index, b);
    for (std::size_t i = 0; i < shade.x.size(); ++i)
      figure.data[name] += fmt::format("{:.7g} {:.6g} {:.6g}\n", shade.x[i], shade.low[i], shade.high[i]);
    plot += fmt::format(", '{}' using 1:2:3 with filledcurves fc rgb '{}' fs solid 1 noborder notitle", name,
                        to_hex(shade.colour));
  }
  return plot;
}

std::string panel_curves(const Panel& panel, std::size_t index, Figure& figure) {
  std::string plot = "plot NaN notitle" + panel_shades(panel, index, figure);
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const std::string name = fmt::format("p{}c{}.txt", index, c);
    const std::string data = data_text(curve);
    if (data.find_first_not_of('\n') == std::string::npos) continue;
    figure.data[name] = data;
    plot += fmt::format(", '{}' using 1:2 with lines lw {} dt {} lc rgb '{}' notitle", name, curve.width,
                        curve.dashed ? "(6,4)" : "1", to_hex(curve.colour));
  }
  return plot + "\n";
}

std::string panel_script(const Stack& stack, std::size_t index, double from_top, Figure& figure) {
  const Panel& panel = stack.panels[index];
  const Range y = y_range(panel);
  std::string out = panel_frame(panel, from_top, figure.height, stack.x, y, index + 1 == stack.panels.size());
  for (const Mark& mark : panel.marks) out += mark_text(mark, stack.x, mark.cross ? "2" : "7");
  out += end_labels(panel, y);
  if (!panel.note.empty()) {
    out += fmt::format("set label {} at graph 0.008, graph 0.88 left front tc rgb '{}'\n",
                       gnuplot_text(panel.note), to_hex(panel.note_colour));
  }
  return out + panel_curves(panel, index, figure) + "unset label\n";
}

}  // namespace

std::pair<double, std::string> energy_unit(double joules) {
  if (joules >= 1e6) return {1e-6, "MJ"};
  if (joules >= 1e3) return {1e-3, "kJ"};
  return {1.0, "J"};
}

std::vector<double> since_start(std::vector<double> values) {
  const double start = values.empty() ? 0.0 : values.front();
  for (double& v : values) v -= start;
  return values;
}

std::vector<double> until_first_loss(const structures::Response& r, std::vector<double> values) {
  for (const structures::StoreyResponse& storey : r.storeys)
    if (storey.lost_at) {
      const auto lost = std::ranges::lower_bound(r.times, *storey.lost_at) - r.times.begin();
      values.resize(std::min(values.size(), static_cast<std::size_t>(lost)));
    }
  return values;
}

std::string plain_style() {
  return "set border 0\nset tics scale 0 nomirror\nset xtics nomirror tc rgb '#222222'\n"
         "set ytics nomirror tc rgb '#222222'\nset grid xtics ytics lt 1 lw 0.7 lc rgb '#e2e2e2'\n"
         "set xzeroaxis lt 1 lw 0.8 lc rgb '#8a8a8a'\nunset key\n";
}

std::string heading(const std::string& title, const std::string& subtitle, int width_px, int height) {
  const auto fits = static_cast<std::size_t>((width_px - 20) / character_width);
  return fmt::format("set label {} at screen 0.0115, screen {:.5f} left font ',15' tc rgb '{}'\n",
                     gnuplot_text(title), 1.0 - 17.0 / height, to_hex(ink::text)) +
         fmt::format("set label {} at screen 0.0115, screen {:.5f} left tc rgb '{}'\n",
                     gnuplot_text(shortened(subtitle, fits)), 1.0 - 37.0 / height, to_hex(ink::quiet));
}

std::string margins(const Frame& f, int sheet_width, int sheet_height) {
  return fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
                     f.left / double(sheet_width), f.right / double(sheet_width)) +
         fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                     1.0 - f.top / double(sheet_height), 1.0 - f.bottom / double(sheet_height));
}

int stack_height(const Stack& stack) {
  double height = top + bottom + gap * static_cast<double>(stack.panels.size() - 1) + stack.room_below;
  for (const Panel& panel : stack.panels) height += panel.height;
  return static_cast<int>(height);
}

Figure stacked(const Stack& asked) {
  Stack stack = asked;
  if (stack.x.span() <= 0.0) stack.x.high = stack.x.low + 1.0;
  Figure figure{width, stack_height(stack), "", {}};
  figure.script = plain_style() + "set multiplot\n" +
                  fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
                              left / double(width), 1.0 - stack.right_margin / double(width)) +
                  heading(stack.title, stack.subtitle, width, figure.height) + stack.labels;
  double from_top = top;
  for (std::size_t i = 0; i < stack.panels.size(); ++i) {
    if (i + 1 == stack.panels.size())
      figure.script += fmt::format("set xlabel {}\n", gnuplot_text(stack.x_label));
    figure.script += panel_script(stack, i, from_top, figure);
    from_top += stack.panels[i].height + gap;
  }
  figure.script += stack.below + "unset multiplot\n";
  return figure;
}

}  // namespace dougong::app
