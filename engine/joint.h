// What connects two bodies, or a body and the terrain: plain data of a scene.
//
// Joints never break. A bond holds two faces together by springs at two Gauss points of the face, so that
// it resists bending as a strip of elastic material would, and may yield, soften or break.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "engine/vec2.h"

namespace dougong::engine {

/// A body or a terrain of a scene, by its place in the list.
struct Owner {
  bool terrain = false;
  std::size_t index = 0;
};

enum class JointKind {
  pin,       // the two anchors coincide
  weld,      // and the angle between the bodies stays
  distance,  // the distance of the anchors stays
  spring     // a spring and dashpot along the line of the anchors
};

struct Joint {
  std::string name;
  JointKind kind = JointKind::pin;
  Owner a, b;
  Vec2 anchor_a, anchor_b;            // m, in the frames of a and b (from their centroids)
  double stiffness = 0.0;             // N/m; 0 for a spring that is a dashpot alone
  double rotational_stiffness = 0.0;  // N m/rad, weld
  std::optional<double> damping;      // N s/m; instead of damping_ratio
  double damping_ratio = 0.0;         // -, of the mass that the joint feels
  std::optional<double> rest_length;  // m, distance and spring; else that of the start
};

struct Bond {
  std::string name;
  Owner a, b;
  Vec2 start, end;  // m, ends of the bonded face where the scene describes it
  /// Stiffness per area (Pa/m), instead of 1/k = h_a/E_a + h_b/E_b + joint_thickness/joint_modulus.
  std::optional<double> normal_stiffness;
  std::optional<double> shear_stiffness;                              // Pa/m; else the normal one times G/E
  double tensile_strength = std::numeric_limits<double>::infinity();  // Pa
  double cohesion = std::numeric_limits<double>::infinity();  // Pa, shear strength without normal stress
  double friction_coefficient = 0.6;                          // -, of the bonded and of the broken face
  double fracture_energy = 0.0;                               // J/m2 in tension; 0: breaks at once
  double yield_strength = std::numeric_limits<double>::infinity();  // Pa, ductile, tension (reinforcement)
  /// Pa: a face without a crack closes plastically at it.
  double compressive_strength = std::numeric_limits<double>::infinity();
  double damping_ratio = 0.02;  // -, local
};

}  // namespace dougong::engine
