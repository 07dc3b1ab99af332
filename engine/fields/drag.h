// Drag at the centroids: F = -(c + c2 |v|) v.
//
//   c   N s/m, Stokes's (slow, viscous)    c2  N s2/m2, Newton's: 1/2 rho C_d A (fast)
// The speed is that in the inertial frame: the air is at rest. What drag takes is booked as damping.
// Landau and Lifshitz, Fluid Mechanics, 2nd ed. (1987), paragraphs 20 and 45.
#pragma once

#include "engine/fields/field_terms.h"
#include "engine/frame.h"

namespace dougong::engine {

/// Throws std::invalid_argument, naming the body, for a coefficient that is negative or not finite.
DragField drag(const Scene& scene);

/// The force on the k-th body of the field (N).
inline Vec2 drag_force(const DragField& field, std::size_t k, Vec2 v) {
  return -(field.linear[k] + field.quadratic[k] * norm(v)) * v;
}

/// Adds the forces; returns the power that they take (W).
double add_drag_forces(const DragField& field, std::span<const Frame> frames, std::span<Vec2> forces);

/// What drag did since the last committed poses: the trapezoidal rule on its force along the displacement.
class DragWork {
 public:
  /// J, taken from the bodies since the call before; 0 at the first.
  double since_last(const DragField& field, std::span<const Frame> frames);

 private:
  struct Past {
    Vec2 force, position;  // N, m
  };
  std::vector<Past> past_;
};

/// The largest rate of decay of a speed, (c + 2 c2 |v|) / m (1/s).
double drag_rate(const DragField& field, std::span<const double> mass, std::span<const Frame> frames);

}  // namespace dougong::engine
