// The length on which a contact of two faces bears, and the stiffness that follows it while they slide.
//
// The springs of a contact of length L (m) are as stiff as the length it bears on,
//     L_b = max(L, min(L_n, 10 L)),   0 where L < 0
// with the nominal length L_n of two corners that meet. A point whose stiffness changes with its position s
// along the edge has the potential V = 1/2 k(s) overlap^2 + 1/2 kt(s) slip^2: besides its springs' forces it
// pushes with -dV/ds along the edge, the way in which the contact gets shorter. So a length that comes or
// goes under load neither makes energy nor loses any.
#pragma once

#include <algorithm>

namespace dougong::engine {

/// The corner's own face reaches from it by `facing` along the other's edge, which has an end on either side:
/// what both have in common is the length of contact. Without facing it does not depend on the position.
struct BearingLength {
  double facing = 0.0, edge_length = 0.0;  // m
  double nominal = 0.0;                    // m
  double reference = 1.0;                  // m, bearing length for which the point's stiffness stands
};

/// Of the stiffness for the reference length, and its slope along the edge (1/m).
struct BearingShare {
  double factor = 1.0, slope = 0.0;
};

constexpr double bearing_ramp = 10.0;  // so fast does a short contact reach the nominal length

inline double bearing_length(double length, double nominal) {
  return std::max({0.0, length, std::min(nominal, bearing_ramp * length)});
}

/// Length of contact with the corner at `position` from the edge's start (m); negative beyond its ends.
inline double contact_length(const BearingLength& b, double position) {
  const double low = position + std::min(b.facing, 0.0), high = position + std::max(b.facing, 0.0);
  return std::min(high, b.edge_length) - std::max(low, 0.0);
}

inline double contact_length_slope(const BearingLength& b, double position) {
  const double low = position + std::min(b.facing, 0.0), high = position + std::max(b.facing, 0.0);
  return (high < b.edge_length ? 1.0 : 0.0) - (low > 0.0 ? 1.0 : 0.0);
}

inline BearingShare bearing_share(const BearingLength& b, double position) {
  if (b.facing == 0.0) return {};
  const double length = contact_length(b, position);
  if (length <= 0.0) return {0.0, 0.0};
  const double rise = bearing_ramp * length < b.nominal ? bearing_ramp : length < b.nominal ? 0.0 : 1.0;
  return {bearing_length(length, b.nominal) / b.reference,
          rise * contact_length_slope(b, position) / b.reference};
}

}  // namespace dougong::engine
