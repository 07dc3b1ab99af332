// Error against cost, log-log.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/colour.h"
#include "app/report/histories.h"
#include "app/report/text.h"
#include "app/report/tradeoff_report.h"

namespace dougong::app {
namespace {

constexpr int width = 900, height = 560, left = 84, right = 226, top = 66, bottom = 58;  // px
constexpr double plot_width = width - left - right, plot_height = height - top - bottom;
constexpr double failure_room = 0.09;  // of the height: the strip of crosses
constexpr double line_height = 17.0;   // px, of the legend
constexpr double least_error = 1e-16;  // of doubles: what is nearer lies on the axis

// Gray and brown continue Okabe and Ito's seven.
Colour colour_of(const std::string& integrator) {
  const std::vector<std::string> names = integrator_choices();
  const auto i = static_cast<std::size_t>(std::ranges::find(names, integrator) - names.begin()) - 1;
  constexpr std::size_t in_palette = 7;
  if (i < in_palette) return category(i);
  return from_hex(i == in_palette ? "#8c8c8c" : "#7f4a12");
}

// Point types of gnuplot: discs as described, triangles down for softer, up for stiffer, squares for rigid.
int mark_of(double stiffness) {
  constexpr int disc = 7, down = 11, up = 9, square = 5;
  if (stiffness == rigid) return square;
  return stiffness == 1.0 ? disc : stiffness < 1.0 ? down : up;
}
constexpr int cross = 2, ring = 6, filled_square = 5;

// --- axes --------------------------------------------------------------------------------------------

struct Axes {
  Range x, y;           // decimal logarithms; y without the strip of failures
  double y_top = 0.0;   // logarithm, with the strip
  double failed = 0.0;  // where the crosses are; no logarithm
};

/// Whole decades with some room above.
Range decades(Range logs) {
  constexpr double room = 0.3;
  return {std::floor(logs.low), std::ceil(logs.high + room)};
}

Range log_range(const std::vector<double>& values, Range otherwise) {
  std::vector<double> logs;
  for (const double v : values)
    if (std::isfinite(v) && v > 0.0) logs.push_back(std::log10(std::max(v, least_error)));
  return logs.empty() ? otherwise : range_of(logs);
}

Axes axes_of(const Tradeoff& t) {
  std::vector<double> costs, errors{t.resolution(), t.choice.target};
  for (const JudgedTrial& trial : t.trials) {
    costs.push_back(trial.cpu_per_second());
    if (trial.completed()) errors.push_back(trial.error);
  }
  if (t.chaotic()) errors.push_back(t.spread());
  Axes a;
  a.x = log_range(costs, {-3.0, 0.0});
  a.x = {a.x.low - 0.12 - 0.04 * a.x.span(), a.x.high + 0.12 + 0.04 * a.x.span()};
  a.y = decades(log_range(errors, {-3.0, 0.0}));
  a.y_top = a.y.high + failure_room / (1.0 - failure_room) * a.y.span();
  a.failed = std::pow(10.0, 0.5 * (a.y.high + a.y_top));
  return a;
}

std::string raised(int exponent) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}
/// 1, 2 or 5 times a power of ten.
std::string tic_text(double factor, int exponent) {
  const double value = factor * std::pow(10.0, exponent);
  if (exponent >= -3 && exponent <= 3) return fmt::format("{:g}", value);
  return (factor == 1.0 ? "" : fmt::format("{:g} × ", factor)) + "10" + raised(exponent);
}

/// Decades, thinned when there are many; with 2 and 5 when there are few.
std::string tics(const char* axis, Range logs, bool may_be_fine) {
  const bool fine = may_be_fine && logs.span() < 2.5;
  const int stride = logs.span() > 9.0 ? 2 : 1;
  std::string list;
  for (int e = static_cast<int>(std::floor(logs.low)); e <= logs.high; ++e)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, e), at = std::log10(value);
      const bool inside = at > logs.low - 1e-9 && at < logs.high + 1e-9;
      if (!inside || e % stride != 0 || (factor != 1.0 && !fine)) continue;
      list += fmt::format("{}'{}' {:.9g}", list.empty() ? "" : ", ", tic_text(factor, e), value);
    }
  return fmt::format("set {}tics ({})\n", axis, list);
}

std::string frame(const Axes& a) {
  return plain_style() + "set logscale xy\n" +
         fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / double(width),
                     1.0 - right / double(width)) +
         fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                     1.0 - top / double(height), bottom / double(height)) +
         fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", std::pow(10.0, a.x.low),
                     std::pow(10.0, a.x.high), std::pow(10.0, a.y.low), std::pow(10.0, a.y_top)) +
         tics("x", a.x, true) + tics("y", a.y, false) +
         "set xlabel 'Processor time per simulated second, c (s/s)'\n"
         "set ylabel 'Error of the motion, ε (-)' offset -0.5,0\n";
}

// --- bands and lines ---------------------------------------------------------------------------------

double on_axis(const Axes& a, double error) {
  return std::pow(10.0, std::clamp(std::log10(std::max(error, least_error)), a.y.low, a.y.high));
}

constexpr const char *spread_fill = "#fbe3b0", *unresolved_fill = "#e4e4e4";

/// From the bottom to an error.
std::string band(const Axes& a, double error, const char* fill, int tag) {
  return fmt::format(
      "set object {} rectangle from graph 0, first {:.6g} to graph 1, first {:.6g} behind fc rgb '{}' fs "
      "solid noborder\n",
      tag, std::pow(10.0, a.y.low), on_axis(a, error), fill);
}

std::string bands(const Tradeoff& t, const Axes& a) {
  const std::string unresolved = band(a, t.resolution(), unresolved_fill, 2);
  return t.chaotic() ? band(a, t.spread(), spread_fill, 1) + unresolved : unresolved;
}

std::string strip(const Tradeoff& t, const Axes& a) {
  const bool needed = std::ranges::any_of(t.trials, [](const auto& trial) { return !trial.completed(); });
  if (!needed) return "";
  return fmt::format(
             "set object 3 rectangle from graph 0, first {:.6g} to graph 1, graph 1 behind fc rgb '#fbe9e7' "
             "fs solid noborder\n",
             std::pow(10.0, a.y.high)) +
         fmt::format("set label 'failed' at graph -0.012, first {:.6g} right front tc rgb '{}'\n", a.failed,
                     to_hex(ink::lost));
}

std::string level(double error, const char* dashes, const Colour& colour) {
  return fmt::format(
      "set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead dt {1} lw 1 lc rgb '{2}'\n",
      error, dashes, to_hex(colour));
}

constexpr const char *dashed = "(6,4)", *dotted = "(1.5,3)";

std::string levels(const Tradeoff& t, const Axes& a) {
  std::string out = level(t.choice.target, dashed, ink::quiet);
  for (const TradeoffModel& model : t.models)
    if (model.error > 0.0) out += level(on_axis(a, model.error), dotted, ink::pale);
  return out;
}

// --- runs --------------------------------------------------------------------------------------------

/// Runs of one integrator and stiffness.
struct Series {
  Way way;
  std::string completed, failed, not_run;  // lines of data
};

std::vector<Series> series_of(const Tradeoff& t, const Axes& a) {
  std::vector<Series> all;
  for (const JudgedTrial& trial : t.trials) {
    auto it = std::ranges::find_if(all, [&](const Series& s) { return s.way.is_of_series(trial.way); });
    if (it == all.end()) it = all.insert(all.end(), {trial.way, "", "", ""});
    const double cost = std::max(trial.cpu_per_second(), std::pow(10.0, a.x.low + 0.02 * a.x.span()));
    std::string& lines = trial.completed()                      ? it->completed
                         : trial.status == TrialStatus::not_run ? it->not_run
                                                                : it->failed;
    lines += fmt::format("{:.6g} {:.6g}\n", cost, trial.completed() ? on_axis(a, trial.error) : a.failed);
  }
  return all;
}

std::string plotted(const std::vector<Series>& all, Figure& figure) {
  std::string plot = "plot NaN notitle";
  const auto add = [&](const std::string& name, const std::string& data, const std::string& style) {
    if (data.empty()) return;
    figure.data[name] = data;
    plot += fmt::format(", '{}' with {} notitle", name, style);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Series& s = all[i];
    const std::string colour = to_hex(colour_of(s.way.solve.integrator));
    const bool own = s.way.stiffness == 1.0;
    add(fmt::format("s{}.txt", i), s.completed,
        fmt::format("linespoints lw {} pt {} ps {} lc rgb '{}'", own ? 1.8 : 0.8, mark_of(s.way.stiffness),
                    own ? 0.75 : 0.7, colour));
    add(fmt::format("f{}.txt", i), s.failed,
        fmt::format("points lw 1.6 pt {} ps 0.9 lc rgb '{}'", cross, colour));
    add(fmt::format("n{}.txt", i), s.not_run,
        fmt::format("points lw 1.2 pt {} ps 0.9 lc rgb '{}'", ring, colour));
  }
  return plot + "\n";
}

std::string circled(const JudgedTrial& trial, const Axes& a, const Colour& colour) {
  if (!trial.completed()) return "";
  return fmt::format("set label '' at {:.6g},{:.6g} front point pt {} ps 2 lw 1.6 lc rgb '{}'\n",
                     trial.cpu_per_second(), on_axis(a, trial.error), ring, to_hex(colour));
}

constexpr Colour own_ring = ink::outline, best_ring{0.83, 0.0, 0.0};

std::string circles(const Tradeoff& t, const Axes& a) {
  const auto best = t.recommended();
  const std::string own = circled(t.trials[t.own], a, own_ring);
  return best ? own + circled(t.trials[*best], a, best_ring) : own;
}

// --- legend ------------------------------------------------------------------------------------------

class Legend {
 public:
  void line(const std::string& text, int mark, const Colour& colour) {
    const double y = 1.0 - at_ / height;
    out_ += fmt::format("set label '' at screen {:.5f}, screen {:.5f} point pt {} ps 0.8 lc rgb '{}' front\n",
                        x(10.0), y, mark, to_hex(colour));
    words(text, 22.0, ink::text);
  }
  void dash(const std::string& text, const char* dashes, const Colour& colour) {
    const double y = 1.0 - at_ / height;
    out_ += fmt::format(
        "set arrow from screen {:.5f}, screen {:.5f} to screen {:.5f}, screen {:.5f} nohead dt {} lw 1 lc "
        "rgb "
        "'{}'\n",
        x(3.0), y, x(17.0), y, dashes, to_hex(colour));
    words(text, 22.0, ink::text);
  }
  void heading(const std::string& text) {
    at_ += at_ > top + 8.0 ? 0.6 * line_height : 0.0;
    words(text, 4.0, ink::quiet);
  }
  void words(const std::string& text, double indent, const Colour& colour) {
    out_ += fmt::format("set label {} at screen {:.5f}, screen {:.5f} left front tc rgb '{}'\n",
                        gnuplot_text(text), x(indent), 1.0 - at_ / height, to_hex(colour));
    at_ += line_height;
  }
  const std::string& script() const { return out_; }

 private:
  static double x(double indent) { return (left + plot_width + 14.0 + indent) / width; }
  std::string out_;
  double at_ = top + 8.0;  // px from the top
};

std::vector<std::string> integrators_of(const Tradeoff& t) {
  std::vector<std::string> names;
  for (const JudgedTrial& trial : t.trials)
    if (std::ranges::find(names, trial.way.solve.integrator) == names.end())
      names.push_back(trial.way.solve.integrator);
  return names;
}

std::vector<TradeoffModel> softest_first(std::vector<TradeoffModel> models) {
  std::ranges::sort(models, {}, &TradeoffModel::stiffness);
  return models;
}

void add_models(Legend& legend, const Tradeoff& t) {
  if (t.models.size() < 2) return;
  legend.heading("Contacts; error of the model");
  for (const TradeoffModel& model : softest_first(t.models)) {
    const std::string error = "; " + significant(100.0 * model.error, 2) + " % (dotted)";
    legend.line(stiffness_text(model.stiffness) + (model.stiffness == 1.0 ? "" : error),
                mark_of(model.stiffness), ink::quiet);
  }
}

void add_choice(Legend& legend, const Tradeoff& t) {
  legend.heading("Which to take");
  legend.dash("target " + significant(100.0 * t.choice.target, 2) + " %", dashed, ink::quiet);
  if (t.recommended()) legend.line("recommended", ring, best_ring);
  legend.line("as the scene stands", ring, own_ring);
}

void add_bands(Legend& legend, const Tradeoff& t) {
  legend.heading("Errors that are not told apart");
  if (t.chaotic())
    legend.line(fmt::format("spread of {} runs begun alike", t.ensemble.differences.size()), filled_square,
                from_hex(spread_fill));
  legend.line("below the reference's own", filled_square, from_hex(unresolved_fill));
}

void add_failures(Legend& legend, const Tradeoff& t) {
  const auto count = [&](TrialStatus status) {
    return std::ranges::count(t.trials, status, &JudgedTrial::status);
  };
  const auto dear = count(TrialStatus::not_run),
             failed = count(TrialStatus::failed) + count(TrialStatus::refused);
  if (dear + failed == 0) return;
  legend.heading("No answer");
  if (failed > 0) legend.line("refused or failed", cross, ink::quiet);
  if (dear > 0) legend.line("too dear, not finished", ring, ink::quiet);
}

std::string legend(const Tradeoff& t) {
  Legend legend;
  legend.heading("Integrator");
  for (const std::string& name : integrators_of(t)) legend.line(name, mark_of(1.0), colour_of(name));
  add_models(legend, t);
  add_choice(legend, t);
  add_bands(legend, t);
  add_failures(legend, t);
  return legend.script();
}

std::string subtitle(const Tradeoff& t) {
  const Trial& reference = t.models.front().reference;
  return fmt::format("{} s simulated; {} distance from {} ({}), over its largest motion, {}",
                     significant(t.duration, 3), to_string(t.choice.measure), reference.way.solve.integrator,
                     control_text(reference.way), length(t.motion));
}

}  // namespace

Figure tradeoff_figure(const Tradeoff& tradeoff) {
  const Axes axes = axes_of(tradeoff);
  Figure figure{width, height, "", {}};
  const std::vector<Series> series = series_of(tradeoff, axes);
  const std::string title = tradeoff.title.empty() ? "a scene" : tradeoff.title;
  figure.script = frame(axes) + heading("Error against cost: " + title, subtitle(tradeoff), width, height) +
                  bands(tradeoff, axes) + strip(tradeoff, axes) + levels(tradeoff, axes) +
                  circles(tradeoff, axes) + legend(tradeoff);
  figure.script += plotted(series, figure);
  return figure;
}

}  // namespace dougong::app
