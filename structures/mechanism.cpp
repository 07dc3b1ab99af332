#include "structures/mechanism.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace dougong::structures {
namespace {

using engine::Vec2;

struct JointPoint {
  Vec2 place;            // m, in the model's coordinates
  Vec2 normal;           // from a to b
  double opening = 0.0;  // m, by the motion
  double slip = 0.0;     // m
};
using Pair = std::pair<std::size_t, std::size_t>;
using Joints = std::map<Pair, std::vector<JointPoint>>;

class Look {
 public:
  Look(const engine::Model& model, const engine::State& standing, const std::vector<BlockMotion>& motions)
      : model_(model), motions_(motions), frames_(engine::frames_of(model, standing, true)) {
    for (const BlockMotion& motion : motions) measure_ = std::max(measure_, engine::norm(motion.translation));
    add_contacts(standing.contacts.points);
    for (std::size_t i = 0; i < model.bond_points.size(); ++i) add_bond(model.bond_points[i]);
  }

  Mechanism found(const MechanismOptions& options) const {
    Mechanism mechanism;
    if (measure_ <= 0.0) return mechanism;
    for (std::size_t i = 0; i < motions_.size(); ++i)
      if (way(i) >= options.moving * measure_) mechanism.moving.push_back(i);
    std::ranges::stable_sort(mechanism.moving, [&](auto a, auto b) { return way(a) > way(b); });
    for (const auto& [pair, points] : joints_) mechanism.joints.push_back(judged(pair, points));
    double greatest = 0.0;
    for (const MovingJoint& joint : mechanism.joints) greatest = std::max(greatest, size(joint));
    // What joins two blocks that stay is closed, though the elastic blocks give way a little everywhere.
    const double least = std::max(options.acting * greatest, 1e-3 * measure_);
    std::erase_if(mechanism.joints, [&](const MovingJoint& joint) { return size(joint) < least; });
    return mechanism;
  }

 private:
  double way(std::size_t block) const { return engine::norm(motions_[block].translation); }

  Vec2 moved(std::size_t owner, Vec2 arm) const {
    if (model_.is_terrain(static_cast<engine::Index>(owner))) return {};
    return motions_[owner].translation + motions_[owner].turn * engine::turned(arm);
  }

  void add(std::size_t a, std::size_t b, Vec2 arm_a, Vec2 arm_b, Vec2 normal) {
    if (b < a) std::swap(a, b), std::swap(arm_a, arm_b), normal = -normal;
    const Vec2 relative = moved(b, arm_b) - moved(a, arm_a);
    joints_[{a, b}].push_back({frames_[a].position() + arm_a, normal, dot(normal, relative),
                               dot(engine::turned(normal), relative)});
  }

  /// A point further apart than the motion could close is no joint.
  void add_contacts(const engine::ContactPoints& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const engine::PointGeometry g = engine::geometry_of(points, i, frames_);
      if (-g.overlap < near * measure_)
        add(points.edge_body[i], points.corner_body[i], g.arm_edge, g.arm_corner, g.normal);
    }
  }
  void add_bond(const engine::BondPoint& point) {
    const engine::BondGeometry g = engine::bond_geometry(point, frames_);
    add(point.a, point.b, g.arm_a, g.arm_b, g.normal);
  }

  static double size(const MovingJoint& joint) { return std::max(joint.opening, std::abs(joint.slip)); }

  MovingJoint judged(const Pair& pair, const std::vector<JointPoint>& points) const {
    const auto [least, most] = std::ranges::minmax_element(points, {}, &JointPoint::opening);
    MovingJoint joint{JointAction::hinge, pair.first, pair.second, least->place, {},
                      most->opening,      least->slip};
    joint.tangent = engine::turned(least->normal);
    if (std::abs(joint.slip) >= 0.5 * joint.opening)
      joint.action = JointAction::sliding;
    else if (least->opening > 0.5 * joint.opening)
      joint.action = JointAction::parting;
    if (joint.action != JointAction::hinge) joint.place = middle(points);
    joint.place += model_.origin;
    return joint;
  }
  static Vec2 middle(const std::vector<JointPoint>& points) {
    Vec2 sum;
    for (const JointPoint& point : points) sum += point.place;
    return (1.0 / static_cast<double>(points.size())) * sum;
  }

  static constexpr double near = 0.2;  // of the greatest translation

  const engine::Model& model_;
  const std::vector<BlockMotion>& motions_;
  std::vector<engine::Frame> frames_;
  double measure_ = 0.0;  // m
  Joints joints_;
};

}  // namespace

std::string to_string(JointAction action) {
  switch (action) {
    case JointAction::hinge:
      return "hinge";
    case JointAction::sliding:
      return "sliding";
    case JointAction::parting:
      return "parting";
  }
  return "";
}

Mechanism mechanism_of(const engine::Model& model, const engine::State& standing,
                       const std::vector<BlockMotion>& motions, const MechanismOptions& options) {
  if (motions.empty()) return {};  // nothing fell
  return Look(model, standing, motions).found(options);
}

}  // namespace dougong::structures
