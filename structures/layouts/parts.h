// What layouts are put together from: materials, a ground, blocks that stand where they are told, what holds
// them together, and the parameters that say so.
//
// Bonded blocks stand for a continuous member. The face between two of them has springs, per area,
//
//   1/k_n = sum d_i/E_i - t/E + t/E_m       1/k_s = sum d_i/(kappa G_i) - t/(kappa G) + t/(kappa G_m)
//
//   d_i  from the centroid of block i to the face, along its normal   m       t  thickness of a joint, half
//   of it at the ground   m E, G = E/2(1+nu)  of the blocks   Pa     E_m, G_m  of the joint, with their nu Pa
//   kappa  -
//
// so that a chain of equal blocks of length l has k_n = E/l and k_s = kappa G/l, the ground l/2 (Kawai,
// Nucl. Eng. Des. 48 (1978) 207-229): it bends and shears as Timoshenko's beam up to order l2.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "structures/layouts/layout.h"

namespace dougong::structures {

/// Depth of the ground block (m). Terrain does not deform, so its depth changes nothing but the picture.
inline constexpr double ground_depth = 1.0;
/// Timoshenko's shear coefficient of a rectangle.
inline constexpr double rectangle_shear = 5.0 / 6.0;

/// The parameters of the blocks' material and their thickness, with these defaults. One of them chooses a
/// preset, which gives the others.
std::vector<Parameter> material_parameters(const engine::Material& standard, double thickness = 1.0);
Parameter ground_width_parameter(double standard);
std::vector<Parameter> joined(std::vector<Parameter> first, const std::vector<Parameter>& second);

/// A building with its one material (of blocks and ground alike) and its ground, top at y = 0 and
/// centred at x = 0.
Building on_ground(const std::string& material_name, const ParameterValues& values);
/// The preset of that name; it must exist.
engine::Material preset(std::string_view name);
/// Returns its index.
std::size_t add_material(Building& building, engine::Material material);

/// What a block is cut from.
struct Stock {
  std::size_t material = 0;
  double thickness = 1.0;  // m
  Stock(std::size_t material_index, double out_of_plane)
      : material(material_index), thickness(out_of_plane) {}
  /// The layout's own material and thickness.
  Stock(const ParameterValues& values) : thickness(values("thickness")) {}
};

/// Timber that is pressed across the grain, as in caps and brackets, where young_modulus is that along it:
/// its modulus is a parameter, by default the mean of class C24 (EN 338:2016, table 1).
Parameter bearing_modulus_parameter();
std::size_t add_bearing_timber(Building& building, const ParameterValues& values);

/// Adds a rectangle by its centre line and its bottom edge; returns its index.
std::size_t add_rectangle(Building& building, const Stock& stock, const std::string& name, double centre,
                          double bottom, double width, double height);
/// Adds any convex outline given where it stands.
std::size_t add_outline(Building& building, const Stock& stock, const std::string& name,
                        const std::vector<engine::Vec2>& outline);
/// Adds equal blocks in a row between the middles of a bar's two ends; named name.1, name.2 ...
std::vector<std::size_t> add_bar(Building& building, const Stock& stock, const std::string& name,
                                 engine::Vec2 from, engine::Vec2 to, double depth, std::size_t blocks);

/// What holds two faces together.
struct Connection {
  engine::Bond law;                // strengths, friction and damping; the rest is filled in
  double stiffness_factor = 1.0;   // on what the blocks' elasticity gives: cracked sections have less
  double shear_coefficient = 1.0;  // kappa
  double joint_thickness = 0.0;    // m, of mortar between the blocks
  double joint_modulus = 1.0;      // Pa
};

/// A strength (Pa) that a layout takes 0 for where there is none.
double endless_if_zero(double strength);

engine::Owner block(std::size_t index);
/// The first terrain.
engine::Owner ground();
/// Bonds the faces in which the two lie on or next to each other, over a common length of at least
/// `least` (m); false if there is none. The two must not lie further apart than `reach` (m).
bool connect(Building& building, engine::Owner a, engine::Owner b, const Connection& connection,
             double reach = 1e-6, double least = 1e-3);
/// Bonds each block to the one behind it.
void connect_chain(Building& building, const std::vector<std::size_t>& chain, const Connection& connection);
/// Bonds all of these blocks that lie on or next to each other, and to the ground.
void connect_touching(Building& building, const std::vector<std::size_t>& blocks,
                      const Connection& connection, double reach = 1e-6, double least = 1e-3);

struct Bounds {
  engine::Vec2 low{1e300, 1e300}, high{-1e300, -1e300};  // m
};
Bounds bounds_of(const Building& building, std::size_t block);
Bounds bounds_of(const Building& building, const std::vector<std::size_t>& blocks);
double mass_of(const Building& building, std::size_t block);  // kg

/// Joins b to a at a place of the scene (m) by a pin, weld or distance of that stiffness.
engine::Joint joint_at(const Building& building, const std::string& name, engine::JointKind kind,
                       engine::Owner a, engine::Owner b, engine::Vec2 at_a, engine::Vec2 at_b,
                       double stiffness);

/// Throws LayoutError unless the blocks from left to right stand on the ground.
void require_on_ground(const ParameterValues& values, double left, double right);
/// Throws LayoutError for `subject` unless good.
void require(bool good, const ParameterValues& values, const std::string& subject,
             const std::string& expected, Dimension dimension = Dimension::length);

}  // namespace dougong::structures
