// Joints: springs and dashpots between two anchors, stiff ones for pins, welds and fixed distances.
//
//   u = p_b - p_a                                     between the anchors (m)
//   pin, weld:        F = k u + c u'                  weld also: M = k_r (theta - theta_0) + c_r theta'
//   distance, spring: F = (k (|u| - l0) + c |u|') u/|u|
// F acts on a, -F on b, both at the midpoint of the anchors, so that angular momentum is kept whatever the
// dashpot does. The springs have a potential. c = 2 xi sqrt(k m), m the mass that the joint feels along x and
// y on average, unless given; c_r = 2 xi sqrt(k_r I), 1/I = 1/I_a + 1/I_b, or c k_r/k where c is given.
#pragma once

#include <span>
#include <vector>

#include "engine/bonds/elements.h"
#include "engine/frame.h"

namespace dougong::engine {

/// What a joint did at the last committed poses.
struct JointPast {
  Vec2 separation, dashpot;                 // m, N
  double mean_angle = 0.0;                  // rad, of the two bodies
  double turn = 0.0, dashpot_moment = 0.0;  // rad, N m
};

struct JointTotals {
  double damping_power = 0.0;  // W
  double damping_work = 0.0;   // J, since the last commit
};

/// Throws std::invalid_argument, naming the joint, for owners that do not exist, the same owner twice, or
/// a stiffness, damping or length that is negative or not finite.
std::vector<JointElement> compile_joints(const Scene& scene, const Model& model);
std::vector<JointPast> initial_joints(const Model& model, std::span<const Frame> frames);

JointTotals add_joint_forces(const Model& model, std::vector<JointPast>& past, std::span<const Frame> frames,
                             bool commit, std::span<Vec2> forces, std::span<double> torques);
/// Stored in the springs (J).
double joint_energy(const Model& model, std::span<const Frame> frames);

/// How a joint stands: the anchors, and the force of its spring on a.
struct JointGeometry {
  Vec2 arm_a, arm_b;        // m, from the centroids to the anchors
  Vec2 separation;          // m, u
  Vec2 middle_a, middle_b;  // m, from the centroids to the midpoint
  double turn = 0.0;        // rad, from the rest angle
  double mean_angle = 0.0;  // rad, of the two bodies
  Vec2 spring;              // N
};
JointGeometry joint_geometry(const JointElement& joint, std::span<const Frame> frames);

}  // namespace dougong::engine
