// A building: blocks on a ground, and which block belongs to which storey.
//
// Levels are numbered from the ground up: L0 is the ground, L1..Ln the floors; storey Si lies between
// L(i-1) and Li. A block's level tag is where its displacement and mass count.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/scene.h"

namespace dougong::structures {

struct Storey {
  std::string name;                        // "S1"
  double base = 0.0;                       // m, elevation of the level below
  double height = 0.0;                     // m, original height h_i
  std::vector<std::size_t> level_blocks;   // blocks whose mean displacement is the level's
  std::vector<std::size_t> storey_blocks;  // every block of the storey, level blocks included
  bool is_base = false;                    // of isolators: it is displaced, and does not drift
  bool stands_on_ground = false;           // the first of a neighbour: not on the storey before it
};

struct Building {
  std::string layout;                             // name of the generator
  std::map<std::string, std::string> parameters;  // as printed, with units
  engine::Scene scene;                            // terrain 0 is the ground
  std::vector<Storey> storeys;                    // bottom up
};

}  // namespace dougong::structures
