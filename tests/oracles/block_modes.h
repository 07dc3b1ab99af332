// How blocks that stand at rest start to move when the ground begins to accelerate by `a` to the right.
//
// One block, static = kinetic friction (Shenton, J. Engng Mech. 122 (1996) 690-693). With theta'' > 0 about
// the left corner and x'' of the centroid relative to the ground, R^2 = b^2 + h^2, a in the units of g:
//   rock         theta'' = 3 g (a h - b)/(4 R^2),  x'' = -h theta'';  needs m a + m x'' <= mu m (g + b
//   theta'') slide        theta'' = 0,  x'' = -(a - mu) g slide-rock   R^2/3 theta'' = (mu h - b)(g + b
//   theta''),  x'' = mu (g + b theta'') - a g
//
// Two blocks, no slip: theta_1 about the left corner of the lower, phi = theta_2 - theta_1 about that of the
// upper, and the moments of what the joints can push with:
//   M (theta_1'', phi'')' = Q + r,   theta_1'', phi'' >= 0,  r >= 0,  each r times its acceleration = 0
// M is positive definite, so there is one solution: the four cases are tried in turn.
#pragma once

#include <cmath>
#include <string>

namespace dougong::oracles {

struct FirstMotion {
  std::string mode;
  double spin_rate = 0.0, acceleration = 0.0;  // rad/s2, m/s2
};

struct ShakenBlock {
  double b, h, friction, g;

  FirstMotion start(double a) const {
    const double r2 = b * b + h * h, rate = 0.75 * g * (a * h - b) / r2;
    const bool tips = a * h > b;
    if (tips && a * g - h * rate <= friction * (g + b * rate)) return {"rock", rate, -h * rate};
    if (!tips && a <= friction) return {"rest", 0.0, 0.0};
    const double moment = friction * h - b, together = moment * g / (r2 / 3.0 - moment * b);
    if (moment <= 0.0) return {"slide", 0.0, -(a - friction) * g};
    return {"slide-rock", together, friction * (g + b * together) - a * g};
  }
};

struct TwoBlocks {
  double b1, h1, b2, h2, g;

  struct Rates {
    std::string mode;
    double lower = 0.0, upper = 0.0;  // rad/s2, absolute
  };

  Rates start(double a) const {
    const double m1 = b1 * h1, m2 = b2 * h2;  // over 4 density
    // Displacements of the centroids per unit of theta_1 and phi, from the pivots.
    const double x2 = b1, y2 = 2.0 * h1 + h2;
    const double m11 =
        m1 * 4.0 / 3.0 * (b1 * b1 + h1 * h1) + m2 * (x2 * x2 + y2 * y2) + m2 * (b2 * b2 + h2 * h2) / 3.0;
    const double m12 = m2 * (x2 * b2 + y2 * h2) + m2 * (b2 * b2 + h2 * h2) / 3.0;
    const double m22 = m2 * 4.0 / 3.0 * (b2 * b2 + h2 * h2);
    const double q1 = g * (m1 * (a * h1 - b1) + m2 * (a * y2 - x2)), q2 = g * m2 * (a * h2 - b2);
    if (q1 <= 0.0 && q2 <= 0.0) return {"rest"};
    const double together = q1 / m11, upper = q2 / m22;
    if (together > 0.0 && m12 * together >= q2) return {"monolith", together, together};
    if (upper > 0.0 && m12 * upper >= q1) return {"top", 0.0, upper};
    const double det = m11 * m22 - m12 * m12;
    const double lower = (m22 * q1 - m12 * q2) / det, phi = (m11 * q2 - m12 * q1) / det;
    return {"both", lower, lower + phi};
  }
};

}  // namespace dougong::oracles
