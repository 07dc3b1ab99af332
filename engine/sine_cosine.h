// Sine and cosine without the maths library, so that every machine and any number of lanes gives the same
// bits (lanes.h). Error below 1e-15 for |angle| < 1e5 rad.
#pragma once

#include "engine/lanes.h"

namespace dougong::engine {

template <class R>
struct SineCosine {
  R sine{}, cosine{};
};

/// Coefficients of the minimax polynomials on [-pi/4, pi/4] as in the public-domain fdlibm (Sun 1993).
template <class R>
[[gnu::always_inline]] inline R sine_near_zero(R x) {
  const R z = x * x;
  const R r = 8.33333333332248946124e-03 +
              z * (-1.98412698298579493134e-04 +
                   z * (2.75573137070700676789e-06 +
                        z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x + z * x * (-1.66666666666666324348e-01 + z * r);
}

template <class R>
[[gnu::always_inline]] inline R cosine_near_zero(R x) {
  const R z = x * x;
  const R r = z * (4.16666666666666019037e-02 +
                   z * (-1.38888888888741095749e-03 +
                        z * (2.48015872894767294178e-05 +
                             z * (-2.75573143513906633035e-07 +
                                  z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const R half = 0.5 * z, w = 1.0 - half;
  return w + (((1.0 - w) - half) + z * r);
}

/// To the nearest whole number, for |x| < 2^51.
template <class R>
[[gnu::always_inline]] inline R nearest_whole(R x) {
  constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: the sum has no bits left for a fraction
  return (x + shift) - shift;
}

template <class R>
[[gnu::always_inline]] inline SineCosine<R> sine_cosine(R angle) {
  constexpr double two_over_pi = 6.36619772367581382433e-01;
  // pi/2 in three parts of 33 bits (Cody and Waite 1980): k times a part is exact for |k| < 2^20.
  constexpr double half_pi_1 = 1.57079632673412561417e+00, half_pi_2 = 6.07710050630396597660e-11,
                   half_pi_3 = 2.02226624879595063154e-21;
  const R k = nearest_whole(angle * two_over_pi);
  const R x = ((angle - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
  const R s = sine_near_zero(x), c = cosine_near_zero(x);
  // The quadrant, k modulo 4, as 0, 1/4, 1/2 or -1/2, -1/4.
  const R quarter = 0.25 * k - nearest_whole(0.25 * k), one = R{} + 1.0;
  const R apart = magnitude(quarter), far = where_less(R{} + 0.375, apart, one, R{});  // 2
  const R odd = where_less(R{} + 0.125, apart, one - far, R{});                        // 1 or 3
  const R up = where_less(R{} + 0.125, quarter, odd, R{}), down = odd - up;            // 1; 3
  const R sine = where(odd, c, s), cosine = where(odd, s, c);
  return {where(greater(far, down), -sine, sine), where(greater(far, up), -cosine, cosine)};
}

}  // namespace dougong::engine
