// The response spectrum of the input motion.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/report/colour.h"
#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/log_axes.h"
#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

constexpr int width = 660, height = 440, left = 84, right = 84, top = 66, bottom = 56;  // px
constexpr std::size_t longest_name = 56;

double displacement_of(const MotionSheet& m, std::size_t i) {
  const double w = 2.0 * std::numbers::pi / m.spectrum_periods[i];
  return 1e3 * m.spectrum_psa[i] / (w * w);  // mm
}

std::string curve_data(const MotionSheet& m) {
  std::string out;
  for (std::size_t i = 0; i < std::min(m.spectrum_periods.size(), m.spectrum_psa.size()); ++i) {
    if (m.spectrum_periods[i] <= 0 || !(m.spectrum_psa[i] > 0)) continue;
    out +=
        fmt::format("{:.6g} {:.6g}\n", m.spectrum_periods[i], m.spectrum_psa[i] / engine::standard_gravity);
  }
  return out;
}

/// Sd = PSa (T / 2 pi)^2, mm.
std::string displacement_data(const MotionSheet& m) {
  std::string out;
  for (std::size_t i = 0; i < std::min(m.spectrum_periods.size(), m.spectrum_psa.size()); ++i)
    if (m.spectrum_periods[i] > 0 && m.spectrum_psa[i] > 0)
      out += fmt::format("{:.6g} {:.6g}\n", m.spectrum_periods[i], displacement_of(m, i));
  return out;
}

std::string design_data(const MotionSheet& m) {
  std::string out;
  for (std::size_t i = 0; i < m.design_psa.size(); ++i)
    out += fmt::format("{:.6g} {:.6g}\n", m.design_periods[i], m.design_psa[i] / engine::standard_gravity);
  return out;
}

/// What the dashed line is.
std::string design_words(const MotionSheet& m) {
  if (m.design_psa.empty()) return "";
  return fmt::format("set label {} at graph 0.02, graph 0.95 left front tc rgb '{}'\n",
                     gnuplot_text("dashed: " + shortened(m.design_name, longest_name)), to_hex(ink::quiet));
}

std::string curves(const MotionSheet& m) {
  const std::string out = fmt::format(
      "plot 'displacement.txt' axes x1y2 with lines lw 1 lc rgb '{}' notitle, 'spectrum.txt' with lines lw "
      "1.8 lc "
      "rgb '{}' notitle",
      to_hex(category(2)), to_hex(category(0)));
  if (m.design_psa.empty()) return out + "\n";
  return out +
         fmt::format(", 'design.txt' with lines lw 1.4 dt (6,4) lc rgb '{}' notitle\n", to_hex(ink::outline));
}

Range displacement_range(const MotionSheet& m) {
  std::vector<double> values;
  for (std::size_t i = 0; i < m.spectrum_psa.size(); ++i) values.push_back(displacement_of(m, i));
  return log_range(values);
}

Range period_range(const MotionSheet& m) {
  Range r{INFINITY, 0.0};
  for (const double period : m.spectrum_periods) {
    if (period > 0) r = {std::min(r.low, period), std::max(r.high, period)};
  }
  return r.low < r.high ? r : Range{0.01, 10.0};
}

Range psa_range(const MotionSheet& m) {
  std::vector<double> values;
  for (const double psa : m.spectrum_psa) values.push_back(psa / engine::standard_gravity);
  for (const double psa : m.design_psa) values.push_back(psa / engine::standard_gravity);
  return log_range(values);
}

/// A dashed line at the period and a dot where it meets the spectrum.
std::string period_mark(const RunResult& run, Range x, Range y) {
  const double period = run.model.period, psa = run.motion.spectrum_at_period / engine::standard_gravity;
  if (period < x.low || period > x.high) return "";
  const bool right_half = std::log(period / x.low) > 0.62 * std::log(x.high / x.low);
  const std::string colour = to_hex(category_ink(1));
  std::string text = "building, T₁ = " + significant(period, 3) + " s";
  if (psa > 0) text += ": " + significant(psa, 3) + " g";
  std::string out =
      fmt::format("set arrow from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead dt (6,4) lw 1.2 lc rgb '{1}'\n",
                  period, colour);
  out +=
      fmt::format("set label {} at {:.6g}, graph 0.05 {} offset character {},0 front tc rgb '{}'\n",
                  gnuplot_text(text), period, right_half ? "right" : "left", right_half ? -0.8 : 0.8, colour);
  if (psa >= y.low && psa <= y.high) {
    out += fmt::format("set label '' at {:.6g},{:.6g} front point pt 7 ps 0.8 lc rgb '{}'\n", period, psa,
                       colour);
  }
  return out;
}

}  // namespace

Figure spectrum_figure(const RunResult& run) {
  const Range x = period_range(run.motion), y = psa_range(run.motion);
  Figure figure{width,
                height,
                "",
                {{"spectrum.txt", curve_data(run.motion)},
                 {"displacement.txt", displacement_data(run.motion)},
                 {"design.txt", design_data(run.motion)}}};
  const Range d = displacement_range(run.motion);
  figure.script =
      plain_style() + "set logscale xyy2\n" +
      fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / double(width),
                  1.0 - right / double(width)) +
      fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n", 1.0 - top / double(height),
                  bottom / double(height)) +
      fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", x.low, x.high, y.low, y.high) +
      log_tics("x", x) + log_tics("y", y) + log_tics("y2", d) +
      fmt::format(
          "set y2range [{:.6g}:{:.6g}]\nset ytics nomirror\nset y2label 'Displacement, Sd (mm)' tc rgb "
          "'{}'\n",
          d.low, d.high, to_hex(category_ink(2))) +
      heading("Response spectrum of the ground motion, 5 % damping", run.motion.title, width, height) +
      "set xlabel 'Period, T (s)'\nset ylabel 'Pseudo-acceleration, PSa (g)'\n" + period_mark(run, x, y) +
      design_words(run.motion) + curves(run.motion);
  return figure;
}

}  // namespace dougong::app
