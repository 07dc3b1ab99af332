// The length on which a contact of two faces bears, and the stiffness that follows it while they slide.
//
// The springs of a contact of length L (m) are as stiff as the length it bears on,
//     L_b = max(L, min(L_n, 10 L)),   0 where L < 0
// with the nominal length L_n of two corners that meet. A point whose stiffness changes with its position s
// along the edge has the potential V = 1/2 k(s) overlap^2 + 1/2 kt(s) slip^2: besides its springs' forces it
// pushes with -dV/ds along the edge, the way in which the contact gets shorter. So a length that comes or
// goes under load neither makes energy nor loses any.
#pragma once

#include "engine/lanes.h"

namespace dougong::engine {

/// The corner's own face reaches from it by `facing` along the other's edge, which has an end on either side:
/// what both have in common is the length of contact. Without facing it does not depend on the position.
template <class R>
struct BearingLengthOf {
  R facing{}, edge_length{};    // m
  R nominal{};                  // m
  R per_reference = R{} + 1.0;  // 1/m, over the bearing length for which the point's stiffness stands
};
using BearingLength = BearingLengthOf<double>;

/// Of the stiffness for the reference length, and its slope along the edge (1/m).
template <class R>
struct BearingShareOf {
  R factor = R{} + 1.0, slope{};
};

constexpr double bearing_ramp = 10.0;  // so fast does a short contact reach the nominal length

template <class R>
[[gnu::always_inline]] inline R bearing_length(R length, R nominal) {
  return greater(greater(R{}, length), lesser(nominal, bearing_ramp * length));
}

/// Length of contact with the corner at `position` from the edge's start (m); negative beyond its ends.
template <class R>
[[gnu::always_inline]] inline R contact_length(const BearingLengthOf<R>& b, R position) {
  const R low = position + lesser(b.facing, R{}), high = position + greater(b.facing, R{});
  return lesser(high, b.edge_length) - greater(low, R{});
}

template <class R>
[[gnu::always_inline]] inline R contact_length_slope(const BearingLengthOf<R>& b, R position) {
  const R low = position + lesser(b.facing, R{}), high = position + greater(b.facing, R{}), one = R{} + 1.0;
  return where_less(high, b.edge_length, one, R{}) - where_positive(low, one, R{});
}

template <class R>
[[gnu::always_inline]] inline BearingShareOf<R> bearing_share(const BearingLengthOf<R>& b, R position) {
  const R length = contact_length(b, position), one = R{} + 1.0;
  const R rise = where_less(bearing_ramp * length, b.nominal, all_lanes<R>(bearing_ramp),
                            where_less(length, b.nominal, R{}, one));
  const R factor = bearing_length(length, b.nominal) * b.per_reference;
  const R slope = rise * contact_length_slope(b, position) * b.per_reference;
  const R faces = magnitude(b.facing);
  return {where_positive(faces, where_positive(length, factor, R{}), one),
          where_positive(faces, where_positive(length, slope, R{}), R{})};
}

}  // namespace dougong::engine
