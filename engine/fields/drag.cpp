#include "engine/fields/drag.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dougong::engine {
namespace {

void require_not_negative(double value, const std::string& owner, const char* quantity) {
  if (!(value >= 0.0) || !std::isfinite(value))
    throw std::invalid_argument(owner + ": " + quantity + " must not be negative, found " +
                                std::to_string(value));
}

}  // namespace

DragField drag(const Scene& scene) {
  DragField field;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    require_not_negative(body.linear_drag, body.name, "linear drag");
    require_not_negative(body.quadratic_drag, body.name, "quadratic drag");
    if (body.linear_drag == 0.0 && body.quadratic_drag == 0.0) continue;
    field.bodies.push_back(i);
    field.linear.push_back(body.linear_drag);
    field.quadratic.push_back(body.quadratic_drag);
  }
  return field;
}

double add_drag_forces(const DragField& field, std::span<const Frame> frames, std::span<Vec2> forces) {
  double power = 0.0;
  for (std::size_t k = 0; k < field.bodies.size(); ++k) {
    const Vec2 v = frames[field.bodies[k]].velocity(), force = drag_force(field, k, v);
    forces[field.bodies[k]] += force;
    power -= dot(force, v);
  }
  return power;
}

double DragWork::since_last(const DragField& field, std::span<const Frame> frames) {
  const bool first = past_.empty();
  past_.resize(field.bodies.size());
  double work = 0.0;
  for (std::size_t k = 0; k < field.bodies.size(); ++k) {
    const Frame& frame = frames[field.bodies[k]];
    const Past now{drag_force(field, k, frame.velocity()), frame.position()};
    if (!first) work -= 0.5 * dot(past_[k].force + now.force, now.position - past_[k].position);
    past_[k] = now;
  }
  return work;
}

double drag_rate(const DragField& field, std::span<const double> mass, std::span<const Frame> frames) {
  double largest = 0.0;
  for (std::size_t k = 0; k < field.bodies.size(); ++k) {
    const std::uint32_t i = field.bodies[k];
    const double slope = field.linear[k] + 2.0 * field.quadratic[k] * norm(frames[i].velocity());
    largest = std::max(largest, slope / mass[i]);
  }
  return largest;
}

}  // namespace dougong::engine
