#include "app/study/run_sheets.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/study/quantity.h"
#include "app/study/version.h"
#include "seismic/formats/file_text.h"
#include "structures/bond_damage.h"

namespace dougong::app {
namespace {

using engine::Vec2;

std::string pair_name(const engine::Model& model, engine::BodyPair pair) {
  return model.names[pair.a] + " / " + model.names[pair.b];
}

void describe_deepest(const engine::Model& model, const engine::State& state, Numerics& n) {
  n.deepest_overlap_ratio = state.deepest_ratio;
  if (state.deepest_ratio == 0.0) return;
  const auto [a, b] = state.deepest_pair;
  n.deepest_overlap = state.deepest_ratio * std::min(model.minimum_width[a], model.minimum_width[b]);
  n.deepest_overlap_where =
      fmt::format("{} at {:.2f} s", pair_name(model, state.deepest_pair), state.deepest_time);
}

// --- shapes ------------------------------------------------------------------------------------------

// All that lies below y = 0, as far as any picture may look.
constexpr double far_away = 1e7;  // m
const std::vector<Vec2> lower_half{
    {-far_away, -far_away}, {far_away, -far_away}, {far_away, 0.0}, {-far_away, 0.0}};

void give_outline(DrawnShape& drawn, const engine::Circle& circle) {
  drawn.radius = circle.radius;
}
void give_outline(DrawnShape& drawn, const engine::ConvexPolygon& polygon) {
  drawn.outline = polygon.vertices();
}
void give_outline(DrawnShape& drawn, const engine::HalfPlane&) {
  drawn.outline = lower_half;
}
void give_outline(DrawnShape& drawn, const engine::Compound& compound) {
  for (const engine::Part& part : compound.parts) {
    DrawnShape piece;
    std::visit([&](const auto& shape) { give_outline(piece, shape); }, part.shape);
    piece.position = part.position;
    piece.angle = part.angle;
    drawn.parts.push_back(std::move(piece));
  }
}

template <class Thing>
DrawnShape drawn(const Thing& thing, const engine::Scene& scene) {
  DrawnShape d;
  d.name = thing.name;
  std::visit([&](const auto& shape) { give_outline(d, shape); }, thing.shape);
  d.position = thing.position;
  d.angle = thing.angle;
  d.material = scene.materials[thing.material].name;
  return d;
}

double mass_of(const engine::Body& body, const engine::Scene& scene) {
  return body.mass
             ? *body.mass
             : engine::mass_properties(body.shape, scene.materials[body.material].density, body.thickness)
                   .mass;
}

}  // namespace

Numerics numerics_of(const engine::Model& model, const engine::State& state,
                     const engine::DriveOptions& drive, const engine::RunOutcome& run) {
  Numerics n;
  n.integrator = drive.integrator;
  n.step = run.smallest_step;
  n.bound = run.bound;
  n.steps = run.steps;
  n.evaluations = run.evaluations;
  n.step_reductions = run.step_reductions;
  n.outcome = to_string(run.outcome);
  n.outcome_detail = run.detail;
  n.end_time = run.end_time;
  n.asked_time = drive.end_time;
  describe_deepest(model, state, n);
  constexpr double worth_a_word = 0.25;  // what lies above is the change from rest to rocking
  if (run.smallest_step < worth_a_word * run.step)
    n.warnings.push_back(
        fmt::format("the step was reduced {} times, to {:.3g} s, for stiffer contacts or faster bodies",
                    run.step_reductions, run.smallest_step));
  return n;
}

SettleSheet settle_sheet(const engine::SettleReport& report) {
  return {report.settled, report.duration, report.greatest_movement, report.unbalanced_ratio};
}

Reproducibility reproducibility_of(const std::string& text, const std::string& record_sha256,
                                   const std::string& command) {
  Reproducibility r;
  r.version = program_version();
  r.git_hash = program_git_hash();
  r.compiler = program_compiler();
  r.command = command;
  r.scenario = text;
  r.scenario_sha256 = seismic::sha256_hex(r.scenario);
  r.record_sha256 = record_sha256;
  r.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return r;
}

void EnergyRecorder::note(const engine::Model& model, const engine::State& state) {
  const engine::Energies e = engine::energies_of(model, state);
  turnover_.note(e);
  const std::pair<std::vector<double>*, double> columns[] = {
      {&energy.input, e.input},           {&energy.kinetic, e.kinetic},   {&energy.gravity, e.gravity},
      {&energy.elastic, e.elastic},       {&energy.friction, e.friction}, {&energy.damping, e.damping},
      {&energy.error, turnover_.error()}, {&energy.fracture, e.fracture}, {&energy.field, e.field}};
  for (const auto& [column, value] : columns) column->push_back(value);
  energy.largest_input = std::max(energy.largest_input, std::abs(e.input));
  energy.relative_error = turnover_.relative_error();
}

OverlapRatios overlap_ratios(const engine::ContactPoints& points, std::span<const engine::Frame> frames) {
  OverlapRatios found;
  std::size_t touching = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double ratio = engine::geometry_of(points, i, frames).overlap * points.inverse_width(i);
    if (!(ratio > 0.0)) continue;
    found.deepest = std::max(found.deepest, ratio);
    found.mean += ratio;
    ++touching;
  }
  if (touching > 0) found.mean /= static_cast<double>(touching);
  return found;
}

DrawnShape drawn_shape(const engine::Body& body, const engine::Scene& scene) {
  DrawnShape d = drawn(body, scene);
  d.mass = mass_of(body, scene);
  return d;
}

DrawnShape drawn_shape(const engine::Terrain& terrain, const engine::Scene& scene) {
  return drawn(terrain, scene);
}

namespace {

struct DescribedPose {
  Vec2 position;
  double angle;
};

DescribedPose pose_of(engine::Owner owner, const engine::Scene& scene) {
  if (owner.terrain) return {scene.terrains[owner.index].position, scene.terrains[owner.index].angle};
  return {scene.bodies[owner.index].position, scene.bodies[owner.index].angle};
}

DrawnBond drawn_bond(const engine::Bond& bond, std::size_t owner, const DescribedPose& pose) {
  const auto local = [&](Vec2 place) { return engine::rotated(place - pose.position, -pose.angle); };
  return {bond.name, owner, local(bond.start), local(bond.end)};
}

}  // namespace

void draw_connections(const engine::Scene& scene, ModelSheet& sheet) {
  sheet.bonds = scene.bonds.size();
  const auto place = [&](engine::Owner o) { return o.terrain ? scene.bodies.size() + o.index : o.index; };
  for (const engine::Bond& bond : scene.bonds)
    sheet.bonded.push_back(drawn_bond(bond, place(bond.b), pose_of(bond.b, scene)));
  for (const engine::Joint& joint : scene.joints)
    sheet.links.push_back({place(joint.a), place(joint.b), joint.anchor_a, joint.anchor_b});
}

void note_damage(const engine::Model& model, const engine::State& state, std::vector<DrawnBond>& bonds) {
  const std::vector<structures::BondDamage> damage = structures::bond_damage(model, state);
  const auto note = [&](bool happened, double& time) {
    if (happened) time = std::min(time, state.time);
  };
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    if (bonds[i].mode.empty()) bonds[i].mode = damage[i].mode;
    note(damage[i].cracked, bonds[i].cracked);
    note(damage[i].crushed, bonds[i].crushed);
    note(damage[i].broken, bonds[i].broken);
  }
}

NamedValue material_sheet(const engine::Material& m) {
  return {
      m.name,
      fmt::format(
          "E {}, {}, friction {}, damping ratio {}{}", print_quantity(m.young_modulus, Dimension::pressure),
          print_quantity(m.density, Dimension::density), m.friction_coefficient, m.damping_ratio,
          m.rocking_restitution ? fmt::format(", rocking restitution {}", *m.rocking_restitution) : ""),
      "damping ratio of a contact point; friction of two materials is the smaller one"};
}

}  // namespace dougong::app
