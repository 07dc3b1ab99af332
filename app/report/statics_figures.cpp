// The figures of a static analysis: the search, the capacity curve, the mechanism.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/block_drawing.h"
#include "app/report/colour.h"
#include "app/report/histories.h"
#include "app/report/statics_report.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using structures::Direction;
using structures::JointAction;

constexpr int width = 880, height = 430, left = 84, right = 40, top = 74, bottom = 58;  // px

/// A side keeps its colour through all figures.
std::size_t colour_of(Direction side) {
  return side == Direction::right ? 0 : 1;
}

std::string line_of(const StaticResult& r) {
  const std::string load = r.choice.pattern ? to_string(*r.choice.pattern) + " pattern" : "tilting table";
  return fmt::format("{}, {}", r.model.layout, load);
}

std::string label(const std::string& text, double x, double y, const char* how, Colour colour) {
  return fmt::format("set label {} at {:.6g},{:.6g} {} front tc rgb '{}'\n", gnuplot_text(text), x, y, how,
                     to_hex(colour));
}

Figure plain(const std::string& title, const StaticResult& r) {
  Figure figure{width, height, "", {}};
  figure.script = plain_style() + margins({left, width - right, top, height - bottom}, width, height) +
                  heading(title, line_of(r), width, height);
  return figure;
}

std::string axes(Range x, Range y, const std::string& x_label, const std::string& y_label) {
  return fmt::format(
             "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:.6g}\nset ytics {:.6g}\n",
             x.low, x.high, y.low, y.high, round_step(x.span(), 8), round_step(y.span(), 7)) +
         fmt::format("set xlabel {}\nset ylabel {}\n", gnuplot_text(x_label), gnuplot_text(y_label));
}

struct Extent {
  double drift = 0.0, multiplier = 0.0;  // %, -
};
Extent extent_of(const StaticResult& r) {
  Extent e;
  for (const SideResult& s : r.sides) {
    for (const auto& p : s.curve.points) {
      e.drift = std::max(e.drift, 100.0 * p.roof / r.height);
      e.multiplier = std::max(e.multiplier, p.multiplier);
    }
    e.multiplier = std::max(e.multiplier, s.found.stands);
  }
  return e;
}

/// The first crack of a curve, and its peak.
std::string curve_marks(const StaticResult& r, const SideResult& s, const Extent& extent, int row) {
  const Colour ink = category_ink(colour_of(s.side));
  const auto& points = s.curve.points;
  const auto& peak = points[s.curve.peak()];
  std::string out;
  const auto dot = [&](const structures::CapacityPoint& p, bool full) {
    out += fmt::format("set label '' at {:.6g},{:.6g} point pt {} ps 1.1 lc rgb '{}' front\n",
                       100.0 * p.roof / r.height, p.multiplier, full ? 7 : 6, to_hex(ink));
  };
  std::string words =
      fmt::format("towards the {}: peak V/W {} at {} % drift", to_string(s.side),
                  significant(peak.multiplier, 3), significant(100.0 * peak.roof / r.height, 2));
  dot(peak, true);
  if (!s.curve.events.empty()) {
    const auto& e = s.curve.events.front();
    dot(points[e.point], false);
    words += fmt::format("; first {} (open circle) at V/W {}", e.how == "yield" ? "yield" : "crack",
                         significant(points[e.point].multiplier, 3));
  }
  return out +
         label(words, 0.97 * extent.drift * 1.06, extent.multiplier * (1.27 - 0.075 * row), "right", ink);
}

std::string bracket_line(const SideResult& s) {
  if (!std::isfinite(s.found.falls)) return "";
  return fmt::format(
      "set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead lw 1 dt (6,4) lc rgb '{1}'\n",
      s.found.stands, to_hex(category(colour_of(s.side))));
}

Colour action_colour(JointAction action) {
  return action == JointAction::hinge ? ink::lost : action == JointAction::sliding ? category(1) : ink::quiet;
}

/// Between where the two bodies have taken the place of the joint: magnified turns draw them apart.
DrawingMark mark_of(const StaticResult& r, const structures::MovingJoint& joint,
                    const std::vector<Pose>& poses) {
  const MarkShape shape = joint.action == JointAction::hinge     ? MarkShape::dot
                          : joint.action == JointAction::sliding ? MarkShape::arrows
                                                                 : MarkShape::cross;
  const auto moved = [&](std::size_t body) {
    if (body >= poses.size()) return joint.place;
    const Pose still = described_pose(r.model.blocks[body]);
    return poses[body].position +
           engine::rotated(joint.place - still.position, poses[body].angle - still.angle);
  };
  return {shape, 0.5 * (moved(joint.a) + moved(joint.b)), joint.tangent, action_colour(joint.action)};
}

}  // namespace

Figure capacity_figure(const StaticResult& r) {
  Figure figure = plain("Resistance against roof drift", r);
  const Extent extent = extent_of(r);
  figure.script += axes({0.0, 1.06 * extent.drift}, {0.0, 1.35 * extent.multiplier}, "Roof drift, u/H (%)",
                        "Base shear over weight, V/W (-)");
  std::string curves = "plot NaN notitle";
  int row = 0;
  for (const SideResult& s : r.sides) {
    if (s.curve.points.empty()) continue;
    const std::string name = to_string(s.side) + ".txt";
    for (const auto& p : s.curve.points)
      figure.data[name] += fmt::format("{:.8g} {:.8g}\n", 100.0 * p.roof / r.height, p.multiplier);
    figure.script += bracket_line(s) + curve_marks(r, s, extent, row++);
    curves += fmt::format(", '{}' with lines lw {} lc rgb '{}' notitle", name, row == 1 ? 2.4 : 1.6,
                          to_hex(category(colour_of(s.side))));
  }
  figure.script +=
      "set label 'dashed: the greatest multiplier that stood as a dead load' at graph 0.985, graph 1.03 "
      "right front tc rgb '" +
      to_hex(ink::quiet) + "'\n" + curves + "\n";
  return figure;
}

Figure trials_figure(const StaticResult& r) {
  Figure figure = plain("The search for the collapse multiplier", r);
  double most = 0.0;
  std::size_t count = 1;
  int row = 0;
  std::string curves = "plot NaN notitle";
  for (const SideResult& s : r.sides) {
    const std::string side = to_string(s.side);
    for (std::size_t i = 0; i < s.found.trials.size(); ++i) {
      const structures::Trial& t = s.found.trials[i];
      const std::string group = t.result == structures::TrialResult::stands ? "_stands.txt" : "_falls.txt";
      figure.data[side + group] += fmt::format("{} {:.8g}\n", i + 1, t.multiplier);
      most = std::max(most, t.multiplier), count = std::max(count, i + 1);
    }
    for (const auto& [group, point] : {std::pair{"_stands.txt", 7}, {"_falls.txt", 6}})
      if (figure.data.contains(side + group))
        curves += fmt::format(", '{}' with points pt {} ps 1.1 lc rgb '{}' notitle", side + group, point,
                              to_hex(category(colour_of(s.side))));
    figure.script += fmt::format("set label {} at graph 0.015, graph {:.3f} left front tc rgb '{}'\n",
                                 gnuplot_text(fmt::format("towards the {}: {}", side, bracket_text(s.found))),
                                 0.95 - 0.075 * row++, to_hex(category_ink(colour_of(s.side))));
  }
  figure.script +=
      axes({0.0, static_cast<double>(count) + 1.0}, {0.0, most > 0.0 ? 1.3 * most : 1.0}, "Trial",
           r.choice.pattern ? "Multiplier, λ = V/W (-)" : "Multiplier, λ = tan θ (-)") +
      "set label 'filled: stood   open: did not' at graph 0.985, graph 0.04 right front tc rgb '" +
      to_hex(ink::quiet) + "'\n" + curves + "\n";
  return figure;
}

Figure mechanism_figure(const StaticResult& r, const SideResult& s) {
  std::vector<engine::Vec2> motions;
  for (const auto& m : s.found.mechanism) motions.push_back(m.translation);
  const double factor = drawn_magnification(r.model, motions);
  BlockDrawing drawing;
  drawing.title = fmt::format("How it begins to go towards the {}", to_string(s.side));
  drawing.subtitle = fmt::format("{}, λ = {}", line_of(r), significant(s.found.falls, 4));
  drawing.fill.assign(r.model.blocks.size(), ink::block);
  for (const std::size_t block : s.mechanism.moving)
    drawing.fill[block] = mixed(ink::white, category(colour_of(s.side)), 0.35);
  for (std::size_t i = 0; i < r.model.blocks.size(); ++i) {
    const Pose pose = described_pose(r.model.blocks[i]);
    drawing.moved.push_back(
        {pose.position + factor * motions[i], pose.angle + factor * s.found.mechanism[i].turn});
  }
  for (const auto& joint : s.mechanism.joints) drawing.marks.push_back(mark_of(r, joint, drawing.moved));
  drawing.legend = {
      fmt::format(
          "Motion of the trial that fell × {}; pale: where the blocks stood; coloured: blocks that move.",
          factor_text(factor)),
      "Circle: hinge.  Arrows: sliding.  Cross: joint that parts."};
  return block_figure(r.model, drawing);
}

}  // namespace dougong::app
