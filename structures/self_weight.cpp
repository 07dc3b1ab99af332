#include "structures/self_weight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace dougong::structures {
namespace {

using engine::Vec2;

void judge(FaceLoad& face, FaceLimit limit, double used) {
  if (!(used > face.used)) return;
  face.used = used;
  face.limit = limit;
}

/// Where the compression passes: `signed_eccentricity` of half the face, towards its end.
Vec2 passes_through(const FaceLoad& face, double signed_eccentricity) {
  return 0.5 * (face.start + face.end) +
         0.5 * std::clamp(signed_eccentricity, -1.0, 1.0) * (face.end - face.start);
}

/// Of one block, from its centroid to the face (m/Pa).
double flexibility(const engine::Model& model, std::span<const engine::Frame> frames, std::size_t body,
                   Vec2 middle, Vec2 normal) {
  if (model.is_terrain(static_cast<engine::Index>(body))) return 0.0;
  const double height = std::abs(dot(normal, middle - model.origin - frames[body].position()));
  return height / model.materials[body].young_modulus;
}

double stiffness_of_blocks(const engine::Model& model, std::span<const engine::Frame> frames,
                           const FaceLoad& face) {
  const Vec2 along = face.end - face.start, middle = 0.5 * (face.start + face.end);
  const double length = norm(along);
  if (!(length > 0.0)) return 0.0;
  const Vec2 normal = (1.0 / length) * engine::turned(along);
  const double flexible =
      flexibility(model, frames, face.a, middle, normal) + flexibility(model, frames, face.b, middle, normal);
  const double area = length * std::min(model.thickness[face.a], model.thickness[face.b]);
  return flexible > 0.0 ? area / flexible : 0.0;
}

// --- bonds -----------------------------------------------------------------------------------------

struct PointLoad {
  engine::BondForce force;
  Vec2 place;  // m, in the model's coordinates
};

PointLoad load_of(const engine::BondPoint& point, const engine::BondHistory& history,
                  std::span<const engine::Frame> frames) {
  const engine::BondGeometry g = engine::bond_geometry(point, frames);
  const engine::BondMotion motion{g.opening, g.slip, 0.0, 0.0, g.opening + history.crushed};
  return {engine::bond_force(point.law, motion, history), frames[point.a].position() + g.arm_a};
}

void judge_point(const engine::BondPoint& point, const engine::BondHistory& history, const PointLoad& load,
                 FaceLoad& face) {
  if (point.law.ductile()) judge(face, FaceLimit::yield, load.force.normal / point.law.yield);
  judge(face, FaceLimit::crushing, -load.force.normal / point.law.crushing);
  const double limit = engine::shear_limit(point.law, load.force.normal, history);
  if (limit > 0.0) judge(face, FaceLimit::shear, std::abs(load.force.tangential) / limit);
}

/// Area that a point stands for: half of the face (m2).
double half_area(const engine::Model& model, const engine::BondPoint& p, double length) {
  return 0.5 * length * std::min(model.thickness[p.a], model.thickness[p.b]);
}

FaceLoad bond_load(const engine::Model& model, const engine::State& state,
                   std::span<const engine::Frame> frames, std::size_t bond) {
  const engine::BondPoint* points = &model.bond_points[2 * bond];
  const engine::BondHistory* history = &state.bonds.history[2 * bond];
  const std::array<PointLoad, 2> loads{load_of(points[0], history[0], frames),
                                       load_of(points[1], history[1], frames)};
  FaceLoad face;
  face.bonded = true, face.bond = bond;
  face.a = points[0].a, face.b = points[0].b;
  const Vec2 half = 0.5 * std::numbers::sqrt3 * (loads[1].place - loads[0].place);
  const Vec2 middle = model.origin + 0.5 * (loads[0].place + loads[1].place);
  face.start = middle - half, face.end = middle + half;
  const double n1 = loads[0].force.normal, n2 = loads[1].force.normal;  // tension
  face.normal = -(n1 + n2);
  face.shear = loads[0].force.tangential + loads[1].force.tangential;
  const double eccentricity = n1 + n2 != 0.0 ? (n2 - n1) / (n1 + n2) / std::numbers::sqrt3 : 0.0;
  face.eccentricity = std::abs(eccentricity);
  face.through = passes_through(face, eccentricity);
  face.stiffness = points[0].law.normal + points[1].law.normal;
  face.blocks_stiffness = stiffness_of_blocks(model, frames, face);
  const double area = half_area(model, points[0], 2.0 * norm(half));
  const double mean = 0.5 * (n1 + n2) / area, swing = 0.5 * std::numbers::sqrt3 * std::abs(n1 - n2) / area;
  face.tension = std::max(0.0, mean + swing), face.compression = std::max(0.0, swing - mean);
  if (!points[0].law.ductile() && !history[0].broken && !history[1].broken)
    judge(face, FaceLimit::tension, face.tension * area / points[0].law.tension);
  for (const std::size_t k : {0u, 1u}) judge_point(points[k], history[k], loads[k], face);
  return face;
}

// --- faces that touch ------------------------------------------------------------------------------

/// Stress of a face without tension over its mean.
double peak_factor(double eccentricity) {
  if (eccentricity <= 1.0 / 3.0) return 1.0 + 3.0 * eccentricity;
  return eccentricity < 1.0 ? 4.0 / 3.0 / (1.0 - eccentricity) : std::numeric_limits<double>::infinity();
}

FaceLoad contact_load(const engine::Model& model, const engine::State& state,
                      std::span<const engine::Frame> frames, const engine::ContactPair& pair) {
  const engine::ContactPoints& points = state.contacts.points;
  FaceLoad face;
  face.a = pair.bodies.a, face.b = pair.bodies.b;
  std::array<Vec2, 2> place;
  std::array<double, 2> normal{};
  double friction = 0.0;
  for (const std::size_t k : {0u, 1u}) {
    const std::size_t i = pair.first_point + k;
    const engine::PointGeometry g = engine::geometry_of(points, i, frames);
    const Vec2 force = engine::force_of(points, i, frames);
    place[k] = frames[points.corner_body[i]].position() + g.arm_corner;
    normal[k] = dot(force, g.normal);
    face.shear += (points.corner_is_b(i) ? 1.0 : -1.0) * dot(force, engine::turned(g.normal));
    friction = points.stiffness(i).friction;
    face.stiffness += points.stiffness(i).normal;
  }
  face.start = model.origin + place[0], face.end = model.origin + place[1];
  face.normal = normal[0] + normal[1];
  if (!(face.normal > 0.0)) return face;
  const double length = norm(place[1] - place[0]);
  const double eccentricity = length > 0.0 ? (normal[1] - normal[0]) / face.normal : 0.0;
  face.eccentricity = std::abs(eccentricity);
  face.through = passes_through(face, eccentricity);
  face.blocks_stiffness = stiffness_of_blocks(model, frames, face);
  const double area = length * std::min(model.thickness[face.a], model.thickness[face.b]);
  face.compression = area > 0.0 ? face.normal / area * peak_factor(face.eccentricity)
                                : std::numeric_limits<double>::infinity();
  judge(face, FaceLimit::turning, face.eccentricity);
  if (friction > 0.0) judge(face, FaceLimit::friction, std::abs(face.shear) / (friction * face.normal));
  return face;
}

}  // namespace

std::string to_string(FaceLimit limit) {
  switch (limit) {
    case FaceLimit::none:
      return "none";
    case FaceLimit::tension:
      return "tension";
    case FaceLimit::yield:
      return "yield";
    case FaceLimit::crushing:
      return "crushing";
    case FaceLimit::shear:
      return "shear";
    case FaceLimit::friction:
      return "friction";
    case FaceLimit::turning:
      return "turning";
  }
  return "";
}

std::vector<FaceLoad> face_loads(const engine::Model& model, const engine::State& state) {
  return face_loads(model, state, engine::frames_of(model, state, true));
}

std::vector<FaceLoad> face_loads(const engine::Model& model, const engine::State& state,
                                 std::span<const engine::Frame> frames) {
  std::vector<FaceLoad> faces;
  for (std::size_t bond = 0; 2 * bond < model.bond_points.size(); ++bond)
    if (!state.bonds.history[2 * bond].gone() || !state.bonds.history[2 * bond + 1].gone())
      faces.push_back(bond_load(model, state, frames, bond));
  for (const engine::ContactPair& pair : state.contacts.pairs()) {
    if (!pair.active) continue;
    const FaceLoad face = contact_load(model, state, frames, pair);
    if (face.normal > 0.0) faces.push_back(face);
  }
  return faces;
}

std::vector<std::size_t> by_use(const std::vector<FaceLoad>& faces) {
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](auto i, auto j) { return faces[i].used > faces[j].used; });
  return order;
}

}  // namespace dougong::structures
