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

/// How the length of contact goes with the corner's position along the edge. Where both ends are corners of
/// one body it does not.
struct BearingLength {
  double direction = 0.0;  // +1: grows with the position, -1: against it, 0: constant
  double end = 0.0;        // m, position at which the length is zero
  double nominal = 0.0;    // m
  double reference = 1.0;  // m, bearing length for which the point's stiffness stands
};

/// Of the stiffness for the reference length, and its slope along the edge (1/m).
struct BearingShare {
  double factor = 1.0, slope = 0.0;
};

constexpr double bearing_ramp = 10.0;  // so fast does a short contact reach the nominal length

inline double bearing_length(double length, double nominal) {
  return std::max({0.0, length, std::min(nominal, bearing_ramp * length)});
}

inline BearingShare bearing_share(const BearingLength& b, double position) {
  if (b.direction == 0.0) return {};
  const double length = b.direction * (position - b.end);
  if (length <= 0.0) return {0.0, 0.0};
  const double rise = bearing_ramp * length < b.nominal ? bearing_ramp : length < b.nominal ? 0.0 : 1.0;
  return {bearing_length(length, b.nominal) / b.reference, b.direction * rise / b.reference};
}

}  // namespace dougong::engine
