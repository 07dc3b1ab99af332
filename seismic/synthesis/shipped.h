// The bytes of every file in records/: the same call gives the same bytes, and a test compares them.
//
// Samples are rounded to what a recorder would resolve, 1e-6 g, before they are written, so that the last
// bits of the mathematics library do not reach the file. Wenchuan and Tohoku are written in the formats of
// the three networks that students meet (AT2, K-NET, CSMNC), the others in AT2: `dougong record convert`
// writes the rest.
#pragma once

#include <string>
#include <vector>

#include "seismic/record.h"
#include "seismic/synthesis/scenario.h"

namespace dougong::seismic {

struct ShippedFile {
  std::string name;
  std::string bytes;
};

/// East, north and up, as the files of every format hold them.
std::vector<Record> shipped_motion(const Scenario& scenario);

/// The recordings and catalogue.json.
std::vector<ShippedFile> shipped_files();

}  // namespace dougong::seismic
