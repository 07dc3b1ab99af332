// What must hold of any scene, checked on one at random: it runs to its end, nothing is infinite, no energy
// comes from nothing, momentum stays where nothing outside acts, a second run has the same bits and a
// mirrored one the mirrored answer.
#pragma once

#include <string>
#include <vector>

#include "tests/scenes/audit.h"
#include "tests/scenes/mirror.h"
#include "tests/scenes/random_scene.h"

namespace dougong::scenes {

struct FuzzLimits {
  double energy_error = 0.05, energy_gained = 0.05;  // of the energy turned over
  double momentum = 1e-10;                           // of the sum without signs
  /// Of the mirror image, see mirrors(): m and rad, and a factor.
  double nudge = 1e-10, amplified = 100.0;
};

struct FuzzResult {
  Audit audit;
  double momentum_error = 0.0;     // isolated scenes
  double mirror_difference = 0.0;  // m, rad
  std::vector<std::string> faults;
};

/// The worst of many.
struct FuzzWorst {
  double energy_error = 0.0, energy_gained = 0.0, momentum_error = 0.0, deepest = 0.0;

  void note(const FuzzResult& f) {
    energy_error = std::max(energy_error, f.audit.energy_error);
    energy_gained = std::max(energy_gained, f.audit.energy_gained);
    momentum_error = std::max(momentum_error, f.momentum_error);
    deepest = std::max(deepest, f.audit.deepest);
  }
  std::string text() const {
    char line[200];
    std::snprintf(line, sizeof line,
                  "worst energy error %.2g, energy gained %.2g, momentum %.1g, overlap %.2g of the width",
                  energy_error, energy_gained, momentum_error, deepest);
    return line;
  }
};

namespace fuzz {

inline engine::DriveOptions options() {
  engine::DriveOptions options = run_for(1.0);
  options.step_fraction = 0.2;
  return options;
}

/// Linear and angular, over the same without signs.
inline double momentum_error(const Running& before, const Running& after) {
  double turnover = 0.0;
  for (std::size_t i = 0; i < before.bodies(); ++i) {
    const double speed = norm(before.velocity(i)), inertia = before.model.inertia[i];
    turnover +=
        before.model.mass[i] * speed * (1.0 + norm(before.position(i))) + inertia * std::abs(before.spin(i));
  }
  const double linear = norm(momentum(after) - momentum(before));
  const double angular = std::abs(angular_momentum(after, {}) - angular_momentum(before, {}));
  return turnover > 0.0 ? std::max(linear, angular) / turnover : 0.0;
}

/// Of places and angles, the second seen in a mirror if side = -1.
inline double difference(const Running& a, const Running& b, double side) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.bodies(); ++i)
    worst = std::max({worst, std::abs(a.position(i).x - side * b.position(i).x),
                      std::abs(a.position(i).y - b.position(i).y), std::abs(a.angle(i) - side * b.angle(i))});
  return worst;
}

}  // namespace fuzz

/// How far a scene whose bodies start a little elsewhere comes to lie from `run`.
inline double difference_when_nudged(const engine::Scene& scene, const Running& run, double nudge) {
  engine::Scene nudged = scene;
  for (std::size_t i = 0; i < nudged.bodies.size(); ++i) {
    nudged.bodies[i].position.x += (i % 2 == 0 ? 1.0 : -1.0) * nudge;
    nudged.bodies[i].angle += nudge;
  }
  Running other(nudged);
  other.run(fuzz::options());
  return fuzz::difference(run, other, 1.0);
}

/// A mirrored scene differs by rounding, which impacts amplify: by no more than `amplified` times what
/// nudging makes of it.
inline bool mirrors(const engine::Scene& scene, const Running& run, double difference,
                    const FuzzLimits& limits) {
  return difference <= limits.amplified * limits.nudge ||
         difference <= limits.amplified * difference_when_nudged(scene, run, limits.nudge);
}

inline FuzzResult fuzz_one(std::uint64_t seed, const FuzzLimits& limits = {}) {
  const RandomScene random = make_random_scene(seed);
  const engine::Scene& scene = random.scene;
  const Running start(scene);
  Running run = start, again = start, mirror(mirrored(scene));
  FuzzResult f;
  f.audit = audited(run, fuzz::options());
  again.run(fuzz::options()), mirror.run(fuzz::options());
  f.mirror_difference = fuzz::difference(run, mirror, -1.0);
  if (random.surroundings == Surroundings::space) f.momentum_error = fuzz::momentum_error(start, run);

  const auto require = [&f](bool holds, std::string fault) {
    if (!holds) f.faults.push_back(std::move(fault));
  };
  require(f.audit.completed(), to_string(f.audit.run.outcome) + ": " + f.audit.run.detail);
  require(f.audit.finite, "not finite");
  require(f.audit.energy_error <= limits.energy_error,
          "energy error " + std::to_string(f.audit.energy_error));
  require(f.audit.energy_gained <= limits.energy_gained,
          "energy gained " + std::to_string(f.audit.energy_gained));
  require(f.momentum_error <= limits.momentum, "momentum");
  require(state_hash(run.state) == state_hash(again.state), "other bits in a second run");
  require(mirrors(scene, run, f.mirror_difference, limits),
          "mirror image differs by " + std::to_string(f.mirror_difference));
  return f;
}

}  // namespace dougong::scenes
