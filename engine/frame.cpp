#include "engine/frame.h"

namespace dougong::engine {
namespace {

// pi/2 in three parts of 33 bits (Cody and Waite 1980): k times a part is exact for |k| < 2^20.
constexpr double two_over_pi = 6.36619772367581382433e-01;
constexpr double half_pi_1 = 1.57079632673412561417e+00;
constexpr double half_pi_2 = 6.07710050630396597660e-11;
constexpr double half_pi_3 = 2.02226624879595063154e-21;

// Minimax polynomials on [-pi/4, pi/4]; coefficients as in the public-domain fdlibm (Sun 1993).
double sine_kernel(double x) {
  const double z = x * x;
  const double r = 8.33333333332248946124e-03 +
                   z * (-1.98412698298579493134e-04 +
                        z * (2.75573137070700676789e-06 +
                             z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x + z * x * (-1.66666666666666324348e-01 + z * r);
}

double cosine_kernel(double x) {
  const double z = x * x;
  const double r = z * (4.16666666666666019037e-02 +
                        z * (-1.38888888888741095749e-03 +
                             z * (2.48015872894767294178e-05 +
                                  z * (-2.75573143513906633035e-07 +
                                       z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z, w = 1.0 - half;
  return w + (((1.0 - w) - half) + z * r);
}

}  // namespace

void sine_cosine(double angle, double& sine, double& cosine) {
  const double k = std::floor(angle * two_over_pi + 0.5);
  const double x = ((angle - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
  const double s = sine_kernel(x), c = cosine_kernel(x);
  switch (static_cast<long long>(k) & 3) {
    case 0:
      sine = s, cosine = c;
      break;
    case 1:
      sine = c, cosine = -s;
      break;
    case 2:
      sine = -s, cosine = -c;
      break;
    default:
      sine = -c, cosine = s;
      break;
  }
}

void place_bodies(const Model& model, std::span<const double> q, std::span<const double> v,
                  std::span<Frame> frames) {
  const std::size_t n = model.body_count;
  for (std::size_t i = 0; i < n; ++i) {
    Frame& f = frames[i];
    f.x = q[i], f.y = q[n + i], f.angle = q[2 * n + i];
    f.vx = v[i], f.vy = v[n + i], f.spin = v[2 * n + i];
    sine_cosine(f.angle, f.s, f.c);
  }
}

void place_terrains(const Model& model, double t, bool held_still, std::span<Frame> frames) {
  for (std::size_t j = 0; j < model.terrain_count; ++j) {
    MotionSample motion;
    if (model.motions[j]) motion = model.motions[j]->at(held_still ? 0.0 : t);
    if (held_still) motion.velocity = {};
    Frame& f = frames[model.body_count + j];
    const Vec2 p = model.terrain_position[j] + motion.displacement;
    f.x = p.x, f.y = p.y, f.angle = model.terrain_angle[j];
    f.vx = motion.velocity.x, f.vy = motion.velocity.y, f.spin = 0.0;
    sine_cosine(f.angle, f.s, f.c);
  }
}

}  // namespace dougong::engine
