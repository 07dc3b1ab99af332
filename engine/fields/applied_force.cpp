#include "engine/fields/applied_force.h"

#include <cmath>
#include <stdexcept>

namespace dougong::engine {
namespace {

void check_applied(const Scene& scene) {
  for (const Body& body : scene.bodies)
    if (!std::isfinite(body.applied_force.x) || !std::isfinite(body.applied_force.y))
      throw std::invalid_argument(body.name + ": applied force must be finite");
  if (!std::isfinite(scene.fields.applied_factor))
    throw std::invalid_argument("fields: the factor of applied forces must be finite");
  if (!(scene.fields.applied_relief >= 0.0) || !std::isfinite(scene.fields.applied_relief))
    throw std::invalid_argument("fields: the relief of applied forces must not be negative, found " +
                                std::to_string(scene.fields.applied_relief));
}

}  // namespace

AppliedForces applied_forces(const Scene& scene) {
  check_applied(scene);
  AppliedForces loads{scene.fields.applied_factor, scene.fields.applied_relief, {}, {}};
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].applied_force == Vec2{}) continue;
    loads.bodies.push_back(i);
    loads.force.push_back(scene.bodies[i].applied_force);
  }
  return loads;
}

double applied_work(const AppliedForces& loads, std::span<const Frame> frames) {
  double work = 0.0;
  for (std::size_t k = 0; k < loads.bodies.size(); ++k)
    work += dot(loads.force[k], frames[loads.bodies[k]].position());
  return work;
}

void add_applied_forces(const AppliedForces& loads, std::span<const Frame> frames, std::span<Vec2> forces) {
  if (loads.bodies.empty()) return;
  const double multiplier = applied_multiplier(loads, frames);
  for (std::size_t k = 0; k < loads.bodies.size(); ++k)
    forces[loads.bodies[k]] += multiplier * loads.force[k];
}

double applied_energy(const AppliedForces& loads, std::span<const Frame> frames) {
  const double work = applied_work(loads, frames);
  return work * (0.5 * loads.relief * work - loads.factor);
}

double applied_stiffness(const AppliedForces& loads, std::span<const double> mass) {
  double sum = 0.0;
  for (std::size_t k = 0; k < loads.bodies.size(); ++k)
    sum += dot(loads.force[k], loads.force[k]) / mass[loads.bodies[k]];
  return loads.relief * sum;
}

}  // namespace dougong::engine
