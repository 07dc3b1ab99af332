// The runs of an ensemble over time, and what of their spread is the step's: when the bar of half the step is
// short beside that of the spread, more accuracy buys nothing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/spread_text.h"

namespace dougong::app {
namespace {

using structures::VerdictKind;

constexpr std::size_t least_runs = 3;               // that a band is drawn of
constexpr int strip_height = 118, strip_axis = 54;  // px
constexpr int right = 112;                          // px, room for labels
constexpr int full = 7, hollow = 6, cross = 2;      // point types of gnuplot

bool holds(const EnsembleMember& member) {
  return member.done && member.verdict != VerdictKind::numerically_invalid && !member.values.empty();
}

/// By the runs of which no storey is lost yet; all have the same output times.
Shade band_of(const std::vector<EnsembleMember>& members, const std::vector<double>& times) {
  Shade band{{}, {}, {}, mixed(category(0), ink::white, 0.78)};
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<double> values;
    for (const EnsembleMember& member : members)
      if (holds(member) && k < member.roof_drift.size()) values.push_back(100.0 * member.roof_drift[k]);
    if (values.size() < least_runs) break;
    const Spread spread = spread_of(std::move(values));
    band.x.push_back(times[k]), band.low.push_back(spread.low), band.high.push_back(spread.high);
  }
  return band;
}

Curve curve_of(const EnsembleMember& member, Colour colour, double width, const std::string& label) {
  Curve curve{member.roof_times, member.roof_drift, colour, width, false, label};
  for (double& value : curve.y) value *= 100.0;
  return curve;
}

void add_run(Panel& panel, const EnsembleMember& member, Curve curve) {
  if (member.verdict == VerdictKind::collapsed && !curve.x.empty())
    panel.marks.push_back({curve.x.back(), curve.y.back(), "", ink::lost, true});
  panel.curves.push_back(std::move(curve));
}

const std::vector<double>& longest_times(const EnsembleSheet& e) {
  const auto length = [](const EnsembleMember& member) { return member.roof_times.size(); };
  return std::ranges::max_element(e.members, {}, length)->roof_times;
}

Panel histories_panel(const EnsembleSheet& e) {
  Panel panel{
      "Roof drift, u/H (%)", {}, {}, "band: 16 to 84 % of the runs that stand then", ink::quiet, 240, 0.1};
  panel.shades.push_back(band_of(e.members, longest_times(e)));
  for (std::size_t i = 1; i < e.members.size(); ++i)
    if (holds(e.members[i]))
      add_run(panel, e.members[i], curve_of(e.members[i], mixed(category(0), ink::white, 0.45), 0.6, ""));
  if (holds(e.half_step))
    add_run(panel, e.half_step, curve_of(e.half_step, category(1), 1.1, "half the step"));
  add_run(panel, e.members.front(), curve_of(e.members.front(), ink::black, 1.6, "as described"));
  return panel;
}

int mark_of(VerdictKind kind) {
  return kind == VerdictKind::collapsed ? cross : kind == VerdictKind::survived ? full : hollow;
}
Colour colour_of(VerdictKind kind) {
  return kind == VerdictKind::collapsed  ? ink::lost
         : kind == VerdictKind::survived ? category(0)
                                         : ink::quiet;
}

/// Peak drifts in percent; rows from above: every run at 3, the spread at 2, the step at 1.
class Strip {
 public:
  Strip(const EnsembleSheet& e, Figure& figure) : e_(e), figure_(figure) {}

  std::string script(Range x) {
    plot_ = "plot NaN notitle";
    for (const VerdictKind kind : {VerdictKind::survived, VerdictKind::undecided, VerdictKind::collapsed})
      add_runs(kind);
    add_spread();
    add_step();
    return fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [0.4:3.6]\nset xtics {:.6g}\n", x.low, x.high,
                       round_step(x.span(), 9)) +
           "set format x '%g'\nset ylabel ''\nunset xzeroaxis\nset ytics ('each run' 3, '16 to 84 %%' 2" +
           (holds(e_.half_step) ? ", 'half step' 1)\n" : ")\n") +
           "set xlabel 'Greatest interstorey drift before any loss, |θ| (%)'\n" + labels_ + plot_ + "\n";
  }

 private:
  void add_runs(VerdictKind kind) {
    std::string data;
    for (std::size_t i = 0; i < e_.members.size(); ++i)
      if (holds(e_.members[i]) && e_.members[i].verdict == kind)
        data += fmt::format("{:.6g} {:.4g}\n", percent(e_.members[i]), height_of(i));
    if (data.empty()) return;
    const std::string name = fmt::format("runs{}.txt", shown_), colour = to_hex(colour_of(kind));
    figure_.data[name] = data;
    plot_ += fmt::format(", '{}' using 1:2 with points pt {} ps 0.7 lw 1.4 lc rgb '{}' notitle", name,
                         mark_of(kind), colour);
    const double place = 0.95 - 0.17 * shown_++;
    labels_ += fmt::format(
        "set label '{}' at graph 1.02, graph {:.2f} left offset character 0.8,0 tc rgb '{}' point pt {} ps "
        "0.7 "
        "lw 1.4 lc rgb '{}'\n",
        structures::to_string(kind), place, to_hex(readable(colour_of(kind))), mark_of(kind), colour);
  }
  void add_spread() {
    const Spread s = spread_of_metric(e_, 0);
    bar("spread.txt", 100.0 * s.low, 100.0 * s.high, 2.0, category(0));
    point("median.txt", 100.0 * s.median, 2.0, full, category(0));
  }
  void add_step() {
    if (!holds(e_.half_step) || !holds(e_.members.front())) return;
    const double own = percent(e_.members.front()), half = percent(e_.half_step);
    bar("step.txt", std::min(own, half), std::max(own, half), 1.0, category(1));
    point("own.txt", own, 1.0, full, ink::black);
    point("half.txt", half, 1.0, hollow, category(1));
  }
  void bar(const std::string& name, double from, double to, double row, Colour colour) {
    figure_.data[name] = fmt::format("{:.6g} {:.4g}\n{:.6g} {:.4g}\n", from, row, to, row);
    plot_ += fmt::format(", '{}' using 1:2 with lines lw 4 lc rgb '{}' notitle", name, to_hex(colour));
  }
  void point(const std::string& name, double at, double row, int type, Colour colour) {
    figure_.data[name] = fmt::format("{:.6g} {:.4g}\n", at, row);
    plot_ += fmt::format(", '{}' using 1:2 with points pt {} ps 0.9 lw 1.6 lc rgb '{}' notitle", name, type,
                         to_hex(colour));
  }
  static double percent(const EnsembleMember& member) { return 100.0 * member.values.front(); }
  /// In three lanes, so that runs that agree do not hide each other.
  static double height_of(std::size_t run) { return 3.0 + 0.22 * (static_cast<double>(run % 3) - 1.0); }

  const EnsembleSheet& e_;
  Figure& figure_;
  std::string plot_, labels_;
  int shown_ = 0;
};

Range peaks_range(const EnsembleSheet& e) {
  std::vector<double> peaks;
  for (const EnsembleMember& member : e.members)
    if (holds(member)) peaks.push_back(100.0 * member.values.front());
  if (holds(e.half_step)) peaks.push_back(100.0 * e.half_step.values.front());
  return padded(range_of(peaks), 0.06, 0.01);
}

}  // namespace

bool has_ensemble_figure(const RunResult& run) {
  const auto& members = run.ensemble.members;
  return members.size() > 1 && std::ranges::any_of(members, [](const EnsembleMember& member) {
           return holds(member) && !member.roof_times.empty();
         });
}

Figure ensemble_figure(const RunResult& run) {
  const EnsembleSheet& e = run.ensemble;
  const auto& times = longest_times(e);
  Stack stack{"Roof drift and peak drift of every run of the ensemble",
              run_line(run),
              "Time, t (s)",
              {times.front(), times.back()},
              {histories_panel(e)},
              right};
  stack.room_below = strip_height + strip_axis;
  const int height = stack_height(stack);
  Figure strip;
  stack.below = margins({84, stack_width - right, height - stack.room_below, height - strip_axis},
                        stack_width, height) +
                Strip(e, strip).script(peaks_range(e));
  Figure figure = stacked(stack);
  figure.data.merge(strip.data);
  return figure;
}

}  // namespace dougong::app
