#include "engine/bonds/joints.h"

#include <cmath>
#include <stdexcept>

#include "engine/bonds/owners.h"

namespace dougong::engine {
namespace {

void require(bool good, const Joint& joint, const char* what) {
  if (!good) throw std::invalid_argument(joint.name + ": " + what);
}

bool is_size(double value) {
  return value >= 0.0 && std::isfinite(value);
}

void check(const Joint& joint) {
  const bool dashpot = joint.kind == JointKind::spring && joint.damping && joint.stiffness == 0.0;
  require((joint.stiffness > 0.0 || dashpot) && std::isfinite(joint.stiffness), joint,
          "stiffness must be positive");
  require(is_size(joint.rotational_stiffness), joint, "rotational stiffness must not be negative");
  require(joint.kind != JointKind::weld || joint.rotational_stiffness > 0.0, joint,
          "a weld needs a rotational stiffness");
  require(is_size(joint.damping_ratio), joint, "damping ratio must not be negative");
  require(!joint.damping || is_size(*joint.damping), joint, "damping must not be negative");
  require(!joint.rest_length || is_size(*joint.rest_length), joint, "rest length must not be negative");
}

// Mean over all directions of the mass felt at the anchors: arms turn a force into spin along one of two
// axes.
double felt_mass(const JointElement& j, const Model& model) {
  const double inverse = 1.0 / model.mass[j.a] + 1.0 / model.mass[j.b] +
                         0.5 * dot(j.anchor_a, j.anchor_a) / model.inertia[j.a] +
                         0.5 * dot(j.anchor_b, j.anchor_b) / model.inertia[j.b];
  return 1.0 / inverse;
}

double felt_inertia(const JointElement& j, const Model& model) {
  return 1.0 / (1.0 / model.inertia[j.a] + 1.0 / model.inertia[j.b]);
}

// A dashpot that is given acts on a weld's turning as on its anchors: c_r/k_r = c/k, as of a face whose
// springs and dashpots stand side by side.
void stiffen_turning(const Joint& joint, const Model& model, JointElement& j) {
  j.rotational_stiffness = joint.rotational_stiffness;
  j.rotational_damping =
      joint.damping ? *joint.damping * j.rotational_stiffness / j.stiffness
                    : 2.0 * joint.damping_ratio * std::sqrt(j.rotational_stiffness * felt_inertia(j, model));
}

JointElement compile_joint(const Joint& joint, const Model& model, std::span<const Frame> frames) {
  check(joint);
  JointElement j;
  j.kind = joint.kind;
  j.a = index_of(joint.a, model, joint.name), j.b = index_of(joint.b, model, joint.name);
  require(j.a != j.b, joint, "connects a body with itself");
  require(!model.is_terrain(j.a) || !model.is_terrain(j.b), joint, "connects two terrains");
  j.anchor_a = joint.anchor_a, j.anchor_b = joint.anchor_b;
  j.stiffness = joint.stiffness;
  j.damping =
      joint.damping.value_or(2.0 * joint.damping_ratio * std::sqrt(j.stiffness * felt_mass(j, model)));
  if (j.kind == JointKind::weld) stiffen_turning(joint, model, j);
  j.rest_angle = frames[j.b].angle - frames[j.a].angle;
  const double length = norm(frames[j.b].to_world(j.anchor_b) - frames[j.a].to_world(j.anchor_a));
  j.rest_length = joint.rest_length.value_or(length);
  return j;
}

Vec2 spring_force(const JointElement& j, Vec2 u) {
  if (!j.axial()) return j.stiffness * u;
  const double length = norm(u);
  return length > 0.0 ? (j.stiffness * (1.0 - j.rest_length / length)) * u : Vec2{};
}

Vec2 dashpot_force(const JointElement& j, Vec2 u, Vec2 rate) {
  if (!j.axial()) return j.damping * rate;
  const double squared = dot(u, u);
  return squared > 0.0 ? (j.damping * dot(u, rate) / squared) * u : Vec2{};
}

Vec2 rate_at_middle(const JointElement& j, const JointGeometry& g, std::span<const Frame> frames) {
  const Frame &a = frames[j.a], &b = frames[j.b];
  return b.velocity() - a.velocity() + b.spin * turned(g.middle_b) - a.spin * turned(g.middle_a);
}

// The dashpot feels the separation as seen by an observer who turns with the mean of both bodies.
void commit_joint(const JointGeometry& g, Vec2 dashpot, double moment, JointPast& past, JointTotals& totals) {
  const Vec2 mean = 0.5 * (g.separation + past.separation);
  const Vec2 moved = g.separation - past.separation - (g.mean_angle - past.mean_angle) * turned(mean);
  totals.damping_work +=
      0.5 * dot(past.dashpot + dashpot, moved) + 0.5 * (past.dashpot_moment + moment) * (g.turn - past.turn);
  past = {g.separation, dashpot, g.mean_angle, g.turn, moment};
}

}  // namespace

std::vector<JointElement> compile_joints(const Scene& scene, const Model& model) {
  std::vector<JointElement> joints;
  if (scene.joints.empty()) return joints;
  const std::vector<Frame> frames = described_frames(scene, model);
  for (const Joint& joint : scene.joints) joints.push_back(compile_joint(joint, model, frames));
  return joints;
}

std::vector<JointPast> initial_joints(const Model& model, std::span<const Frame> frames) {
  std::vector<JointPast> past;
  for (const JointElement& joint : model.joints) {
    const JointGeometry g = joint_geometry(joint, frames);
    past.push_back({g.separation, {}, g.mean_angle, g.turn, 0.0});
  }
  return past;
}

JointGeometry joint_geometry(const JointElement& j, std::span<const Frame> frames) {
  const Frame &a = frames[j.a], &b = frames[j.b];
  JointGeometry g;
  g.arm_a = a.turned_to_world(j.anchor_a), g.arm_b = b.turned_to_world(j.anchor_b);
  const Vec2 between = b.position() - a.position();
  g.separation = between + g.arm_b - g.arm_a;
  g.middle_a = g.arm_a + 0.5 * g.separation;
  g.middle_b = g.arm_b - 0.5 * g.separation;
  g.turn = b.angle - a.angle - j.rest_angle;
  g.mean_angle = 0.5 * (a.angle + b.angle);
  g.spring = spring_force(j, g.separation);
  return g;
}

JointTotals add_joint_forces(const Model& model, std::vector<JointPast>& past, std::span<const Frame> frames,
                             bool commit, std::span<Vec2> forces, std::span<double> torques) {
  JointTotals totals;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const JointElement& j = model.joints[i];
    const JointGeometry g = joint_geometry(j, frames);
    const Vec2 rate = rate_at_middle(j, g, frames);
    const Vec2 dashpot = dashpot_force(j, g.separation, rate), force = g.spring + dashpot;
    const double turning = frames[j.b].spin - frames[j.a].spin;
    const double dashpot_moment = j.rotational_damping * turning;
    const double moment = j.rotational_stiffness * g.turn + dashpot_moment;
    forces[j.a] += force, forces[j.b] -= force;
    torques[j.a] += cross(g.middle_a, force) + moment;
    torques[j.b] -= cross(g.middle_b, force) + moment;
    totals.damping_power += dot(dashpot, rate) + dashpot_moment * turning;
    if (commit) commit_joint(g, dashpot, dashpot_moment, past[i], totals);
  }
  return totals;
}

double joint_energy(const Model& model, std::span<const Frame> frames) {
  double energy = 0.0;
  for (const JointElement& j : model.joints) {
    const JointGeometry g = joint_geometry(j, frames);
    const double stretch = j.axial() ? norm(g.separation) - j.rest_length : norm(g.separation);
    energy += 0.5 * j.stiffness * stretch * stretch + 0.5 * j.rotational_stiffness * g.turn * g.turn;
  }
  return energy;
}

}  // namespace dougong::engine
