// Drift profiles of all variants over each other: medians and 16 to 84 % of all runs, at true heights.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/comparison_figures.h"
#include "app/report/comparison_legend.h"
#include "app/report/histories.h"
#include "app/report/levels.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr int width = 640, left = 78, right = 40, top = 74, axis_room = 74, plot_height = 340;  // px

Spread drift_spread(const Comparison& c, View view, std::size_t variant, const std::string& storey) {
  std::vector<double> values;
  for (std::size_t r = 0; r < c.records.size(); ++r)
    if (const ComparedRun* run = c.find(view, variant, r))
      for (const EnsembleMember& member : run->sheet.members)
        values.push_back(100.0 * value_of(run->sheet, member, storey + " peak drift"));
  return spread_of(std::move(values));
}

struct Storey {
  double base, top;  // m
  Spread drift;      // %
};
using Profile = std::vector<Storey>;

std::vector<Profile> profiles_of(const Comparison& c, View view, const std::vector<RunResult>& described) {
  std::vector<Profile> profiles;
  for (std::size_t v = 0; v < std::min(drawn_variants(c), described.size()); ++v) {
    profiles.emplace_back();
    for (const Level& level : levels_of(described[v]))
      profiles.back().push_back({level.base, level.top, drift_spread(c, view, v, level.storey->name)});
  }
  return profiles;
}

std::string staircase(const Profile& profile, double Spread::*value) {
  std::string out;
  for (const Storey& s : profile)
    if (std::isfinite(s.drift.*value))
      out += fmt::format("{0:.6g} {1:.6g}\n{0:.6g} {2:.6g}\n", s.drift.*value, s.base, s.top);
  return out;
}

// Up the lower quantile, down the upper one.
std::string band(const Profile& profile) {
  std::string out = staircase(profile, &Spread::low);
  for (auto s = profile.rbegin(); s != profile.rend(); ++s)
    if (std::isfinite(s->drift.high))
      out += fmt::format("{0:.6g} {1:.6g}\n{0:.6g} {2:.6g}\n", s->drift.high, s->top, s->base);
  return out;
}

struct Extent {
  double drift = 0.0, low = 0.0, high = 0.0;
};

Extent extent_of(const std::vector<Profile>& profiles) {
  Extent e;
  for (const Profile& profile : profiles)
    for (const Storey& s : profile) {
      if (std::isfinite(s.drift.high)) e.drift = std::max(e.drift, s.drift.high);
      e.low = std::min(e.low, s.base), e.high = std::max(e.high, s.top);
    }
  return e;
}

// Above the uppermost storey; one that would meet an earlier one stands a line higher.
std::string letter_labels(const std::vector<Profile>& profiles, double reach) {
  constexpr double too_near = 0.035;  // of the axis
  std::vector<double> lettered;
  std::string out;
  for (std::size_t v = 0; v < profiles.size(); ++v) {
    if (profiles[v].empty() || !std::isfinite(profiles[v].back().drift.median)) continue;
    const Storey& s = profiles[v].back();
    const auto met = std::ranges::count_if(
        lettered, [&](double other) { return std::abs(other - s.drift.median) < too_near * reach; });
    lettered.push_back(s.drift.median);
    out += fmt::format("set label {} at {:.6g},{:.6g} center offset 0,{} front tc rgb '{}'\n",
                       gnuplot_text(letter(v)), s.drift.median, s.top, 0.6 + 0.9 * static_cast<double>(met),
                       to_hex(readable(variant_colour(v))));
  }
  return out;
}

std::string curves(const std::vector<Profile>& profiles, Figure& figure) {
  std::string plot = "plot NaN notitle";
  for (std::size_t v = 0; v < profiles.size(); ++v) {
    const std::string median = staircase(profiles[v], &Spread::median);
    if (median.empty()) continue;
    figure.data[fmt::format("band{}.txt", v)] = band(profiles[v]);
    figure.data[fmt::format("median{}.txt", v)] = median;
    plot += fmt::format(
        ", 'band{0}.txt' with filledcurves closed fc rgb '{1}' fs transparent solid 0.13 noborder notitle, "
        "'median{0}.txt' with lines lw {2} lc rgb '{1}' notitle",
        v, to_hex(variant_colour(v)), v == 0 ? 2.6 : 2.0);
  }
  return plot + "\n";
}

}  // namespace

std::vector<NamedFigure> profile_figure(const Comparison& c, View view,
                                        const std::vector<RunResult>& described) {
  const std::vector<Profile> profiles = profiles_of(c, view, described);
  const Extent extent = extent_of(profiles);
  if (!(extent.drift > 0.0) || profiles.front().empty()) return {};
  Figure figure{width, top + plot_height + axis_room + legend_height(c), "", {}};
  figure.script =
      plain_style() +
      heading("Peak drift of each storey, medians and 16 to 84 %", to_string(view), width, figure.height) +
      legend_labels(c, width, figure.height) +
      margins({left, width - right, top, top + plot_height}, width, figure.height) +
      fmt::format("set xrange [0:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:.6g}\n",
                  1.06 * extent.drift, extent.low, extent.high + 0.04 * (extent.high - extent.low),
                  round_step(1.06 * extent.drift, 7)) +
      "set xlabel 'Peak interstorey drift ratio, |θ| (%)'\nset ylabel 'Height above ground, z (m)'\n";
  figure.script += letter_labels(profiles, 1.06 * extent.drift);
  figure.script += curves(profiles, figure);
  return {{view == View::same_sa ? "drift_profiles_same_sa" : "drift_profiles",
           "Peak drift of each storey of all variants against height, " + to_string(view) + ".", figure}};
}

}  // namespace dougong::app
