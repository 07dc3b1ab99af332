// A dry wall in running bond with open head joints: the wall S1 by which engines are compared.
#pragma once

#include <numbers>

#include "tests/scenes/blocks.h"

namespace dougong::scenes {

struct RunningBond {
  int courses = 40, bricks = 25;          // whole bricks in the even courses; the odd ones have two halves
  double length = 0.25, height = 0.0625;  // m
  double head_joint = 1e-3;               // m, open
  double density = 2000.0;                // kg/m3
  double friction = 0.6;
  double young_modulus = 6.3e7;  // Pa: the top settles by about 1 mm
  double damping_ratio = 0.3;
};

/// By 1 + 2 + ... + courses weights over the stiffness of a bed joint of a brick (m).
inline double settlement(const RunningBond& w, double g = 9.81) {
  const double weight = w.density * w.length * w.height * g,
               stiffness = w.young_modulus / w.height * w.length;
  return 0.5 * w.courses * (w.courses + 1) * weight / stiffness;
}

inline engine::Scene running_bond(const RunningBond& w,
                                  std::shared_ptr<const engine::PrescribedMotion> motion = nullptr) {
  engine::Scene s = scene(w.friction, w.young_modulus, w.damping_ratio);
  s.materials[0].density = w.density;
  const double pitch = w.length + w.head_joint;
  for (int course = 0; course < w.courses; ++course) {
    const double y = (course + 0.5) * w.height;
    const auto lay = [&](double x, double length) {
      s.bodies.push_back(block(0.5 * length, 0.5 * w.height, {x, y}));
    };
    const bool halves = course % 2 == 1;
    const double half = 0.5 * (w.length - w.head_joint);
    if (halves) lay(0.5 * half, half);
    for (int i = 0; i < w.bricks - (halves ? 1 : 0); ++i)
      lay(0.5 * w.length + (i + (halves ? 0.5 : 0.0)) * pitch, w.length);
    if (halves) lay((w.bricks - 0.5) * pitch + 0.5 * half, half);
  }
  s.terrains.push_back(ground(200.0, {}, 0.0, std::move(motion)));
  return s;
}

/// The ground's acceleration is amplitude sin(2 pi frequency t), from rest (m/s2, Hz).
inline std::shared_ptr<const engine::PrescribedMotion> sine_motion(double amplitude, double frequency) {
  const double w = 2.0 * std::numbers::pi * frequency;
  return horizontal_motion([=](double t) { return amplitude * std::sin(w * t); },
                           [=](double t) { return amplitude / w * (1.0 - std::cos(w * t)); },
                           [=](double t) { return amplitude / w * (t - std::sin(w * t) / w); });
}

}  // namespace dougong::scenes
