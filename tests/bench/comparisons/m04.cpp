// M04: rocking with the ratios of the spins measured on concrete and on rubber, and with one above Housner's;
// by the contact engine, beside the rigid block of the same ratio event by event.
//
//     comparisons M04 FOLDER [E_in_GPa] [damping_ratio] [step_fraction] [let_go] [half_height_in_m] [ratios]
//
// let_go over alpha; the ratios asked for in the order of the table.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "app/report/histories.h"
#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/rocking.h"

namespace dougong::comparisons {
namespace {

using oracles::RockingBlock;

struct Settings {
  double young_modulus = 300e9, damping_ratio = 2.0, step_fraction = 0.125;
  double let_go = 0.5;       // of alpha
  double half_height = 1.0;  // m
};

struct Base {
  const char* name;
  double slenderness;           // height over width
  std::optional<double> ratio;  // of the spins after and before; nothing asked for where empty

  RockingBlock block(const Settings& s) const {
    return {s.half_height / slenderness, s.half_height, 9.81, 0.0, ratio};
  }
};

constexpr double drawn = 5.0;  // the slenderness of the figure
constexpr int count = 4;       // impacts

std::vector<Base> bases_of(const Arguments& arguments) {
  std::vector<Base> bases{{"above Housner's", drawn, 0.965},
                          {"Housner's", drawn, {}},
                          {"concrete", drawn, 0.895},
                          {"rubber", drawn, 0.631},
                          {"concrete", 3.0, 0.8245}};
  std::size_t next = 5;
  for (Base& base : bases)
    if (base.ratio && next < arguments.size()) base.ratio = std::stod(arguments[next++]);
  return bases;
}

Settings settings_of(const Arguments& arguments) {
  Settings s;
  const auto read = [&](std::size_t i, double& value, double unit = 1.0) {
    if (i < arguments.size()) value = unit * std::stod(arguments[i]);
  };
  read(0, s.young_modulus, 1e9), read(1, s.damping_ratio), read(2, s.step_fraction);
  read(3, s.let_go), read(4, s.half_height);
  return s;
}

scenes::Running let_go(const RockingBlock& c, const Settings& s) {
  auto scene = scenes::tilted_block(c, s.let_go * c.alpha(), s.young_modulus, s.damping_ratio);
  scene.materials[0].rocking_restitution = c.restitution;
  return scenes::Running(scene);
}

/// As long as a block without loss takes for the impacts and the rise after the last.
engine::DriveOptions options_for(const RockingBlock& c, const Settings& s) {
  auto options = scenes::run_for(2.0 * (count + 0.5) * c.fall_time(s.let_go * c.alpha()), 2e-4);
  options.step_fraction = s.step_fraction;
  return options;
}

std::vector<oracles::Impact> impacts_of(const RockingBlock& c, const Settings& s) {
  scenes::Running r = let_go(c, s);
  const auto impacts = scenes::measured_impacts(r, options_for(c, s), count);
  if (impacts.size() < count) throw std::runtime_error("the block came to rest or fell before impact 4");
  return impacts;
}

/// A swing's height gives the spin at its ends.
std::string table_row(const Base& base, const Settings& s) {
  const RockingBlock c = base.block(s);
  double amplitude = s.let_go * c.alpha();
  const oracles::Impact exact = c.impacts(amplitude, count).back();
  const auto ours = impacts_of(c, s);
  std::string out = fmt::format("| {:g} | {} | {:.4f} |", base.slenderness, base.name, c.velocity_ratio());
  for (const oracles::Impact& impact : ours) {
    const double ratio = c.spin_at_impact(impact.amplitude_after) / c.spin_at_impact(amplitude);
    out += fmt::format(" {:.4f} |", ratio / c.velocity_ratio());
    amplitude = impact.amplitude_after;
  }
  return out + fmt::format(" {:.4f} | {:.4f} | {:.3f} | {:.3f} |\n", exact.amplitude_after / c.alpha(),
                           amplitude / c.alpha(), exact.time, ours.back().time);
}

/// The angle over alpha, positive at the start.
app::Curve history(const RockingBlock& c, const Settings& s, app::Colour colour) {
  app::Curve curve;
  curve.colour = colour, curve.width = 1.4;
  scenes::Running r = let_go(c, s);
  r.run(options_for(c, s), [&](const engine::Sample& sample) {
    curve.x.push_back(sample.state.time), curve.y.push_back(-r.angle() / c.alpha());
    return engine::Wish::go_on;
  });
  return curve;
}

/// Of the rigid block, up to a time, while they can be told from rest.
std::vector<app::Mark> peaks(const RockingBlock& c, const Settings& s, double until) {
  std::vector<app::Mark> marks;
  double side = -1.0;
  for (const oracles::Impact& impact : c.impacts(s.let_go * c.alpha(), 3 * count)) {
    const double time = impact.time + c.fall_time(impact.amplitude_after);
    const double height = impact.amplitude_after / c.alpha();
    if (time > until || height < 0.005) break;
    marks.push_back({time, side * height, fmt::format("{:.3f}", height), app::ink::text});
    side = -side;
  }
  return marks;
}

app::Panel panel(const Base& base, const Settings& s, app::Colour colour) {
  const RockingBlock c = base.block(s);
  const app::Curve curve = history(c, s, colour);
  const double room = 1.2 * s.let_go;  // for the note; the same scale in all
  app::Curve axis;
  axis.x = {0.0, 0.0}, axis.y = {-room, room}, axis.colour = app::ink::pale;
  app::Panel panel;
  panel.label = "Angle, θ/α", panel.curves = {axis, curve}, panel.marks = peaks(c, s, curve.x.back());
  panel.note = fmt::format("{}: r = {:.3f}", base.name, c.velocity_ratio());
  panel.note_colour = app::readable(colour), panel.height = 140;
  return panel;
}

app::Figure figure_of(const std::vector<Base>& bases, const Settings& s) {
  app::Stack stack;
  stack.title =
      "Rocking of a block of height/width 5, by the ratio r of its spins after and before an impact";
  stack.subtitle = "Lines: Dougong. Dots and numbers: peaks of the rigid block of the same r, event by event";
  for (const Base& base : bases)
    if (base.slenderness == drawn) stack.panels.push_back(panel(base, s, app::category(stack.panels.size())));
  stack.x = {0.0, stack.panels.front().curves.back().x.back()};
  return app::stacked(stack);
}

}  // namespace

Comparison rocking_restitution(const Arguments& arguments) {
  const Settings s = settings_of(arguments);
  const std::vector<Base> bases = bases_of(arguments);
  std::string table =
      "| height/width | base | ratio r | ours/r, impact 1 | 2 | 3 | 4 "
      "| then θ/α, rigid block | ours | impact 4 (s), rigid block | ours |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Base& base : bases) table += table_row(base, s);
  return {table, figure_of(bases, s)};
}

}  // namespace dougong::comparisons
