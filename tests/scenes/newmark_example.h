// Comparison C07: a single-degree system under a half-sine force, linear and elastoplastic.
//
//   m 0.2533 kip s2/in, k 10 kip/in, damping 5 %, p = 10 sin(pi t/0.6) kip to 0.6 s; yields at 0.75 in
// Inches are read as metres, and mass, stiffness and force are ten thousand times as large. Chopra, Dynamics
// of Structures (2012), examples 5.3 to 5.6.
#pragma once

#include <limits>

#include "tests/scenes/running.h"
#include "tests/scenes/shear_building.h"

namespace dougong::scenes {

struct NewmarkExample {
  static constexpr double mass = 2533.0, stiffness = 1e5, force = 1e5, end = 0.6;
  double yield = std::numeric_limits<double>::infinity();

  std::vector<oracles::ChainLevel> level() const {
    return {{.mass = mass,
             .stiffness = stiffness,
             .yield = yield,
             .hardening = std::isfinite(yield) ? 1e-6 : 0.0,
             .drag = 0.1 * std::sqrt(stiffness / mass) * mass}};
  }

  /// The force as the inertia of a ground that moves: a = -p/m.
  static std::shared_ptr<const engine::PrescribedMotion> motion() {
    const double a0 = -force / mass, q = std::numbers::pi / end;
    const auto v = [=](double t) { return a0 / q * (1.0 - std::cos(q * std::min(t, end))); };
    return horizontal_motion([=](double t) { return t <= end ? a0 * std::sin(q * t) : 0.0; }, v,
                             [=](double t) {
                               const double s = std::min(t, end);
                               return a0 / q * (s - std::sin(q * s) / q) + (t - s) * v(end);
                             });
  }

  /// Displacements at equal times up to 1 s, the first at 0.
  std::vector<double> displacements(const std::string& integrator, double step_fraction, int outputs) const {
    const auto ground = motion();
    Running r(shear_building_scene(level(), ground));
    engine::DriveOptions options = run_for(1.0, 1.0 / outputs, integrator);
    options.step_fraction = step_fraction;
    std::vector<double> u;
    r.run(options, [&](const engine::Sample& sample) {
      u.push_back(r.position().x - ground->at(sample.state.time).displacement.x);
      return engine::Wish::go_on;
    });
    return u;
  }
};

inline const std::vector<double> newmark_linear{0.0328, 0.2332, 0.6487, 1.1605,  1.5242,
                                                1.4814, 0.9245, 0.0593, -0.7752, -1.2718};
inline const std::vector<double> newmark_plastic{0.0328, 0.2332, 0.6487, 1.1778, 1.7112,
                                                 2.1113, 2.2324, 2.0660, 1.6942, 1.2671};

}  // namespace dougong::scenes
