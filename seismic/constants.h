// Constants of the module.
#pragma once

#include <numbers>

namespace dougong::seismic {

/// Standard gravity (m/s2), CGPM 1901. A file in g is read with this unless the caller says otherwise.
inline constexpr double standard_gravity = 9.80665;

inline constexpr double two_pi = 2.0 * std::numbers::pi;

}  // namespace dougong::seismic
