// A spectrum that a standard, or the user, asks of a ground motion: elastic pseudo-acceleration by period.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace dougong::seismic {

struct DesignSpectrum {
  std::string name;              // "Eurocode 8, type 1, ground C, ag 2.5 m/s2, 5 %"
  std::string clause;            // "EN 1998-1:2004, 3.2.2.2"
  double shortest_period = 0.0;  // s
  double longest_period = std::numeric_limits<double>::infinity();  // s, beyond which it says nothing
  double damping_ratio = 0.05;
  std::function<double(double period)> acceleration;  // m/s2, within these periods

  /// m/s2. Throws InputError for a period that the spectrum does not cover.
  double at(double period) const;
  std::vector<double> at(std::span<const double> periods) const;
};

}  // namespace dougong::seismic
