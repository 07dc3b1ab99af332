// Over the height of the building: peak drift of both signs with the limits of standards, residual and shear
// drift, peak floor acceleration of both signs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/report/axis.h"
#include "app/report/colour.h"
#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/levels.h"
#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::CodeCheck;
using structures::Envelope;
using structures::StoreyResponse;

constexpr int width = 880, left = 78, gap = 62, right = 24, top = 96, bottom = 58;  // px
constexpr double apart = 0.12;  // of a limit: nearer ones cannot be told apart
constexpr std::size_t longest_label = 30;
constexpr double least_reach = 1e-6;  // of an axis

struct ProfileLine {
  std::string name, label;
  Colour colour;
  std::function<double(const StoreyResponse&)> value;
  bool dashed = false;
};

struct Profile {
  std::string title;
  std::vector<ProfileLine> curves;
  bool steps = true;  // a value a storey; else a value a floor
  std::vector<const CodeCheck*> limits = {};
};

/// Of every standard the peak drift limit that is nearest to what was found; of limits that would lie on each
/// other the first.
std::vector<const CodeCheck*> nearest_limits(const ScreeningSheet& screening) {
  std::vector<const CodeCheck*> limits;
  for (const CodeCheck& check : screening.checks)
    if (check.measure == "peak drift" && check.found > 0.0) limits.push_back(&check);
  std::ranges::stable_sort(limits, {},
                           [](const CodeCheck* c) { return std::abs(std::log(c->limit / c->found)); });
  std::vector<const CodeCheck*> kept;
  for (const CodeCheck* check : limits)
    if (std::ranges::none_of(kept, [&](const CodeCheck* k) {
          return k->standard == check->standard || std::abs(k->limit - check->limit) < apart * check->limit;
        }))
      kept.push_back(check);
  return kept;
}

std::vector<Profile> profiles_of(const RunResult& run) {
  constexpr double g = engine::standard_gravity;
  const auto of = [](Envelope StoreyResponse::*peaks, bool positive, double factor) {
    return [=](const StoreyResponse& s) {
      return factor * (positive ? (s.*peaks).positive.value : (s.*peaks).negative.value);
    };
  };
  return {{"Peak drift, θ (%)",
           {{"drift_positive.txt", "to +x", category(0), of(&StoreyResponse::peak_drift, true, 100.0)},
            {"drift_negative.txt", "to −x", category(1), of(&StoreyResponse::peak_drift, false, 100.0)}},
           true,
           nearest_limits(run.screening)},
          {"Residual and shear drift (%)",
           {{"residual.txt", "residual", category(2),
             [](const StoreyResponse& s) { return 100.0 * s.residual_drift; }},
            {"sheared.txt", "peak, base rotation removed", category(3),
             [](const StoreyResponse& s) { return 100.0 * s.peak_shear_drift.largest().value; }, true}}},
          {"Peak floor acceleration (g)",
           {{"acceleration_positive.txt", "to +x", category(0),
             of(&StoreyResponse::peak_acceleration, true, 1.0 / g)},
            {"acceleration_negative.txt", "to −x", category(1),
             of(&StoreyResponse::peak_acceleration, false, 1.0 / g)}},
           false}};
}

std::string data_of(const ProfileLine& curve, const std::vector<Level>& levels, bool steps) {
  std::string out;
  for (const Level& l : levels) {
    const double x = curve.value(*l.storey);
    if (steps) out += fmt::format("{:.6g} {:.6g}\n", x, l.base);
    out += fmt::format("{:.6g} {:.6g}\n", x, l.top);
  }
  return out;
}

/// The largest value of a panel, and of the limits that are no farther than twice as large.
double reach_of(const Profile& profile, const std::vector<Level>& levels) {
  double reach = least_reach;
  for (const ProfileLine& curve : profile.curves)
    for (const Level& l : levels) reach = std::max(reach, std::abs(curve.value(*l.storey)));
  const double size = reach;
  for (const CodeCheck* check : profile.limits)
    if (100.0 * check->limit <= 2.0 * size) reach = std::max(reach, 100.0 * check->limit);
  return 1.15 * reach;
}

std::string limit_lines(const Profile& profile, double reach) {
  std::string out;
  for (const CodeCheck* check : profile.limits) {
    const double x = 100.0 * check->limit;
    if (x > reach) continue;
    for (const double side : {-x, x})
      out += fmt::format(
          "set arrow from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead dt (5,4) lw 1 lc rgb '{1}' back\n",
          side, to_hex(ink::quiet));
    out += fmt::format(
        "set label {} at {:.6g}, graph 0.02 left rotate by 90 offset character -0.7,0 front tc rgb "
        "'{}' font ',9'\n",
        gnuplot_text(shortened(check->standard + ", " + check->limit_name, longest_label)), x,
        to_hex(ink::quiet));
  }
  return out;
}

/// One plot of the three, from there on so wide (px).
std::string panel_of(const Profile& profile, const std::vector<Level>& levels, int from, int wide,
                     Figure& figure) {
  const double reach = reach_of(profile, levels);
  std::string out = margins({from, from + wide, top, figure.height - bottom}, width, figure.height) +
                    fmt::format("set xrange [{:.6g}:{:.6g}]\nset xtics {:.6g}\nset xlabel {}\n", -reach,
                                reach, round_step(2 * reach, 6), gnuplot_text(profile.title)) +
                    limit_lines(profile, reach);
  std::string plots = "plot NaN notitle";
  double line = 0.0;
  for (const ProfileLine& curve : profile.curves) {
    figure.data[curve.name] = data_of(curve, levels, profile.steps);
    plots += fmt::format(", '{}' with {} lw 2 {} lc rgb '{}' notitle", curve.name,
                         profile.steps ? "lines" : "linespoints pt 7 ps 0.5", curve.dashed ? "dt (6,3)" : "",
                         to_hex(curve.colour));
    out += fmt::format("set label {} at screen {:.5f},{:.5f} left tc rgb '{}'\n", gnuplot_text(curve.label),
                       from / double(width), 1.0 - (top - 26.0 + 16.0 * line++) / figure.height,
                       to_hex(readable(curve.colour)));
  }
  return out + plots + "\nunset label\nunset arrow\nset ylabel ''\nset format y ''\n";
}

}  // namespace

Figure floor_profiles_figure(const RunResult& run) {
  const std::vector<Level> levels = levels_of(run);
  const int plot_height =
      static_cast<int>(std::clamp(60.0 * static_cast<double>(levels.size()), 200.0, 420.0));
  Figure figure{width, top + bottom + plot_height, "", {}};
  const int wide = (width - left - 2 * gap - right) / 3;
  std::string panels;
  int from = left;
  for (const Profile& profile : profiles_of(run)) {
    panels += panel_of(profile, levels, from, wide, figure);
    from += wide + gap;
  }
  figure.script = plain_style() + "set multiplot\n" +
                  heading("Over the height of the building", run_line(run), width, figure.height) +
                  fmt::format("set yrange [{:.6g}:{:.6g}]\n", levels.front().base, levels.back().top) +
                  "set yzeroaxis lt 1 lw 0.8 lc rgb '#8a8a8a'\nset ylabel 'Height above ground, z (m)'\n" +
                  panels + "unset multiplot\n";
  return figure;
}

}  // namespace dougong::app
