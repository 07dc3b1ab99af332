#include "engine/stability.h"

#include <algorithm>
#include <cmath>

#include "engine/fields/fields.h"

namespace dougong::engine {
namespace {

using Row = StabilityRows::Row;
using Block = StabilityRows::Block;

Row negative(const Row& row) {
  return {-row[0], -row[1], -row[2]};
}

double row_sum(const Row& row) {
  return std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]);
}

double largest_row(const Block& own, const Row& others) {
  double result = 0.0;
  for (std::size_t r = 0; r < 3; ++r) result = std::max(result, row_sum(own[r]) + others[r]);
  return result;
}

}  // namespace

// A spring and dashpot between two bodies along one direction, at arms from their centroids.
struct StabilityRows::Strut {
  Index a, b;
  Vec2 direction, arm_a, arm_b;
  double stiffness, damping;
};

// What connects one body to one other: blocks of K and C in its own columns and in the other's.
class StabilityRows::Coupling {
 public:
  void add(double stiffness, double damping, const Row& on_this, const Row& on_other) {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const double own = on_this[r] * on_this[c], across = on_this[r] * on_other[c];
        own_stiffness_[r][c] += stiffness * own, own_damping_[r][c] += damping * own;
        stiffness_[r][c] += stiffness * across, damping_[r][c] += damping * across;
      }
  }
  void add_to(BodyRows& rows) const {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        rows.stiffness[r][c] += own_stiffness_[r][c];
        rows.damping[r][c] += own_damping_[r][c];
      }
      rows.other_stiffness[r] += row_sum(stiffness_[r]);
      rows.other_damping[r] += row_sum(damping_[r]);
    }
  }

 private:
  Block own_stiffness_{}, own_damping_{}, stiffness_{}, damping_{};
};

StabilityRows::StabilityRows(const Model& model)
    : bodies_(model.body_count),
      root_mass_(model.size(), 0.0),
      root_inertia_(model.size(), 0.0),
      rows_(model.body_count) {
  for (std::size_t i = 0; i < bodies_; ++i) {
    root_mass_[i] = 1.0 / std::sqrt(model.mass[i]);
    root_inertia_[i] = 1.0 / std::sqrt(model.inertia[i]);
  }
}

// A direction's row of the Jacobian on one body, times M^(-1/2).
Row StabilityRows::row_of(Index body, Vec2 direction, Vec2 arm) const {
  const double m = root_mass_[body], i = root_inertia_[body];
  return {m * direction.x, m * direction.y, i * cross(arm, direction)};
}

void StabilityRows::add_strut(const Strut& s, Coupling& on_a, Coupling& on_b) const {
  const Row a = row_of(s.a, s.direction, s.arm_a), b = negative(row_of(s.b, s.direction, s.arm_b));
  on_a.add(s.stiffness, s.damping, a, b);
  on_b.add(s.stiffness, s.damping, b, a);
}

void StabilityRows::add_to_links(Index a, Index b, const Coupling& on_a, const Coupling& on_b) {
  if (a < bodies_) on_a.add_to(links_[a]);
  if (b < bodies_) on_b.add_to(links_[b]);
}

// Its two points.
void StabilityRows::add_bond(const Model& model, const BondState& state, std::size_t first,
                             std::span<const Frame> frames) {
  Coupling on_a, on_b;
  for (const std::size_t i : {first, first + 1}) {
    const BondPoint& p = model.bond_points[i];
    if (state.history[i].gone()) continue;
    const BondGeometry g = bond_geometry(p, frames);
    add_strut({p.a, p.b, g.normal, g.arm_a, g.arm_b, p.law.normal, p.law.normal_damping}, on_a, on_b);
    add_strut({p.a, p.b, turned(g.normal), g.arm_a, g.arm_b, p.law.tangential, p.law.tangential_damping},
              on_a, on_b);
  }
  add_to_links(model.bond_points[first].a, model.bond_points[first].b, on_a, on_b);
}

void StabilityRows::add_joint(const JointElement& j, std::span<const Frame> frames) {
  const JointGeometry g = joint_geometry(j, frames);
  const double length = norm(g.separation);
  const Vec2 along = j.axial() && length > 0.0 ? (1.0 / length) * g.separation : Vec2{1.0, 0.0};
  Coupling on_a, on_b;
  add_strut({j.a, j.b, along, g.middle_a, g.middle_b, j.stiffness, j.damping}, on_a, on_b);
  // A pin acts across too; across a stretched spring its tension F/l does.
  const double across = j.axial() ? (length > 0.0 ? norm(g.spring) / length : 0.0) : j.stiffness;
  add_strut({j.a, j.b, turned(along), g.middle_a, g.middle_b, across, j.axial() ? 0.0 : j.damping}, on_a,
            on_b);
  const Row turn_a = turn_of(j.a), turn_b = negative(turn_of(j.b));
  on_a.add(j.rotational_stiffness, j.rotational_damping, turn_a, turn_b);
  on_b.add(j.rotational_stiffness, j.rotational_damping, turn_b, turn_a);
  add_to_links(j.a, j.b, on_a, on_b);
}

// Of the two bodies only the rows of the one named.
void StabilityRows::add_point(const ContactPoints& points, std::size_t i, Index body,
                              std::span<const Frame> frames, Coupling& coupling) const {
  const PointGeometry g = geometry_of(points, i, frames);
  const PointStiffness law = points.stiffness(i);
  const double damping = damping_share(points, i);
  const bool corner = points.corner_body[i] == body;
  const Index other = corner ? points.edge_body[i] : points.corner_body[i];
  const Vec2 arm = corner ? g.arm_corner : g.arm_edge, other_arm = corner ? g.arm_edge : g.arm_corner;
  const auto along = [&](Vec2 direction, double stiffness, double dashpot) {
    coupling.add(stiffness, damping * dashpot, row_of(body, direction, arm),
                 negative(row_of(other, direction, other_arm)));
  };
  along(g.normal, law.normal, law.normal_damping);
  along(turned(g.normal), law.tangential, law.tangential_damping);
  // A force that acts inside of its corner has less lever than counted here.
  if (points.rocking.empty() || points.rocking[i].couple == 0.0) return;
  coupling.add(0.0, points.rocking[i].couple * points.rocking[i].length, turn_of(body),
               negative(turn_of(other)));
}

void StabilityRows::renew_body(const ContactSet& contacts, Index body, std::span<const Frame> frames) {
  BodyRows rows = links_.empty() ? BodyRows{} : links_[body];
  for (const std::uint32_t touch : contacts.touches_of(body)) {
    const std::size_t first = touch & ~1u;
    Coupling coupling;
    add_point(contacts.points, first, body, frames, coupling);
    add_point(contacts.points, first + 1, body, frames, coupling);
    coupling.add_to(rows);
  }
  rows_[body] = {largest_row(rows.stiffness, rows.other_stiffness),
                 largest_row(rows.damping, rows.other_damping)};
}

SpectralBound StabilityRows::largest(const Model& model, std::span<const Frame> frames) const {
  SpectralBound bound;
  for (const SpectralBound& row : rows_) {
    bound.stiffness = std::max(bound.stiffness, row.stiffness);
    bound.damping = std::max(bound.damping, row.damping);
  }
  if (model.fields.empty()) return bound;
  // The largest eigenvalue of a sum is at most the sum of the largest.
  const FieldRates fields = field_rates(model.fields, model.mass, frames);
  return {bound.stiffness + fields.stiffness, bound.damping + fields.damping};
}

SpectralBound StabilityRows::assemble(const Model& model, const State& state, std::span<const Frame> frames,
                                      Crew& crew) {
  const bool linked = !model.bond_points.empty() || !model.joints.empty();
  links_.assign(linked ? bodies_ : 0, {});
  for (std::size_t i = 0; i < model.bond_points.size(); i += 2) add_bond(model, state.bonds, i, frames);
  for (const JointElement& joint : model.joints) add_joint(joint, frames);
  constexpr std::size_t share = 256;
  crew.share_range(bodies_, share, [&](std::size_t first, std::size_t last) {
    for (std::size_t body = first; body < last; ++body)
      renew_body(state.contacts, static_cast<Index>(body), frames);
  });
  return largest(model, frames);
}

SpectralBound StabilityRows::renew(const Model& model, const State& state, std::span<const Frame> frames,
                                   std::span<const Index> bodies) {
  for (const Index body : bodies)
    if (body < bodies_) renew_body(state.contacts, body, frames);
  return largest(model, frames);
}

SpectralBound spectral_bound(const Model& model, const State& state, std::span<const Frame> frames) {
  return StabilityRows(model).assemble(model, state, frames);
}

}  // namespace dougong::engine
