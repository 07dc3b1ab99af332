#include "app/report/record_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/colour.h"
#include "app/report/histories.h"
#include "app/report/log_axes.h"
#include "app/report/text.h"
#include "seismic/constants.h"
#include "seismic/measures/intensity.h"
#include "seismic/measures/peaks.h"

namespace dougong::app {
namespace {

constexpr double g = seismic::standard_gravity;
constexpr int sheet_left = 84, sheet_right = 850, between = 96, spectra_height = 270, spectra_gap = 46;  // px
constexpr int plot_width = 700, plot_height = 470, labels = 150;                                         // px

std::vector<double> times_of(const seismic::GroundHistory& h, double start = 0.0) {
  std::vector<double> times(h.acceleration.size());
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = start + h.interval * static_cast<double>(k);
  return times;
}

std::vector<double> times(const std::vector<double>& values, double factor) {
  std::vector<double> out = values;
  for (double& v : out) v *= factor;
  return out;
}

int decimals_for(double size) {
  return size > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 4) : 1;
}

struct Quantity {
  std::string label, unit;
  const std::vector<double>* values;
  double factor;
};

// One peak, the greatest, with its sign.
Panel history_panel(const std::vector<double>& at, const Quantity& q, Colour colour, double height) {
  Panel panel{q.label, {}, {}, "", ink::quiet, height, 1.0};
  const std::vector<double> values = times(*q.values, q.factor);
  panel.curves.push_back({at, values, colour, 1.0, false, ""});
  const std::size_t i = seismic::peak(values, 1.0).index;
  if (values.empty() || values[i] == 0.0) {
    panel.note = "zero throughout";
    return panel;
  }
  panel.marks.push_back(
      {at[i], values[i],
       signed_fixed(values[i], decimals_for(std::abs(values[i]))) + " " + q.unit + " at " + seconds(at[i]),
       ink::text});
  return panel;
}

std::vector<Quantity> quantities(const seismic::GroundHistory& h, bool dimensionless) {
  if (dimensionless)
    return {{"Acceleration, a/PGA (-)", "PGA", &h.acceleration, 1.0},
            {"Velocity, v/PGA (s)", "s PGA", &h.velocity, 1.0},
            {"Displ., d/PGA (s²)", "s² PGA", &h.displacement, 1.0}};
  return {{"Acceleration, a (g)", "g", &h.acceleration, 1.0 / g},
          {"Velocity, v (m/s)", "m/s", &h.velocity, 1.0},
          {"Displ., d (m)", "m", &h.displacement, 1.0}};
}

Panel husid_panel(const RecordSheet& sheet, const std::vector<double>& at) {
  Panel panel{"Husid curve (%)", {}, {}, "", ink::quiet, 104, 1.0};
  panel.curves.push_back({at,
                          times(seismic::husid(sheet.history.acceleration, sheet.history.interval), 100.0),
                          category(1), 1.4, false, ""});
  if (sheet.rise_end > sheet.rise_start) {
    panel.marks.push_back({sheet.rise_start, 5.0, "", ink::text});
    panel.marks.push_back({sheet.rise_end, 95.0, "", ink::text});
  }
  panel.note = "D₅₋₉₅ = " + seconds(sheet.rise_end - sheet.rise_start);
  if (!sheet.arias.empty()) panel.note += ", Arias intensity " + sheet.arias;
  return panel;
}

std::string curve_text(const SpectrumCurve& curve) {
  std::string out;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.x[i] > 0 && curve.y[i] > 0 && std::isfinite(curve.y[i]))
      out += fmt::format("{:.6g} {:.6g}\n", curve.x[i], curve.y[i]);
  }
  return out;
}

Range x_range(const std::vector<SpectrumCurve>& curves) {
  Range r{INFINITY, 0.0};
  for (const SpectrumCurve& curve : curves)
    for (const double x : curve.x)
      if (x > 0) r = {std::min(r.low, x), std::max(r.high, x)};
  return r.low < r.high ? r : Range{0.01, 10.0};
}

Range y_range(const std::vector<SpectrumCurve>& curves, double decades) {
  std::vector<double> values;
  for (const SpectrumCurve& curve : curves) values.insert(values.end(), curve.y.begin(), curve.y.end());
  return log_range(values, decades);
}

std::string log_frame(Range x, Range y, const std::string& x_label, const std::string& y_label) {
  return "set logscale xy\n" +
         fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", x.low, x.high, y.low,
                     y.high) +
         "set format xy '%g'\n" + log_tics("x", x) + log_tics("y", y) +
         fmt::format("set xlabel {}\nset ylabel {}\n", gnuplot_text(x_label), gnuplot_text(y_label));
}

// A plot of one curve with the place of its top, on the sheet of a record.
std::string small_spectrum(const SpectrumCurve& curve, const Frame& frame, int height,
                           const std::string& x_label, const std::string& y_label, const std::string& unit,
                           const char* file, Colour colour) {
  std::string out = margins(frame, stack_width, height) +
                    log_frame(x_range({curve}), y_range({curve}, 3.0), x_label, y_label);
  const std::size_t top = seismic::peak(curve.y, 1.0).index;
  if (!curve.y.empty() && curve.y[top] > 0)
    out += fmt::format(
        "set label {} at {:.6g},{:.6g} left offset character 0.4,0.7 front tc rgb '{}' point pt 7 ps "
        "0.5 lc rgb '{}'\n",
        gnuplot_text(significant(curve.y[top], 3) + unit + " at " + significant(curve.x[top], 3) +
                     (x_label.find("Hz") == std::string::npos ? " s" : " Hz")),
        curve.x[top], curve.y[top], to_hex(ink::text), to_hex(ink::text));
  return out +
         fmt::format("plot '{}' with lines lw 1.4 lc rgb '{}' notitle\nunset label\n", file, to_hex(colour));
}

}  // namespace

Figure record_figure(const RecordSheet& sheet) {
  const std::vector<double> at = times_of(sheet.history);
  Stack stack{sheet.title, sheet.subtitle, "Time, t (s)", {0.0, at.empty() ? 1.0 : at.back()}, {}, 30};
  for (const Quantity& q : quantities(sheet.history, sheet.dimensionless))
    stack.panels.push_back(history_panel(at, q, category(0), 112));
  stack.panels.push_back(husid_panel(sheet, at));
  stack.room_below = spectra_gap + spectra_height;
  const int height = stack_height(stack), bottom = height - 58, top = bottom - spectra_height + 24;
  const int middle = (sheet_left + sheet_right) / 2;
  const std::string of_peak = sheet.dimensionless ? "/PGA (-)" : " (g)";
  SpectrumCurve psa = sheet.spectrum;
  if (!sheet.dimensionless) psa.y = times(psa.y, 1.0 / g);
  stack.below =
      small_spectrum(psa, {sheet_left, middle - between / 2 + 10, top, bottom}, height, "Period, T (s)",
                     fmt::format("PSa, {:g} %", 100.0 * sheet.damping_ratio) + of_peak,
                     sheet.dimensionless ? "" : " g", "psa.txt", category(0)) +
      small_spectrum(sheet.fourier, {middle + between / 2 + 10, sheet_right, top, bottom}, height,
                     "Frequency, f (Hz)",
                     sheet.dimensionless ? "Fourier amplitude, |A|/PGA (s)" : "Fourier amplitude, |A| (m/s)",
                     sheet.dimensionless ? " s" : " m/s", "fourier.txt", category(2));
  Figure figure = stacked(stack);
  figure.data["psa.txt"] = curve_text(psa);
  figure.data["fourier.txt"] = curve_text(sheet.fourier);
  return figure;
}

Figure conditioning_figure(const BeforeAfter& m) {
  const std::vector<double> before = times_of(m.before), after = times_of(m.after, -m.lead);
  Stack stack{m.title,
              m.subtitle,
              "Time since the record's first sample, t (s)",
              {std::min(0.0, -m.lead), std::max(before.back(), after.back())},
              {},
              96};
  const auto old = quantities(m.before, false), now = quantities(m.after, false);
  for (std::size_t i = 0; i < now.size(); ++i) {
    Panel panel = history_panel(after, now[i], category(0), 130);
    panel.curves.insert(panel.curves.begin(),
                        {before, times(*old[i].values, old[i].factor), ink::pale, 1.0, false, "as read"});
    panel.curves.back().end_label = "conditioned";
    stack.panels.push_back(std::move(panel));
  }
  return stacked(stack);
}

Figure spectra_figure(const std::string& title, const std::string& subtitle,
                      const std::vector<SpectrumCurve>& asked, double band_from, double band_to) {
  std::vector<SpectrumCurve> curves = asked;
  for (SpectrumCurve& curve : curves) curve.y = times(curve.y, 1.0 / g);
  const Range x = x_range(curves), y = y_range(curves, 3.0);
  Figure figure{plot_width, plot_height, "", {}};
  figure.script = plain_style() +
                  margins({84, plot_width - labels, 66, plot_height - 56}, plot_width, plot_height) +
                  heading(title, subtitle, plot_width, plot_height) +
                  log_frame(x, y, "Period, T (s)", "Pseudo-acceleration, PSa (g)");
  if (band_to > band_from)
    figure.script += fmt::format(
        "set object rectangle from {:.6g}, graph 0 to {:.6g}, graph 1 behind fc rgb '#f1f1f1' fs noborder\n",
        band_from, band_to);
  std::string plot = "plot NaN notitle";
  std::size_t shown = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const SpectrumCurve& c = curves[i];
    const std::string name = fmt::format("s{}.txt", i);
    figure.data[name] = curve_text(c);
    if (figure.data[name].empty()) continue;
    const Colour colour = c.target ? ink::black : c.faint ? ink::pale : category(shown);
    plot += fmt::format(", '{}' with lines lw {} dt {} lc rgb '{}' notitle", name, c.faint ? 0.8 : 1.7,
                        c.target ? "(6,4)" : "1", to_hex(colour));
    if (!c.label.empty()) {
      figure.script +=
          fmt::format("set label {} at graph 1.02, graph {:.4f} left front tc rgb '{}'\n",
                      gnuplot_text(shortened(c.label, 22)), 0.97 - 0.055 * static_cast<double>(shown),
                      to_hex(c.target ? ink::text : readable(colour)));
    }
    if (!c.label.empty() || (!c.target && !c.faint)) ++shown;
  }
  figure.script += plot + "\n";
  return figure;
}

}  // namespace dougong::app
