// What every layout is put together from: one material, a ground, blocks that stand where they are
// told, and the parameters that say so.
#pragma once

#include <string>
#include <vector>

#include "structures/layouts/layout.h"

namespace dougong::structures {

/// Depth of the ground block (m). Terrain does not deform, so its depth changes nothing but the picture.
inline constexpr double ground_depth = 1.0;

/// The parameters of the blocks' material and their thickness, with these defaults.
std::vector<Parameter> material_parameters(const engine::Material& standard);
Parameter ground_width_parameter(double standard);
std::vector<Parameter> joined(std::vector<Parameter> first, const std::vector<Parameter>& second);

/// A building with its one material (of blocks and ground alike) and its ground, top at y = 0 and
/// centred at x = 0.
Building on_ground(const std::string& material_name, const ParameterValues& values);

/// Adds a rectangle by its centre line and its bottom edge; returns its index.
std::size_t add_rectangle(Building& building, const ParameterValues& values, const std::string& name,
                          double centre, double bottom, double width, double height);
/// Adds any convex outline given where it stands.
std::size_t add_outline(Building& building, const ParameterValues& values, const std::string& name,
                        const std::vector<engine::Vec2>& outline);

/// Throws LayoutError unless the blocks from left to right stand on the ground.
void require_on_ground(const ParameterValues& values, double left, double right);

}  // namespace dougong::structures
