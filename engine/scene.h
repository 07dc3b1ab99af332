// The description of a scene: plain data, before anything is computed. compile() makes it a Model.
//
// SI units and radians. Bodies have an out-of-plane thickness, so densities are kg/m3.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/joint.h"
#include "engine/material.h"
#include "engine/motion.h"
#include "engine/shape.h"

namespace dougong::engine {

inline constexpr double standard_gravity = 9.80665;  // m/s2

struct Body {
  std::string name;
  Shape shape;
  Vec2 position;                  // m, of the centroid
  double angle = 0.0;             // rad
  Vec2 velocity;                  // m/s
  double spin = 0.0;              // rad/s
  std::size_t material = 0;       // index into Scene::materials
  double thickness = 1.0;         // m, out of plane
  std::optional<double> mass;     // kg; instead of density x area x thickness
  std::optional<double> inertia;  // kg m2, about the centroid; instead of that of the shape with its mass
  double charge = 0.0;            // C
  double linear_drag = 0.0;       // N s/m, force -c v at the centroid
  double quadratic_drag = 0.0;    // N s2/m2, force -c |v| v
  Vec2 applied_force;             // N, at the centroid, times Fields::applied_factor
  bool collides = true;           // false: a point mass that fields move and nothing touches
};

struct Terrain {
  std::string name;
  Shape shape;
  Vec2 position;  // m, of the centroid, where the motion's displacement is zero
  double angle = 0.0;
  std::size_t material = 0;
  std::shared_ptr<const PrescribedMotion> motion;  // null: fixed
};

struct ContactOptions {
  /// Normal stiffness of every contact point (N/m) instead of the one that follows from the Young's
  /// moduli, the block heights and the contact length.
  std::optional<double> point_stiffness;
  /// Tangential over normal stiffness, instead of G/E = 1/(2(1+nu)).
  std::optional<double> tangential_ratio;
  /// Greatest damping ratio of a face that rests on another with both its ends (-); corners that land or rock
  /// have the damping ratio of their materials. 3 to 4 times the step (docs/theory/contact.md).
  double resting_damping_ratio = 0.3;
};

/// What bodies do to each other at a distance. A constant of zero leaves the field out.
struct Fields {
  double gravitational_constant = 0.0;  // m3/(kg s2): -G m_i m_j / sqrt(r2 + softening2) between all bodies
  double coulomb_constant = 0.0;        // N m2/C2: k q_i q_j / sqrt(r2 + softening2)
  double softening = 0.0;               // m
  /// Opening angle of the Barnes-Hut tree (-): a cell of width w at distance d counts as one when w < angle
  /// d.
  double opening_angle = 0.0;   // 0: direct sum
  Vec2 electric_field;          // V/m, uniform
  double applied_factor = 1.0;  // -, of the bodies' applied forces (fields/applied_force.h)
  double applied_relief = 0.0;  // 1/J, that the factor falls by as they do work; 0: dead loads
};

/// What two materials do where they touch, instead of the rule for any two: the smaller friction coefficient,
/// the mean damping ratio, the smaller rocking restitution of those given.
struct MaterialPair {
  std::size_t a = 0, b = 0;
  std::optional<double> friction_coefficient = std::nullopt, damping_ratio = std::nullopt,
                        rocking_restitution = std::nullopt;
};

struct Scene {
  std::vector<Material> materials{Material{}};
  std::vector<MaterialPair> material_pairs;
  std::vector<Body> bodies;
  std::vector<Terrain> terrains;
  std::vector<Joint> joints;
  std::vector<Bond> bonds;
  Fields fields;
  Vec2 gravity{0.0, -standard_gravity};  // m/s2
  ContactOptions contact;
};

}  // namespace dougong::engine
