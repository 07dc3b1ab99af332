#include "structures/joint_response.h"

#include <algorithm>
#include <cmath>

namespace dougong::structures {
namespace {

using engine::Vec2;

struct Placed {
  Vec2 position;       // m
  double angle = 0.0;  // rad
  Vec2 to_world(Vec2 local) const { return position + engine::rotated(local, angle); }
  Vec2 to_local(Vec2 world) const { return engine::rotated(world - position, -angle); }
};

Placed placed(const Trajectory& trajectory, std::size_t step, std::size_t body) {
  if (body >= trajectory.blocks) return {trajectory.ground_displacement[step], 0.0};
  return {trajectory.position(step, body), trajectory.angle(step, body)};
}

void raise(Peak& peak, double value, double time) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, time};
}

// A joint as its two blocks carry it.
class Face {
 public:
  Face(const FaceLoad& joint, const Trajectory& trajectory)
      : joint_(joint), trajectory_(trajectory), tangent_(direction(joint)) {
    const Placed a = placed(trajectory, 0, joint.a), b = placed(trajectory, 0, joint.b);
    const Vec2 ends[] = {joint.start, joint.end};
    for (const std::size_t k : {0u, 1u}) in_a_[k] = a.to_local(ends[k]), in_b_[k] = b.to_local(ends[k]);
    const Vec2 middle = 0.5 * (joint.start + joint.end);
    // Terrains have no middle of their own: b lies where a does not.
    const Vec2 inward = joint.a < trajectory.blocks ? middle - a.position : b.position - middle;
    side_ = dot(engine::turned(tangent_), inward) < 0.0 ? -1.0 : 1.0;
    turned_at_start_ = a.angle;
  }

  struct Gap {
    double opening, slip;  // m
  };
  Gap at(std::size_t step) const {
    const Placed a = placed(trajectory_, step, joint_.a), b = placed(trajectory_, step, joint_.b);
    const Vec2 t = engine::rotated(tangent_, a.angle - turned_at_start_), n = side_ * engine::turned(t);
    const Vec2 d0 = b.to_world(in_b_[0]) - a.to_world(in_a_[0]);
    const Vec2 d1 = b.to_world(in_b_[1]) - a.to_world(in_a_[1]);
    return {std::max({0.0, dot(n, d0), dot(n, d1)}), 0.5 * dot(t, d0 + d1)};
  }

 private:
  static Vec2 direction(const FaceLoad& joint) {
    const Vec2 along = joint.end - joint.start;
    const double length = norm(along);
    return length > 0.0 ? (1.0 / length) * along : Vec2{1.0, 0.0};
  }

  const FaceLoad& joint_;
  const Trajectory& trajectory_;
  Vec2 tangent_, in_a_[2], in_b_[2];
  double side_ = 1.0, turned_at_start_ = 0.0;
};

// The last output time at which every block stands, for each block: the number of times behind it.
std::vector<std::size_t> steps_with(const Trajectory& trajectory, const std::vector<BlockLoss>& losses) {
  std::vector<std::size_t> steps(trajectory.blocks, trajectory.times.size());
  for (const BlockLoss& loss : losses) {
    const auto lost = std::ranges::lower_bound(trajectory.times, loss.time);
    steps[loss.block] = std::max<std::size_t>(1, static_cast<std::size_t>(lost - trajectory.times.begin()));
  }
  return steps;
}

JointMotion motion_of(const Face& face, const Trajectory& trajectory, std::size_t steps, bool to_the_end) {
  JointMotion motion;
  const double last = trajectory.times[steps - 1], window = to_the_end ? residual_window : 0.0;
  std::size_t counted = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    const Face::Gap gap = face.at(step);
    const double time = trajectory.times[step];
    raise(motion.opening, gap.opening, time), raise(motion.slip, gap.slip, time);
    if (time < last - window) continue;
    motion.residual_opening += gap.opening, motion.residual_slip += gap.slip, ++counted;
  }
  const double share = 1.0 / static_cast<double>(counted);
  motion.residual_opening *= share, motion.residual_slip *= share;
  return motion;
}

}  // namespace

std::vector<JointMotion> joint_motions(const std::vector<FaceLoad>& joints, const Trajectory& trajectory,
                                       const std::vector<BlockLoss>& losses) {
  if (trajectory.times.empty()) return std::vector<JointMotion>(joints.size());
  const std::vector<std::size_t> standing = steps_with(trajectory, losses);
  const auto steps_of = [&](std::size_t body) {
    return body < standing.size() ? standing[body] : trajectory.times.size();
  };
  std::vector<JointMotion> motions;
  for (const FaceLoad& joint : joints) {
    const std::size_t steps = std::min(steps_of(joint.a), steps_of(joint.b));
    motions.push_back(
        motion_of(Face(joint, trajectory), trajectory, steps, steps == trajectory.times.size()));
  }
  return motions;
}

JointForceRecorder::JointForceRecorder(std::vector<FaceLoad> joints, const engine::Model& model,
                                       const engine::State& rest)
    : joints_(std::move(joints)), forces_(joints_.size()), sums_(joints_.size()) {
  const auto frames = engine::frames_of(model, rest, true);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const FaceLoad& joint = joints_[k];
    middle_.push_back(frames[joint.a].to_local(0.5 * (joint.start + joint.end) - model.origin));
    of_blocks_[{joint.a, joint.b}].push_back(k);
    if (joint.bonded) of_bond_[joint.bond] = k;
  }
}

const std::size_t* JointForceRecorder::joint_of(const FaceLoad& face, const engine::Model& model,
                                                std::span<const engine::Frame> frames) const {
  if (face.bonded) {
    const auto found = of_bond_.find(face.bond);
    return found == of_bond_.end() ? nullptr : &found->second;
  }
  const auto found = of_blocks_.find({face.a, face.b});
  if (found == of_blocks_.end()) return nullptr;
  const Vec2 middle = frames[face.a].to_local(0.5 * (face.start + face.end) - model.origin);
  return &*std::ranges::min_element(found->second, {},
                                    [&](std::size_t k) { return norm(middle_[k] - middle); });
}

void JointForceRecorder::note(const engine::Model& model, const engine::State& state,
                              std::span<const engine::Frame> frames) {
  std::ranges::fill(sums_, Sum{});
  for (const FaceLoad& face : face_loads(model, state, frames)) {
    const std::size_t* joint = joint_of(face, model, frames);
    if (joint) sums_[*joint].normal += face.normal, sums_[*joint].shear += face.shear;
  }
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    raise(forces_[k].compression, std::max(0.0, sums_[k].normal), state.time);
    raise(forces_[k].tension, std::max(0.0, -sums_[k].normal), state.time);
    raise(forces_[k].shear, sums_[k].shear, state.time);
  }
}

}  // namespace dougong::structures
