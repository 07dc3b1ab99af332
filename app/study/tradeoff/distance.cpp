#include "app/study/tradeoff/distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using structures::Trajectory;

constexpr std::array<std::string_view, 3> measures{"rms", "largest", "end"};

engine::Vec2 on_the_ground(const Trajectory& t, std::size_t step, std::size_t body) {
  return t.position(step, body) - t.ground_displacement[step];
}

// Between two poses of a body, each of its own run and output time.
double apart(const Yardstick& by, std::size_t body, const Trajectory& a, std::size_t step_a,
             const Trajectory& b, std::size_t step_b) {
  const engine::Vec2 way = on_the_ground(a, step_a, body) - on_the_ground(b, step_b, body);
  const double turn = by.gyration[body] * (a.angle(step_a, body) - b.angle(step_b, body));
  return std::hypot(way.x, way.y, turn);
}

std::size_t index_of(const engine::Model& model, const std::string& name) {
  const auto end = model.names.begin() + static_cast<std::ptrdiff_t>(model.body_count);
  const auto it = std::find(model.names.begin(), end, name);
  if (it != end) return static_cast<std::size_t>(it - model.names.begin());
  const std::string nearest = structures::nearest_name(name, {model.names.begin(), end});
  throw std::invalid_argument(fmt::format("there is no body \"{}\"{}", name,
                                          nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
}

}  // namespace

Measure measure_from(std::string_view word) {
  const auto it = std::ranges::find(measures, word);
  if (it != measures.end()) return static_cast<Measure>(it - measures.begin());
  throw std::invalid_argument(
      fmt::format("measure: expected one of {}, found \"{}\"", fmt::join(measures, ", "), word));
}

std::string_view to_string(Measure measure) {
  return measures[static_cast<std::size_t>(measure)];
}

Yardstick yardstick_for(const engine::Model& model, Measure measure, const std::vector<std::string>& bodies) {
  Yardstick by{measure, {}, std::vector<double>(model.body_count)};
  for (std::size_t i = 0; i < model.body_count; ++i)
    by.gyration[i] = std::sqrt(model.inertia[i] / model.mass[i]);
  for (const std::string& name : bodies) by.bodies.push_back(index_of(model, name));
  if (!by.bodies.empty()) return by;
  by.bodies.resize(model.body_count);
  std::iota(by.bodies.begin(), by.bodies.end(), std::size_t{0});
  return by;
}

double distance(const Yardstick& by, const Trajectory& a, const Trajectory& b) {
  const std::size_t steps = a.times.size();
  if (steps == 0 || steps != b.times.size() || a.blocks != b.blocks)
    return std::numeric_limits<double>::quiet_NaN();
  const std::size_t from = by.measure == Measure::end ? steps - 1 : 0;
  double sum = 0.0, largest = 0.0;
  for (std::size_t step = from; step < steps; ++step)
    for (const std::size_t body : by.bodies) {
      const double d = apart(by, body, a, step, b, step);
      if (!std::isfinite(d)) return d;
      sum += d * d, largest = std::max(largest, d);
    }
  if (by.measure == Measure::largest) return largest;
  return std::sqrt(sum / static_cast<double>((steps - from) * by.bodies.size()));
}

double largest_way(const Yardstick& by, const Trajectory& reference) {
  double largest = 0.0;
  for (std::size_t step = 0; step < reference.times.size(); ++step)
    for (const std::size_t body : by.bodies)
      largest = std::max(largest, apart(by, body, reference, step, reference, 0));
  return largest;
}

double greatest_speed(const Yardstick& by, const Trajectory& reference) {
  double greatest = 0.0;
  for (std::size_t step = 1; step < reference.times.size(); ++step)
    for (const std::size_t body : by.bodies)
      greatest = std::max(greatest, apart(by, body, reference, step, reference, step - 1) /
                                        (reference.times[step] - reference.times[step - 1]));
  return greatest;
}

}  // namespace dougong::app
