// Histories of all variants on one record, over one time axis.
#include <fmt/format.h>

#include <algorithm>

#include "app/report/comparison_figures.h"
#include "app/report/comparison_legend.h"
#include "app/report/comparison_text.h"
#include "app/report/histories.h"
#include "app/report/text.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::StoreyResponse;

constexpr double g = engine::standard_gravity;

/// One history of a run and the time up to which it means something.
struct History {
  const std::vector<double>* values;
  double factor;
  double until = std::numeric_limits<double>::infinity();
};

Curve curve_of(const RunResult& run, const History& history, std::size_t variant) {
  Curve curve{{}, {}, variant_colour(variant), variant == 0 ? 1.4 : 1.1, false, letter(variant)};
  const auto& times = run.response.times;
  for (std::size_t i = 0; i < std::min(times.size(), history.values->size()); ++i) {
    if (times[i] >= history.until) break;
    curve.x.push_back(times[i]), curve.y.push_back(history.factor * (*history.values)[i]);
  }
  return curve;
}

/// The storey that drifts most in any of the runs.
std::string telling_storey(const std::vector<RunResult>& described) {
  std::string name;
  double most = -1.0;
  for (const RunResult& run : described)
    if (const StoreyResponse* storey = structures::storey_of_peak_drift(run.response))
      if (const double size = std::abs(storey->peak_drift.largest().value); size > most)
        most = size, name = storey->name;
  return name;
}

const StoreyResponse* storey_named(const RunResult& run, const std::string& name) {
  const auto it = std::ranges::find(run.response.storeys, name, &StoreyResponse::name);
  return it == run.response.storeys.end() ? nullptr : &*it;
}

void add_loss(Panel& panel, const StoreyResponse& storey, std::size_t variant) {
  const Curve& curve = panel.curves.back();
  if (storey.lost_at && !curve.y.empty())
    panel.marks.push_back({*storey.lost_at, curve.y.back(), letter(variant) + " lost",
                           readable(variant_colour(variant)), true});
}

Panel roof_panel(const std::vector<RunResult>& described, std::size_t drawn) {
  Panel panel{"Roof displ., u (mm)", {}, {}, "relative to the ground", ink::quiet, 130, 1.2};
  for (std::size_t v = 0; v < drawn; ++v)
    panel.curves.push_back(curve_of(described[v], {&described[v].response.roof_displacement, 1e3}, v));
  return panel;
}

Panel drift_panel(const std::vector<RunResult>& described, std::size_t drawn) {
  const std::string name = telling_storey(described);
  Panel panel{"Drift, θ (%)", {}, {}, "of " + name + ", until it is lost", ink::quiet, 130, 0.1};
  for (std::size_t v = 0; v < drawn; ++v)
    if (const StoreyResponse* storey = storey_named(described[v], name)) {
      const double lost = storey->lost_at.value_or(std::numeric_limits<double>::infinity());
      panel.curves.push_back(curve_of(described[v], {&storey->drift, 100.0, lost}, v));
      add_loss(panel, *storey, v);
    }
  return panel;
}

double first_storey_lost(const RunResult& run) {
  double first = std::numeric_limits<double>::infinity();
  for (const StoreyResponse& storey : run.response.storeys)
    first = std::min(first, storey.lost_at.value_or(first));
  return first;
}

Panel shear_panel(const std::vector<RunResult>& described, std::size_t drawn) {
  Panel panel{"Base shear, V/W (-)", {}, {}, "until a storey is lost", ink::quiet, 130, 0.1};
  for (std::size_t v = 0; v < drawn; ++v) {
    const auto& r = described[v].response;
    if (r.weight > 0.0)
      panel.curves.push_back(
          curve_of(described[v], {&r.base_shear, 1.0 / r.weight, first_storey_lost(described[v])}, v));
  }
  return panel;
}

// Scaled motions differ by a factor only.
Panel ground_panel(const RunResult& reference) {
  Panel panel{"Ground acc. (g)", {}, {}, "of the reference", ink::quiet, 90, 0.1};
  Curve curve{reference.motion.times, reference.motion.acceleration_x, ink::quiet, 1.0, false, ""};
  for (double& value : curve.y) value /= g;
  panel.curves.push_back(std::move(curve));
  return panel;
}

}  // namespace

NamedFigure overlaid_histories(const Comparison& c, View view, std::size_t record,
                               const std::vector<RunResult>& described) {
  double end = 0.0;
  for (const RunResult& run : described)
    if (!run.response.times.empty()) end = std::max(end, run.response.times.back());
  Stack stack{"Histories of the runs as described",
              c.records[record] + ", " + to_string(view),
              "Time, t (s)",
              {0.0, end},
              {},
              34};
  const std::size_t drawn = std::min(drawn_variants(c), described.size());
  stack.panels = {ground_panel(described.front()), roof_panel(described, drawn),
                  drift_panel(described, drawn), shear_panel(described, drawn)};
  stack.room_below = legend_height(c);
  stack.labels = legend_labels(c, stack_width, stack_height(stack));
  const std::string name =
      fmt::format("histories_{}{}", folder_name(c.records[record]), view == View::same_sa ? "_same_sa" : "");
  return {name,
          "Roof displacement, storey drift and base shear of all variants on " + c.records[record] +
              " against time, " + to_string(view) + ".",
          stacked(stack)};
}

}  // namespace dougong::app
