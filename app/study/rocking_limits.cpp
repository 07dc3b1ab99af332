#include "app/study/rocking_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

// As the contact law takes it: the lighter of two rocks on the other, which stands still.
engine::RockingImpact rocking_impact(const engine::Model& model, std::span<const engine::Frame> frames,
                                     const engine::ContactPoints& points, std::size_t i) {
  const engine::Index corner = points.corner_body[i], edge = points.edge_body[i];
  const engine::Index rocks = model.mass[corner] <= model.mass[edge] ? corner : edge;
  const engine::PointGeometry g = engine::geometry_of(points, i, frames);
  const engine::Vec2 place = frames[edge].position() + g.arm_edge;
  return {model.mass[rocks], model.inertia[rocks], 0.5 * points.rocking[i].length,
          std::abs(engine::dot(g.normal, frames[rocks].position() - place)), points.stiffness(i)};
}

}  // namespace

std::vector<std::string> RockingLimits::look(const engine::Model& model, const engine::State& state) {
  constexpr double missed = 0.005;
  constexpr std::size_t most = 5;
  std::vector<std::string> findings;
  const engine::ContactPoints& points = state.contacts.points;
  if (points.rocking.empty() || said_ > most) return findings;
  const auto frames = engine::frames_of(model, state);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const engine::RockingDashpot& dashpot = points.rocking[i];
    const auto [a, b] = std::minmax(points.corner_body[i], points.edge_body[i]);
    if (!dashpot.acts() || !seen_.insert({a, b}).second) continue;
    const double asked = *model.rule(a, b).rocking_restitution;
    const double reached = engine::velocity_ratio(rocking_impact(model, frames, points, i),
                                                  {dashpot.couple, std::abs(dashpot.inset)});
    if (std::abs(reached - asked) <= missed) continue;
    if (said_++ == most)
      return findings.emplace_back("other faces miss their rocking restitution too"), findings;
    findings.push_back(
        fmt::format("{} and {}: a rocking restitution of {} is out of the contact law's reach, which keeps "
                    "{:.3g} of the spin",
                    model.names[a], model.names[b], asked, reached));
  }
  return findings;
}

}  // namespace dougong::app
