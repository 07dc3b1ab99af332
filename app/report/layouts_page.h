// The layouts on one page that opens offline: the table, and of each one its drawing and its parameters.
#pragma once

#include <string>
#include <vector>

#include "app/study/run_result.h"

namespace dougong::app {

/// A layout as it stands, with its defaults.
struct LayoutEntry {
  ModelSheet model;
  std::string period;                                // of small vibrations, with its unit
  std::string counting;                              // what its storeys are
  std::vector<std::vector<std::string>> parameters;  // name, default, range, meaning
};

std::string layouts_page(const std::vector<LayoutEntry>& entries);

}  // namespace dougong::app
