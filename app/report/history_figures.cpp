// The plots over time: motion, storey drift, roof and base shear, energy, overlap.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/text.h"
#include "app/study/output_times.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::Envelope;
using structures::Peak;
using structures::StoreyResponse;
using Print = std::function<std::string(double)>;

constexpr double g = engine::standard_gravity;
constexpr std::size_t most_storeys = 12;  // panels of storey drift; beyond, those that drift most

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

Print with_unit(int decimals, const std::string& unit) {
  return [=](double value) { return signed_fixed(value, decimals) + " " + unit; };
}

/// Decimals that leave about three digits of the largest value.
int decimals_for(const std::vector<double>& values) {
  const Range r = range_of(values);
  const double size = std::max(std::abs(r.low), std::abs(r.high));
  if (size == 0.0) return 1;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 4);
}

Mark peak_mark(Peak peak, double factor, const Print& print, Colour colour) {
  return {peak.time, factor * peak.value, print(factor * peak.value) + " at " + seconds(peak.time), colour};
}

/// Marks on both peaks; a peak of zero is none.
void mark_peaks(Panel& panel, const Envelope& e, double factor, const Print& print, Colour colour) {
  if (e.positive.value > 0) panel.marks.push_back(peak_mark(e.positive, factor, print, colour));
  if (e.negative.value < 0) panel.marks.push_back(peak_mark(e.negative, factor, print, colour));
}

Envelope envelope_of(const std::vector<double>& times, const std::vector<double>& values) {
  Envelope e;
  for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i) {
    if (values[i] > e.positive.value) e.positive = {values[i], times[i]};
    if (values[i] < e.negative.value) e.negative = {values[i], times[i]};
  }
  return e;
}

Range time_range(const std::vector<double>& times) {
  return times.empty() ? Range{0.0, 1.0} : Range{times.front(), times.back()};
}

struct Quantity {
  std::string label;
  const std::vector<double>* values;
  double factor;
  std::string unit;
};

Panel history_panel(const std::vector<double>& times, const Quantity& q, Colour colour, double height) {
  Panel panel{q.label, {}, {}, "", ink::quiet, height, 1.2};
  const std::vector<double> values = scaled(*q.values, q.factor);
  panel.curves.push_back({times, values, colour, 1.0, false, ""});
  mark_peaks(panel, envelope_of(times, values), 1.0, with_unit(decimals_for(values), q.unit), ink::text);
  const Range r = range_of(values);
  if (r.low == 0.0 && r.high == 0.0) panel.note = values.empty() ? "no data" : "zero throughout";
  return panel;
}

double acceleration_unit() {
  return 1.0 / g;
}

void add_vertical(Stack& stack, const MotionSheet& m) {
  if (m.acceleration_y.empty()) return;
  stack.panels.push_back(history_panel(
      m.times, {"Vertical acc. (g)", &m.acceleration_y, acceleration_unit(), "g"}, category(0), 110));
}

std::vector<std::size_t> drifting_storeys(const std::vector<StoreyResponse>& storeys) {
  std::vector<std::size_t> all(storeys.size());
  std::iota(all.begin(), all.end(), 0u);
  std::erase_if(all, [&](std::size_t i) { return storeys[i].is_base; });
  return all;
}

/// Storeys to draw, top first; all, or those with the largest peaks.
std::vector<std::size_t> drawn_storeys(const std::vector<StoreyResponse>& storeys) {
  std::vector<std::size_t> chosen = drifting_storeys(storeys);
  const auto size = [&](std::size_t i) { return std::abs(storeys[i].peak_drift.largest().value); };
  std::stable_sort(chosen.begin(), chosen.end(), [&](auto a, auto b) { return size(a) > size(b); });
  chosen.resize(std::min(chosen.size(), most_storeys));
  std::sort(chosen.rbegin(), chosen.rend());
  return chosen;
}

/// Solid while the storey stands; from the loss on the frozen value, dashed and grey.
void add_drift(Panel& panel, const std::vector<double>& times, const StoreyResponse& storey, Colour colour) {
  const std::vector<double> percent = scaled(storey.drift, 100.0);
  const double lost_at = storey.lost_at.value_or(std::numeric_limits<double>::infinity());
  const auto cut = std::lower_bound(times.begin(), times.end(), lost_at) - times.begin();
  const auto n = std::min<std::ptrdiff_t>(cut, static_cast<std::ptrdiff_t>(percent.size()));
  panel.curves.push_back(
      {{times.begin(), times.begin() + n}, {percent.begin(), percent.begin() + n}, colour, 1.2, false, ""});
  if (!storey.lost_at) return;
  const double frozen = n > 0 ? percent[static_cast<std::size_t>(n - 1)] : 0.0;
  if (!times.empty())
    panel.curves.push_back({{lost_at, times.back()}, {frozen, frozen}, ink::quiet, 1.0, true, ""});
  panel.marks.push_back({lost_at, frozen, "", ink::lost, true});
  panel.note = "lost at " + seconds(lost_at);
  panel.note_colour = ink::lost;
}

/// The same decimals in every panel: about three digits of the largest peak, in percent.
int drift_decimals(const RunResult& run) {
  std::vector<double> peaks;
  for (const StoreyResponse& storey : run.response.storeys)
    peaks.push_back(100.0 * storey.peak_drift.largest().value);
  return decimals_for(peaks);
}

Panel drift_panel(const RunResult& run, std::size_t index, double height) {
  const StoreyResponse& storey = run.response.storeys[index];
  Panel panel{storey.name + ", θ (%)", {}, {}, "", ink::quiet, height, 0.1};
  add_drift(panel, run.response.times, storey, category(index));
  mark_peaks(panel, storey.peak_drift, 100.0, with_unit(drift_decimals(run), "%"), ink::text);
  return panel;
}

struct Term {
  const char* name;
  const std::vector<double>* values;
  Colour colour;
};

double largest_term(const std::vector<Term>& terms) {
  double size = 0.0;
  for (const Term& term : terms) {
    const Range r = range_of(*term.values);
    size = std::max({size, std::abs(r.low), std::abs(r.high)});
  }
  return size;
}

Panel energy_terms_panel(const RunResult& run) {
  const EnergyHistory& e = run.energy;
  std::vector<double> gravity = e.gravity.empty() ? e.gravity : since_start(e.gravity);
  const std::vector<Term> terms{{"input", &e.input, ink::black},        {"kinetic", &e.kinetic, category(0)},
                                {"gravity", &gravity, category(2)},     {"elastic", &e.elastic, category(3)},
                                {"friction", &e.friction, category(1)}, {"damping", &e.damping, category(4)}};
  const auto [factor, unit] = energy_unit(largest_term(terms));
  Panel panel{"Energy, E (" + unit + ")", {}, {}, "", ink::quiet, 260, 1.0};
  for (const Term& term : terms) {
    panel.curves.push_back(
        {output_times(run), scaled(*term.values, factor), term.colour, 1.4, false, term.name});
  }
  return panel;
}

/// J, what the relative error is relative to: 0 when there is no error.
double energy_turned_over(const EnergyHistory& e) {
  const Range r = range_of(e.error);
  const double largest = std::max(std::abs(r.low), std::abs(r.high));
  return e.relative_error > 0.0 ? largest / e.relative_error : 0.0;
}

Panel energy_error_panel(const RunResult& run) {
  const EnergyHistory& e = run.energy;
  const auto& times = output_times(run);
  const double whole = energy_turned_over(e);
  if (!(whole > 0.0)) return history_panel(times, {"Error (J)", &e.error, 1.0, "J"}, ink::lost, 100);
  Panel panel = history_panel(times, {"Error (%)", &e.error, 100.0 / whole, "%"}, ink::lost, 100);
  panel.note = "of the energy turned over";
  return panel;
}

}  // namespace

Figure motion_figure(const RunResult& run) {
  const MotionSheet& m = run.motion;
  Stack stack{"Ground motion given to the terrain", m.title, "Time, t (s)", time_range(m.times), {}, 30};
  stack.panels = {history_panel(m.times, {"Acceleration, a (g)", &m.acceleration_x, acceleration_unit(), "g"},
                                category(0), 120),
                  history_panel(m.times, {"Velocity, v (m/s)", &m.velocity_x, 1.0, "m/s"}, category(0), 120),
                  history_panel(m.times, {"Displ., d (mm)", &m.displacement_x, 1e3, "mm"}, category(0), 120)};
  add_vertical(stack, m);
  return stacked(stack);
}

Figure drift_histories_figure(const RunResult& run) {
  const auto& storeys = run.response.storeys;
  const auto chosen = drawn_storeys(storeys);
  std::string title = "Interstorey drift ratio, θ (%)";
  if (const std::size_t all = drifting_storeys(storeys).size(); chosen.size() < all)
    title += fmt::format(": the {} of {} storeys that drift most", chosen.size(), all);
  Stack stack{title, run_line(run), "Time, t (s)", time_range(run.response.times), {}, 30};
  for (const std::size_t i : chosen)
    stack.panels.push_back(drift_panel(run, i, chosen.size() > 6 ? 78 : 104));
  return stacked(stack);
}

Figure roof_and_base_shear_figure(const RunResult& run) {
  const auto& r = run.response;
  const std::vector<double> times = until_first_loss(r, r.times), shear = until_first_loss(r, r.base_shear),
                            moment = until_first_loss(r, r.overturning_moment);
  Stack stack{"Roof displacement, base shear and overturning moment",
              run_line(run),
              "Time, t (s)",
              time_range(r.times),
              {},
              30};
  const double share = r.weight > 0 ? 1.0 / r.weight : 0.0;
  const std::vector<double> ground = run.motion.acceleration_x;
  stack.panels = {
      history_panel(run.motion.times, {"Ground acc. (g)", &ground, acceleration_unit(), "g"}, ink::quiet,
                    110),
      history_panel(r.times, {"Roof displ., u (mm)", &r.roof_displacement, 1e3, "mm"}, category(0), 130),
      history_panel(times, {"Base shear, V/W (-)", &shear, share, "W"}, category(1), 130)};
  if (const double arm = r.weight * r.height; arm > 0.0 && !r.overturning_moment.empty())
    stack.panels.push_back(
        history_panel(times, {"Moment, M/WH (-)", &moment, 1.0 / arm, "WH"}, category(2), 130));
  for (std::size_t i = 2; i < stack.panels.size() && times.size() < r.times.size(); ++i)
    stack.panels[i].note = "until the first storey was lost";
  return stacked(stack);
}

Figure mass_lost_figure(const RunResult& run) {
  const auto& times = run.response.times;
  Range shown = time_range(times);  // from a little before the collapse began
  const double began = run.collapse.initiation.value_or(shown.low);
  shown.low = std::max(shown.low, began - 0.1 * (shown.high - began) - 1.0);
  Stack stack{"Mass lost from each storey", run_line(run), "Time, t (s)", shown, {}, 60};
  Panel panel{"Mass lost (%)", {}, {}, "", ink::quiet, 200, 1.0};
  for (std::size_t i = 0; i < run.response.storeys.size(); ++i) {
    const StoreyResponse& storey = run.response.storeys[i];
    panel.curves.push_back({times, scaled(storey.mass_lost, 100.0), category(i), 1.6, false, storey.name});
  }
  stack.panels = {panel};
  return stacked(stack);
}

Figure energy_figure(const RunResult& run) {
  Stack stack{"Energy balance",
              run_line(run) + "; gravity: change since the start",
              "Time, t (s)",
              time_range(output_times(run)),
              {},
              90};
  stack.panels = {energy_terms_panel(run), energy_error_panel(run)};
  return stacked(stack);
}

Figure overlap_figure(const RunResult& run) {
  const Numerics& n = run.numerics;
  const auto times = output_times(run);
  const bool means = n.mean_overlap_ratio.size() == times.size();
  Stack stack{"Overlap between blocks, over the smaller block's width",
              run_line(run),
              "Time, t (s)",
              time_range(times),
              {},
              means ? 70 : 30};
  Panel panel = history_panel(times, {"Overlap ratio (%)", &n.overlap_ratio, 100.0, "%"}, category(0), 130);
  if (means) {
    panel.curves.front().end_label = "deepest";
    panel.curves.push_back({times, scaled(n.mean_overlap_ratio, 100.0), category(1), 1.0, false, "mean"});
  }
  stack.panels = {panel};
  return stacked(stack);
}

}  // namespace dougong::app
