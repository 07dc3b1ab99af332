// Blocks drawn elsewhere: closed outlines from a DXF or CSV file, made a building by hand.
//
//   DXF   every closed polyline (POLYLINE or LWPOLYLINE) of straight segments is a block, or terrain on the
//   layer
//         "ground"; its layer is its storey. Other entities are counted and left out.
//   CSV   a heading "block,storey,x (m),y (m)", then a row a corner; x and y may be in mm, cm or m; "ground"
//   as the
//         storey is terrain.
//
// Storeys are ordered by their lowest points; one reaches from the highest point of the one before it to its
// own, and its level is the blocks that reach that. Without terrain the ground is level at the lowest point
// of all. Blocks are dry and of one material; bonds and other materials are added in the file that is
// written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/scene_description.h"

namespace dougong::app {

struct Outline {
  std::string name;                   // of the block; empty: by its storey and number
  std::string storey;                 // "ground" for terrain
  std::vector<engine::Vec2> corners;  // m
};

struct Outlines {
  std::vector<Outline> closed;
  std::size_t left_out = 0;  // entities of other kinds
};

/// `unit` in m of a DXF file's lengths. Throws ScenarioError, naming file and line or entity.
Outlines read_dxf_outlines(const std::filesystem::path& path, double unit);
Outlines read_csv_outlines(const std::filesystem::path& path);

/// Throws ScenarioError for outlines that are no blocks, or storeys that do not rise.
SceneDescription building_from(const Outlines& outlines, const std::string& source,
                               const std::string& material);

}  // namespace dougong::app
