// The load path as a graph: from block to block through the place where the force passes, drawn by its size.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/report/axis.h"
#include "app/report/block_drawing.h"
#include "app/report/figures.h"
#include "app/report/text.h"
#include "app/report/weight_joints_report.h"

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr double thinnest = 0.7, thickest = 6.0;  // px

double greatest_force(const std::vector<WeightJoint>& joints) {
  double most = 1.0;  // N
  for (const WeightJoint& joint : joints) most = std::max(most, std::abs(joint.normal));
  return most;
}

/// Across a joint, away from a block's middle.
Vec2 outward(const WeightJoint& joint, Vec2 middle) {
  const Vec2 across = engine::turned(joint.end - joint.start);
  return dot(across, 0.5 * (joint.start + joint.end) - middle) < 0.0 ? -1.0 * across : across;
}

/// Pressed from two opposite sides and nowhere else: the thrust goes straight through, as in an arch or a
/// column, and not by the middle.
bool lets_through(const std::vector<const WeightJoint*>& of_block, Vec2 middle) {
  return of_block.size() == 2 && of_block[0]->normal > 0.0 && of_block[1]->normal > 0.0 &&
         dot(outward(*of_block[0], middle), outward(*of_block[1], middle)) < 0.0;
}

// Tension has its own colour.
DrawingLine path_line(Vec2 from, Vec2 to, double force, double end_of_scale) {
  const double share = std::abs(force) / 1e3 / end_of_scale;
  return {from, to, force < 0.0 ? ink::lost : viridis(share),
          thinnest + (thickest - thinnest) * std::min(share, 1.0)};
}

/// Within one block, from joint to joint or from its middle to its joints.
void add_block(const std::vector<const WeightJoint*>& of_block, Vec2 middle, Vec2 ground,
               std::vector<std::pair<double, DrawingLine>>& lines, double end_of_scale) {
  const auto add = [&](Vec2 from, Vec2 to, double force) {
    lines.emplace_back(std::abs(force), path_line(from - ground, to - ground, force, end_of_scale));
  };
  if (lets_through(of_block, middle))
    return add(of_block[0]->through, of_block[1]->through,
               std::max(of_block[0]->normal, of_block[1]->normal));
  for (const WeightJoint* joint : of_block) add(middle, joint->through, joint->normal);
}

// The largest on top. `middles` are the blocks', relative to the ground.
void add_paths(const std::vector<WeightJoint>& joints, const std::vector<Vec2>& middles, Vec2 ground,
               BlockDrawing& drawing) {
  std::vector<std::vector<const WeightJoint*>> of_blocks(middles.size());
  for (const WeightJoint& joint : joints)
    for (const std::size_t body : {joint.a, joint.b})
      if (joint.a != joint.b && body < middles.size()) of_blocks[body].push_back(&joint);
  std::vector<std::pair<double, DrawingLine>> lines;
  for (std::size_t i = 0; i < middles.size(); ++i)
    add_block(of_blocks[i], middles[i] + ground, ground, lines, drawing.scale_end);
  std::ranges::stable_sort(lines, {}, [](const auto& line) { return line.first; });
  for (const auto& [force, line] : lines) drawing.lines.push_back(line);
}

std::string counted(const std::vector<WeightJoint>& joints) {
  const auto tension = std::ranges::count_if(joints, [](const WeightJoint& j) { return j.normal < 0.0; });
  return plural(joints.size() - static_cast<std::size_t>(tension), "joint") + " in compression" +
         (tension > 0 ? fmt::format(", {} in tension (red)", tension) : "");
}

BlockDrawing graph(const std::string& title, const std::string& subtitle,
                   const std::vector<WeightJoint>& joints, std::size_t blocks) {
  BlockDrawing drawing;
  drawing.title = title, drawing.subtitle = subtitle;
  drawing.fill.assign(blocks, mixed(ink::white, ink::block, 0.6));
  drawing.scale_title = "kN";
  drawing.scale_end = round_up(greatest_force(joints) / 1e3);
  drawing.legend = {
      "Lines through where the forces pass the joints: straight where a block is pressed from two sides,",
      "by its middle elsewhere; " + counted(joints) + "."};
  return drawing;
}

}  // namespace

Figure load_path_figure(const ModelSheet& model, const std::vector<WeightJoint>& joints) {
  std::vector<Vec2> middles;
  for (const DrawnShape& block : model.blocks) middles.push_back(block.position);
  BlockDrawing drawing =
      graph("How the weight goes down", model.layout + ": " + model.title, joints, middles.size());
  add_paths(joints, middles, {}, drawing);
  return block_figure(model, drawing);
}

bool has_end_load_path(const RunResult& run) {
  return !run.end_joints.empty() && !run.trajectory.times.empty() &&
         run.trajectory.blocks == run.model.blocks.size();
}

Figure end_load_path_figure(const RunResult& run) {
  const std::size_t last = run.trajectory.times.size() - 1;
  BlockDrawing drawing = graph("What bears the load at " + seconds(run.trajectory.times[last]), run_line(run),
                               run.end_joints, run.model.blocks.size());
  std::vector<Vec2> middles;
  for (std::size_t i = 0; i < run.model.blocks.size(); ++i) {
    drawing.moved.push_back(pose_at(run.trajectory, last, i, 1.0));
    middles.push_back(drawing.moved.back().position);
  }
  add_paths(run.end_joints, middles, run.trajectory.ground_displacement[last], drawing);
  return block_figure(run.model, drawing);
}

}  // namespace dougong::app
