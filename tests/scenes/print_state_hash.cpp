// Prints the state hash of a short scene with impacts, friction, discs and a shaken ground, for every
// integrator: the same lines are expected from every build.
#include <cstdio>

#include "tests/scenes/running.h"

namespace {

using namespace dougong;

engine::Scene falling_rubble() {
  engine::Scene s = scenes::scene(0.5, 1e8, 0.4);
  engine::Body disc = scenes::block(0.1, 0.1, {0.45, 1.45});
  disc.shape = engine::make_circle(0.12);
  disc.velocity = {-0.3, -0.5};
  s.bodies = {disc, scenes::block(0.25, 0.5, {0.0, 0.5}), scenes::block(0.4, 0.1, {0.2, 1.121}, 0.05),
              scenes::block(0.1, 0.1, {-0.15, 1.5}, 0.3), scenes::block(0.15, 0.1, {0.9, 0.25}, -0.7)};
  s.bodies[3].velocity = {0.5, -1.0};
  // A polynomial, not a sine: the maths library is not under test.
  s.terrains.push_back(
      scenes::ground(200.0, {}, 0.0,
                     scenes::horizontal_motion([](double t) { return 12.0 * t * (1.0 - t); },
                                               [](double t) { return t * t * (6.0 - 4.0 * t); },
                                               [](double t) { return t * t * t * (2.0 - t); })));
  return s;
}

}  // namespace

int main() {
  bool completed = true;
  for (const char* integrator : {"velocity-verlet", "symplectic-euler", "leapfrog", "rk3", "rk4",
                                 "dormand-prince", "rk8", "moreau-jean"}) {
    scenes::Running r(falling_rubble());
    const auto run = r.run(scenes::run_for(0.5, 2e-4, integrator));
    completed &= run.outcome == engine::Outcome::completed;
    std::printf("%s %s %s\n", integrator, engine::to_string(run.outcome).c_str(),
                engine::state_hash(r.state).c_str());
  }
  return completed ? 0 : 1;
}
