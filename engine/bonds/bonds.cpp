#include "engine/bonds/bonds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "engine/bonds/owners.h"
#include "engine/collision/manifold.h"

namespace dougong::engine {
namespace {

struct Face {
  Vec2 middle, tangent, normal;  // m, relative to the model's origin; normal from a to b
  double length;                 // m
};

Face face_of(const Bond& bond, const Model& model, const Frame& a, const Frame& b) {
  const Vec2 along = bond.end - bond.start;
  Face face;
  face.length = norm(along);
  if (!(face.length > 0.0) || !std::isfinite(face.length))
    throw std::invalid_argument(bond.name + ": the bonded face has no length");
  face.middle = 0.5 * (bond.start + bond.end) - model.origin;
  face.tangent = (1.0 / face.length) * along;
  face.normal = -turned(face.tangent);
  if (dot(face.normal, b.position() - a.position()) < 0.0) face.normal = -face.normal;
  return face;
}

double depth_over_modulus(const Model& model, Index body, double depth) {
  return model.is_terrain(body) ? 0.0 : std::abs(depth) / model.materials[body].young_modulus;
}

// Two columns in series between the centroids and the face, per area (Pa/m).
double stiffness_per_area(const Model& model, const Bond& bond, const Face& face, Index a, Index b,
                          const Frame& fa, const Frame& fb) {
  if (bond.normal_stiffness) return *bond.normal_stiffness;
  const double flexibility = depth_over_modulus(model, a, dot(face.normal, face.middle - fa.position())) +
                             depth_over_modulus(model, b, dot(face.normal, fb.position() - face.middle));
  return 1.0 / flexibility;
}

double shear_ratio(const Model& model, Index a, Index b) {
  return 0.5 / (1.0 + model.materials[model.is_terrain(a) ? b : a].poisson_ratio);
}

double dashpot(double ratio, double stiffness, const Model& model, const BondPoint& p, const Frame& fa,
               const Frame& fb, Vec2 direction) {
  const Vec2 place = fb.to_world(p.anchor_b);
  const double ra = cross(place - fa.position(), direction), rb = cross(place - fb.position(), direction);
  const double inverse_mass = 1.0 / model.mass[p.a] + 1.0 / model.mass[p.b] + ra * ra / model.inertia[p.a] +
                              rb * rb / model.inertia[p.b];
  return 2.0 * ratio * std::sqrt(stiffness / inverse_mass);
}

void require(bool good, const Bond& bond, const char* what) {
  if (!good) throw std::invalid_argument(bond.name + ": " + what);
}

void check(const Bond& bond) {
  require(!bond.normal_stiffness || *bond.normal_stiffness > 0.0, bond, "normal stiffness must be positive");
  require(!bond.shear_stiffness || *bond.shear_stiffness >= 0.0, bond,
          "shear stiffness must not be negative");
  require(bond.tensile_strength >= 0.0, bond, "tensile strength must not be negative");
  require(bond.cohesion >= 0.0, bond, "cohesion must not be negative");
  require(bond.friction_coefficient >= 0.0, bond, "friction coefficient must not be negative");
  require(bond.fracture_energy >= 0.0, bond, "fracture energy must not be negative");
  require(bond.fracture_energy == 0.0 || bond.tensile_strength > 0.0, bond,
          "a fracture energy needs a tensile strength");
  require(bond.yield_strength > 0.0, bond, "yield strength must be positive");
  require(bond.compressive_strength > 0.0, bond, "compressive strength must be positive");
  require(bond.damping_ratio >= 0.0, bond, "damping ratio must not be negative");
}

// w_f = 2 G_f / f_t; below the elastic opening at f_t the fall would be a snap-back: brittle.
double last_opening(const Bond& bond) {
  return bond.fracture_energy > 0.0 ? 2.0 * bond.fracture_energy / bond.tensile_strength : 0.0;
}

BondStiffness law_of(const Bond& bond, const Model& model, double area, double per_area, Index a, Index b) {
  BondStiffness k;
  k.normal = per_area * area;
  k.tangential = bond.shear_stiffness ? *bond.shear_stiffness * area : k.normal * shear_ratio(model, a, b);
  k.tension = bond.tensile_strength * area;
  k.cohesion = bond.cohesion * area;
  k.yield = bond.yield_strength * area;
  k.crushing = bond.compressive_strength * area;
  k.friction = bond.friction_coefficient;
  k.last_opening = last_opening(bond);
  return k;
}

void add_points(const Bond& bond, const Model& model, std::span<const Frame> frames,
                std::vector<BondPoint>& points) {
  check(bond);
  const Index a = index_of(bond.a, model, bond.name), b = index_of(bond.b, model, bond.name);
  const Frame &fa = frames[a], &fb = frames[b];
  const Face face = face_of(bond, model, fa, fb);
  const double area = 0.5 * face.length * std::min(model.thickness[a], model.thickness[b]);
  const double per_area = stiffness_per_area(model, bond, face, a, b, fa, fb);
  for (const double side : {-1.0, 1.0}) {
    const Vec2 place = face.middle + (side * 0.5 * face.length / std::sqrt(3.0)) * face.tangent;
    BondPoint p;
    p.a = a, p.b = b;
    p.anchor_b = fb.to_local(place);
    p.normal_a = fa.turned_to_local(face.normal);
    const Vec2 on_a = fa.to_local(place);
    p.offset = {dot(p.normal_a, on_a), dot(turned(p.normal_a), on_a)};
    p.law = law_of(bond, model, area, per_area, a, b);
    p.damping_ratio = bond.damping_ratio;
    p.law.normal_damping = dashpot(bond.damping_ratio, p.law.normal, model, p, fa, fb, face.normal);
    p.law.tangential_damping = dashpot(bond.damping_ratio, p.law.tangential, model, p, fa, fb, face.tangent);
    points.push_back(p);
  }
}

// The two points of a bond at some poses.
struct BondPose {
  std::array<BondGeometry, 2> geometry;
  std::array<BondMotion, 2> motion;
};

BondMotion motion_of(const BondPoint& p, const BondGeometry& g, std::span<const Frame> frames) {
  const Frame &a = frames[p.a], &b = frames[p.b];
  const Vec2 u = b.velocity() - a.velocity() + b.spin * turned(g.arm_b) - a.spin * turned(g.arm_a);
  return {g.opening, g.slip, dot(g.normal, u), dot(turned(g.normal), u), g.opening};
}

// The ends of the face open as the line through its points says, which stand at 1/sqrt(3) of the way to them;
// nothing is known of them once one is broken.
BondPose pose_of(std::span<const BondPoint> points, std::span<const BondHistory> history,
                 std::span<const Frame> frames) {
  BondPose pose;
  for (const std::size_t k : {0u, 1u}) {
    pose.geometry[k] = bond_geometry(points[k], frames);
    pose.motion[k] = motion_of(points[k], pose.geometry[k], frames);
    pose.motion[k].edge_opening += history[k].crushed;
  }
  if (history[0].broken || history[1].broken) return pose;
  constexpr double beyond = 0.5 * (std::numbers::sqrt3 - 1.0);
  const double tilt = pose.motion[1].edge_opening - pose.motion[0].edge_opening;
  pose.motion[0].edge_opening -= beyond * tilt;
  pose.motion[1].edge_opening += beyond * tilt;
  return pose;
}

void commit_point(const BondMotion& m, const BondForce& f, BondHistory& history, BondPast& past,
                  BondTotals& totals) {
  const double opened = m.opening - past.opening, slid = m.slip - past.slip;
  totals.spring_work +=
      0.5 * (past.normal + f.normal) * opened + 0.5 * (past.tangential + f.tangential) * slid;
  totals.damping_work += 0.5 * (past.normal_dashpot + f.normal_dashpot) * opened +
                         0.5 * (past.tangential_dashpot + f.tangential_dashpot) * slid;
  past = {m.opening, m.slip, f.normal, f.tangential, f.normal_dashpot, f.tangential_dashpot};
  history = f.history;
}

}  // namespace

std::vector<BondPoint> compile_bonds(const Scene& scene, const Model& model) {
  std::vector<BondPoint> points;
  if (scene.bonds.empty()) return points;
  const std::vector<Frame> frames = described_frames(scene, model);
  for (const Bond& bond : scene.bonds) add_points(bond, model, frames, points);
  return points;
}

namespace {

BodyPair pair_of(const BondPoint& p) {
  return {std::min(p.a, p.b), std::max(p.a, p.b)};
}

// The points stand L/sqrt(3) apart.
double length_of(const Model& model, std::size_t first_point) {
  return std::sqrt(3.0) *
         norm(model.bond_points[first_point + 1].anchor_b - model.bond_points[first_point].anchor_b);
}

// The colliders of every owner, in their order.
std::vector<std::vector<Index>> colliders_by_owner(const Model& model) {
  std::vector<std::vector<Index>> of(model.size());
  for (Index c = 0; c < model.colliders.size(); ++c) of[model.colliders[c].owner].push_back(c);
  return of;
}

// Of the faces with which the colliders of two bodies meet (m).
double meeting_length(const Model& model, std::span<const Frame> frames, BodyPair bodies,
                      const std::vector<std::vector<Index>>& colliders) {
  constexpr double margin_ratio = 1e-3;
  const double margin = margin_ratio * std::min(model.minimum_width[bodies.a], model.minimum_width[bodies.b]);
  double length = 0.0;
  for (const Index a : colliders[bodies.a])
    for (const Index b : colliders[bodies.b])
      length += find_manifold(model, frames, std::min(a, b), std::max(a, b), margin, {}).length;
  return length;
}

}  // namespace

BondState initial_bonds(const Model& model, std::span<const Frame> frames) {
  constexpr double nearly_all = 0.95;
  BondState state;
  state.history.resize(model.bond_points.size());
  std::map<BodyPair, double> bonded;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    const BondPoint& point = model.bond_points[i];
    const BondGeometry g = bond_geometry(point, frames);
    state.past.push_back({g.opening, g.slip});
    if (i % 2 == 0) bonded[pair_of(point)] += length_of(model, i);
  }
  const auto colliders = colliders_by_owner(model);
  for (auto& [bodies, length] : bonded)
    if (length < nearly_all * meeting_length(model, frames, bodies, colliders)) length = 0.0;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i)
    state.history[i].joined = bonded[pair_of(model.bond_points[i])] > 0.0;
  return state;
}

std::vector<ReleasedPair> release_cracked(const Model& model, BondState& state,
                                          std::span<const Frame> frames) {
  std::map<BodyPair, double> released;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i)
    if (state.history[i].joined && has_cracked(model.bond_points[i].law, state.history[i]))
      released[pair_of(model.bond_points[i])] = 0.0;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    const BondPoint& point = model.bond_points[i];
    const auto pair = released.find(pair_of(point));
    if (pair == released.end() || !state.history[i].joined) continue;
    const double closed = std::min(0.0, bond_geometry(point, frames).opening - state.history[i].relaxed());
    pair->second += 0.5 * point.law.normal * closed * closed;
    state.history[i].joined = false;
    state.history[i].was_joined = true;
  }
  state.cracked = false;
  std::vector<ReleasedPair> pairs;
  for (const auto& [bodies, energy] : released) pairs.push_back({bodies, energy});
  return pairs;
}

std::vector<BodyPair> held_pairs(const Model& model, const BondState& state) {
  std::vector<BodyPair> pairs;
  const auto hold = [&](Index a, Index b) { pairs.push_back({std::min(a, b), std::max(a, b)}); };
  for (const JointElement& joint : model.joints)
    if (!joint.axial()) hold(joint.a, joint.b);
  for (std::size_t i = 0; i < model.bond_points.size(); ++i)
    if (state.history[i].joined) hold(model.bond_points[i].a, model.bond_points[i].b);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<PairDamping> tied_pairs(const Model& model, const BondState& state) {
  std::map<BodyPair, double> ratios;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    if (!state.history[i].was_joined || state.history[i].broken) continue;
    const BondPoint& point = model.bond_points[i];
    double& ratio = ratios[pair_of(point)];
    ratio = std::max(ratio, point.damping_ratio);
  }
  std::vector<PairDamping> pairs;
  for (const auto& [bodies, ratio] : ratios) pairs.push_back({bodies, ratio});
  return pairs;
}

BondGeometry bond_geometry(const BondPoint& point, std::span<const Frame> frames) {
  const Frame &a = frames[point.a], &b = frames[point.b];
  BondGeometry g;
  g.normal = a.turned_to_world(point.normal_a);
  g.arm_b = b.turned_to_world(point.anchor_b);
  g.arm_a = b.position() - a.position() + g.arm_b;
  g.opening = dot(g.normal, g.arm_a) - point.offset.x;
  g.slip = dot(turned(g.normal), g.arm_a) - point.offset.y;
  return g;
}

namespace {

void add_force(const BondPoint& p, const BondGeometry& g, const BondForce& f, std::span<Vec2> forces,
               std::span<double> torques) {
  const Vec2 on_b =
      -(f.normal + f.normal_dashpot) * g.normal - (f.tangential + f.tangential_dashpot) * turned(g.normal);
  forces[p.b] += on_b, forces[p.a] -= on_b;
  torques[p.b] += cross(g.arm_b, on_b), torques[p.a] -= cross(g.arm_a, on_b);
}

void note_damage(const BondPoint& p, const BondHistory& before, const BondHistory& after, BondState& state) {
  const bool breaks = after.broken && !before.broken;
  state.broken += breaks;
  state.cracked |= after.joined && has_cracked(p.law, after);
  state.loosened |= breaks && after.was_joined;
}

}  // namespace

BondTotals add_bond_forces(const Model& model, BondState& state, std::span<const Frame> frames, bool commit,
                           std::span<Vec2> forces, std::span<double> torques) {
  BondTotals totals;
  for (std::size_t first = 0; first < model.bond_points.size(); first += 2) {
    const auto points = std::span(model.bond_points).subspan(first, 2);
    const auto history = std::span(state.history).subspan(first, 2);
    if (history[0].gone() && history[1].gone()) continue;
    const BondPose pose = pose_of(points, history, frames);
    for (const std::size_t k : {0u, 1u}) {
      const BondMotion& m = pose.motion[k];
      const BondForce f = bond_force(points[k].law, m, history[k]);
      add_force(points[k], pose.geometry[k], f, forces, torques);
      totals.spring_power += f.normal * m.opening_rate + f.tangential * m.slip_rate;
      totals.damping_power += f.normal_dashpot * m.opening_rate + f.tangential_dashpot * m.slip_rate;
      if (!commit) continue;
      note_damage(points[k], history[k], f.history, state);
      commit_point(m, f, history[k], state.past[first + k], totals);
    }
  }
  return totals;
}

double bond_energy(const Model& model, const BondState& state, std::span<const Frame> frames) {
  double energy = 0.0;
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    const BondGeometry g = bond_geometry(model.bond_points[i], frames);
    energy += bond_energy(model.bond_points[i].law, g.opening, g.slip, state.history[i]);
  }
  return energy;
}

}  // namespace dougong::engine
