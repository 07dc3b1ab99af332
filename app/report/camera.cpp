#include "app/report/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dougong::app {
namespace {

using engine::Vec2;
using structures::Trajectory;

constexpr int circle_corners = 48;
constexpr double debris_reach = 1.5;   // building sizes beyond which debris is left out of the picture
constexpr double margin = 0.07;        // of the larger side
constexpr double least_ground = 0.05;  // of the height, shown below the lowest block

constexpr Box nothing{{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
                      {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}};

void include(Box& box, const std::vector<Vec2>& points) {
  for (const Vec2 p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
}

Box clipped(Box box, Box limits) {
  return {{std::max(box.low.x, limits.low.x), std::max(box.low.y, limits.low.y)},
          {std::min(box.high.x, limits.high.x), std::min(box.high.y, limits.high.y)}};
}

/// The half-plane normal . p >= least.
struct Side {
  Vec2 normal;
  double least;
  double inside(Vec2 p) const { return engine::dot(normal, p) - least; }
};

/// Sutherland and Hodgman, Comm. ACM 17 (1974) 32-42: one side at a time.
std::vector<Vec2> kept_by(const Side& side, const std::vector<Vec2>& outline) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double from = side.inside(a), to = side.inside(b);
    if (from >= 0.0) out.push_back(a);
    if ((from < 0.0) != (to < 0.0)) out.push_back(a + (from / (from - to)) * (b - a));
  }
  return out;
}

/// What of the terrain a picture of the bodies should show: not more than again their own size around.
constexpr double terrain_reach = 0.6;  // of the bodies' extent

/// Of ground that goes on downwards a strip is enough.
constexpr double ground_depth = 0.1;  // of the bodies' extent

std::vector<Vec2> without_the_deep(std::vector<Vec2> outline, double bottom, double depth) {
  const auto deep = std::ranges::partition(outline, [&](Vec2 p) { return p.y > bottom; });
  if (deep.empty() || deep.size() == outline.size()) return outline;
  outline.erase(deep.begin(), deep.end());
  Vec2 lowest = *std::ranges::min_element(outline, {}, &Vec2::y);
  lowest.y = std::max(bottom, lowest.y - depth);
  outline.push_back(lowest);
  return outline;
}

void include_terrain(Box& box, const ModelSheet& model) {
  const double extent = std::max(box.width(), box.height());
  const Box near = box.grown(terrain_reach * extent);
  for (const DrawnShape& terrain : model.terrains)
    for (const auto& outline : outlines(terrain, described_pose(terrain)))
      include(box, without_the_deep(clipped_outline(outline, near), near.low.y + 1e-6 * extent,
                                    ground_depth * extent));
}

Vec2 relative_position(const Trajectory& t, std::size_t step, std::size_t block) {
  const Vec2 ground = step < t.ground_displacement.size() ? t.ground_displacement[step] : Vec2{};
  return t.position(step, block) - ground;
}

}  // namespace

std::vector<Vec2> corners(const DrawnShape& shape, const Pose& pose) {
  std::vector<Vec2> out;
  for (const Vec2 p : shape.outline) out.push_back(pose.position + engine::rotated(p, pose.angle));
  if (!out.empty() || shape.radius <= 0.0) return out;
  for (int i = 0; i < circle_corners; ++i) {
    const double around = 2.0 * std::numbers::pi * i / circle_corners + pose.angle;
    out.push_back(pose.position + shape.radius * Vec2{std::cos(around), std::sin(around)});
  }
  return out;
}

std::vector<std::vector<Vec2>> outlines(const DrawnShape& shape, const Pose& pose) {
  if (shape.parts.empty()) return {corners(shape, pose)};
  std::vector<std::vector<Vec2>> out;
  for (const DrawnShape& part : shape.parts)
    out.push_back(
        corners(part, {pose.position + engine::rotated(part.position, pose.angle), pose.angle + part.angle}));
  return out;
}

std::vector<Vec2> clipped_outline(std::vector<Vec2> outline, const Box& box) {
  for (const Side& side : {Side{{1, 0}, box.low.x}, Side{{-1, 0}, -box.high.x}, Side{{0, 1}, box.low.y},
                           Side{{0, -1}, -box.high.y}})
    outline = kept_by(side, outline);
  return outline;
}

Pose described_pose(const DrawnShape& shape) {
  return {shape.position, shape.angle};
}

Pose pose_at(const Trajectory& t, std::size_t step, std::size_t block, double magnification) {
  const Vec2 now = relative_position(t, step, block), start = relative_position(t, 0, block);
  const double turn = t.angle(step, block) - t.angle(0, block);
  return {start + magnification * (now - start), t.angle(0, block) + magnification * turn};
}

double moved(const Trajectory& t, std::size_t step, std::size_t block) {
  return engine::norm(relative_position(t, step, block) - relative_position(t, 0, block));
}

Box model_bounds(const ModelSheet& model) {
  Box box = nothing;
  for (const DrawnShape& block : model.blocks)
    for (const auto& outline : outlines(block, described_pose(block))) include(box, outline);
  if (model.free_scene && box.low.x < box.high.x) include_terrain(box, model);
  return box.low.x < box.high.x ? box : Box{{-1.0, 0.0}, {1.0, 1.0}};
}

Box stage(const ModelSheet& model) {
  const Box own = model_bounds(model);
  Box box = own.grown(debris_reach * std::max(own.width(), own.height()));
  if (!model.free_scene) box.low.y = own.low.y;
  return box;
}

Box run_bounds(const RunResult& run, const std::vector<std::size_t>& steps, double magnification) {
  const Box model = model_bounds(run.model);
  Box box = model;
  for (const std::size_t step : steps) {
    for (std::size_t i = 0; i < std::min(run.trajectory.blocks, run.model.blocks.size()); ++i) {
      for (const auto& outline :
           outlines(run.model.blocks[i], pose_at(run.trajectory, step, i, magnification)))
        include(box, outline);
    }
  }
  return clipped(box, stage(run.model));
}

Box framed(Box bounds) {
  const double room = margin * std::max(bounds.width(), bounds.height());
  Box box = bounds.grown(room);
  box.low.y = bounds.low.y - std::max(room, least_ground * bounds.height());
  return box;
}

}  // namespace dougong::app
