// Where a picture looks: a box of the world, drawn to scale with equal axes.
//
// The camera is fixed to the moving ground: positions are relative to the ground's displacement at that
// moment, so the terrain stands still and what is seen of the blocks is their movement relative to it.
#pragma once

#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

struct Box {
  engine::Vec2 low, high;
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  bool holds(engine::Vec2 p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  double aspect() const { return width() / height(); }
  Box grown(double margin) const {
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
  }
};

struct Pose {
  engine::Vec2 position;
  double angle = 0.0;
};

/// Corners in the world, circles as 48-gons. Of a compound: empty.
std::vector<engine::Vec2> corners(const DrawnShape& shape, const Pose& pose);
/// The convex outlines that a shape is drawn as: one, or one for each part of a compound.
std::vector<std::vector<engine::Vec2>> outlines(const DrawnShape& shape, const Pose& pose);
/// What of a convex outline lies in the box: ground that reaches far beyond a picture.
std::vector<engine::Vec2> clipped_outline(std::vector<engine::Vec2> outline, const Box& box);
Pose described_pose(const DrawnShape& shape);
/// Relative to the ground, with the displacement since the first output magnified.
Pose pose_at(const structures::Trajectory& trajectory, std::size_t step, std::size_t block,
             double magnification);
/// Distance moved relative to the ground since the first output, m.
double moved(const structures::Trajectory& trajectory, std::size_t step, std::size_t block);

/// Around the blocks as described, and the near terrain of a free scene; a metre around the origin without
/// blocks.
Box model_bounds(const ModelSheet& model);
/// What a picture may show: up to 1.5 sizes around the blocks as described; of a building nothing below its
/// foot, where what slid off the ground's end falls for ever.
Box stage(const ModelSheet& model);
/// Around every block at these steps, debris included, within the stage.
Box run_bounds(const RunResult& run, const std::vector<std::size_t>& steps, double magnification);
/// With room around and a strip of ground below.
Box framed(Box bounds);

/// World to pixels, origin at the lower left.
struct Camera {
  Box box;
  double pixels_per_metre = 1.0;
  engine::Vec2 to_pixels(engine::Vec2 p) const { return pixels_per_metre * (p - box.low); }
};

}  // namespace dougong::app
