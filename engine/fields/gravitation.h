// Newton's gravitation between bodies: U = -G m_i m_j / sqrt(r^2 + softening^2).
//
//   G  gravitational constant, m3/(kg s2)    softening, m: Plummer's, keeps close pairs finite
// The law is that of points in space, of inverse square, though they move in a plane.
// Newton, Principia (1687), book III; Aarseth, Gravitational N-Body Simulations (2003), eq. 1.1 and 2.2.
#pragma once

#include "engine/fields/field_terms.h"

namespace dougong::engine {

inline PairField gravitation(const Fields& fields, std::span<const double> mass) {
  PairField field{"gravitation",
                  -fields.gravitational_constant,
                  fields.softening * fields.softening,
                  fields.opening_angle,
                  {},
                  {mass.begin(), mass.end()}};
  for (std::uint32_t i = 0; i < mass.size(); ++i) field.bodies.push_back(i);
  return field;
}

}  // namespace dougong::engine
