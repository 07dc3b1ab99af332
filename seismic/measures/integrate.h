// Velocity and displacement of an acceleration that is linear between samples: exact, nothing removed.
//
//   v[k+1] = v[k] + h (a[k] + a[k+1]) / 2
//   d[k+1] = d[k] + h v[k] + h^2 (2 a[k] + a[k+1]) / 6
//
//   a  acceleration  m/s2      v  velocity  m/s      d  displacement  m      h  step  s
#pragma once

#include <span>
#include <vector>

namespace dougong::seismic {

struct GroundHistory {
  double interval = 0.0;  // s
  std::vector<double> acceleration, velocity, displacement;
};

/// From rest (v = d = 0 at the first sample).
GroundHistory integrate(std::span<const double> acceleration, double interval);

}  // namespace dougong::seismic
