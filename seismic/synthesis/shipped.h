// The bytes of every file in records/: the same call gives the same bytes, and a test compares them.
//
// Samples are rounded to what a recorder would resolve before they are written (1e-6 g in AT2, whole counts
// in K-NET), so that the last bits of the mathematics library do not reach the file.
#pragma once

#include <string>
#include <vector>

namespace dougong::seismic {

struct ShippedFile {
  std::string name;
  std::string bytes;
};

/// The recordings and catalogue.json.
std::vector<ShippedFile> shipped_files();

}  // namespace dougong::seismic
