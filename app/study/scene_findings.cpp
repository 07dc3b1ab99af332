#include "app/study/scene_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/study/quantity.h"
#include "app/study/rocking_limits.h"
#include "engine/fields/pair_field.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

using Findings = std::vector<std::string>;

void append(Findings& to, Findings from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// The first few of many alike.
Findings shortened(Findings findings, const char* what) {
  constexpr std::size_t most = 5;
  if (findings.size() <= most) return findings;
  const std::size_t more = findings.size() - most;
  findings.resize(most);
  findings.push_back(fmt::format("{} more {}", more, what));
  return findings;
}

// --- the start ---------------------------------------------------------------------------------------

// Deeper than any weight presses, they will be thrown apart.
Findings overlaps_at_start(const PreparedScene& p) {
  constexpr double noticeable = 1e-3;
  const engine::ContactPoints& points = p.state.contacts.points;
  const auto frames = engine::frames_of(p.model, p.state);
  std::map<engine::BodyPair, std::pair<double, double>> deepest;  // overlap, its part of the width
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double overlap = engine::geometry_of(points, i, frames).overlap;
    if (overlap * points.inverse_width(i) < noticeable) continue;
    const auto [a, b] = std::minmax(points.corner_body[i], points.edge_body[i]);
    auto& found = deepest[{a, b}];
    found = std::max(found, {overlap, overlap * points.inverse_width(i)});
  }
  Findings findings;
  for (const auto& [pair, depth] : deepest)
    findings.push_back(fmt::format(
        "{} and {} overlap by {:.3g} m at the start, {:.2g} % of the smaller one's width: they will be "
        "thrown apart",
        p.model.names[pair.a], p.model.names[pair.b], depth.first, 100.0 * depth.second));
  return shortened(std::move(findings), "pairs overlap");
}

// Output times and the samples of a motion are multiples of one interval.
Findings changed_outputs(const PreparedScene& p) {
  const double asked = 1.0 / p.description.output.rate, given = p.plan.output_interval;
  const double end = std::ceil(p.drive.end_time / given - 1e-9) * given;
  Findings findings;
  if (std::abs(given - asked) > 1e-9 * asked)
    findings.push_back(
        fmt::format("output every {:.6g} s instead of {:.6g} s, to meet the motion's samples", given, asked));
  if (end > p.drive.end_time * (1.0 + 1e-9))
    findings.push_back(fmt::format("{:.6g} s are simulated instead of {:.6g} s, a whole number of outputs",
                                   end, p.drive.end_time));
  return findings;
}

// --- keys that make no difference --------------------------------------------------------------------

// What reads a material's elasticity in this scene.
struct Elasticity {
  bool young_modulus, poisson_ratio, thickness;
};

Elasticity elasticity_that_acts(const PreparedScene& p) {
  const SceneDescription& d = p.description;
  const bool springs = p.model.has_contacts() && !engine::traits_of(p.drive.integrator).rigid_contacts;
  const auto lacks = [](auto member) { return [member](const auto& thing) { return !(thing.*member); }; };
  const bool young = (springs && !d.contact.point_stiffness) ||
                     std::ranges::any_of(d.joints, lacks(&JointChoice::stiffness)) ||
                     std::ranges::any_of(d.bonds, lacks(&BondChoice::normal_stiffness));
  const bool poisson = (springs && !d.contact.tangential_ratio) ||
                       std::ranges::any_of(d.bonds, lacks(&BondChoice::shear_stiffness));
  return {young, poisson, young || !d.bonds.empty()};
}

class MootKeys {
 public:
  explicit MootKeys(const PreparedScene& p)
      : p_(p), d_(p.description), elasticity_(elasticity_that_acts(p)), touching_(p.model.has_contacts()) {}

  Findings find() {
    for (const MaterialChoice& material : d_.materials) note_material(material);
    for (const MaterialPairChoice& pair : d_.material_pairs) note_pair(pair);
    for (const BodyChoice& body : d_.bodies)
      if (body.thickness != BodyChoice{}.thickness && body.mass && !elasticity_.thickness)
        note("body." + body.name + ".thickness", "its mass is given, and no spring follows from its size");
    for (const TerrainChoice& terrain : d_.terrains) note_motion(terrain);
    note_fields();
    for (std::size_t i = 0; i < d_.bonds.size(); ++i) note_bond(i);
    if (!touching_ && d_.contact.point_stiffness) note("contact.point_stiffness", "nothing can touch");
    if (!touching_ && d_.contact.tangential_ratio) note("contact.tangential_ratio", "nothing can touch");
    note_solve();
    return std::move(findings_);
  }

 private:
  void note(const std::string& key, const std::string& why) {
    findings_.push_back(fmt::format("{} makes no difference: {}", key, why));
  }

  template <class Things, class Test>
  bool any_of(const std::string& material, const Things& things, Test test) const {
    return std::ranges::any_of(things,
                               [&](const auto& thing) { return thing.material == material && test(thing); });
  }
  bool is_used(const std::string& material) const {
    const auto always = [](const auto&) { return true; };
    return any_of(material, d_.bodies, always) || any_of(material, d_.terrains, always);
  }
  bool has_faces(const std::string& material) const {
    const auto faced = [](const auto& thing) { return thing.shape.kind != "circle"; };
    return any_of(material, d_.bodies, faced) || any_of(material, d_.terrains, faced);
  }

  void note_material(const MaterialChoice& m) {
    const std::string key = "materials." + m.name;
    if (!is_used(m.name)) return note(key, "nothing is made of it");
    if (m.density && !any_of(m.name, d_.bodies, [](const BodyChoice& b) { return !b.mass; }))
      note(key + ".density", "no body takes its mass from it");
    if (m.young_modulus && !elasticity_.young_modulus)
      note(key + ".young_modulus", "no spring follows from it");
    if (m.poisson_ratio && !elasticity_.poisson_ratio)
      note(key + ".poisson_ratio", "no spring follows from it");
    if (m.rocking_restitution && touching_ && !has_faces(m.name))
      note(key + ".rocking_restitution", "circles do not rock");
    if (!touching_ && (m.friction || m.damping_ratio || m.restitution || m.rocking_restitution))
      note(key + ", what it does at contacts,", "nothing can touch");
  }

  void note_pair(const MaterialPairChoice& pair) {
    const std::string key = fmt::format("material_pair of {} and {}", pair.a, pair.b);
    for (const std::string& material : {pair.a, pair.b})
      if (!is_used(material)) return note(key, fmt::format("nothing is made of {}", material));
    if (!touching_) note(key, "nothing can touch");
  }

  void note_motion(const TerrainChoice& terrain) {
    const auto& motion = terrain.motion;
    const bool still = motion && ((motion->harmonic && motion->harmonic->amplitude == 0.0) ||
                                  (motion->velocity && *motion->velocity == engine::Vec2{}));
    if (still) note("motion of terrain " + terrain.name, "it is at rest");
  }

  void note_fields() {
    const engine::Fields& f = d_.fields;
    const auto charges =
        std::ranges::count_if(d_.bodies, [](const BodyChoice& b) { return b.charge != 0.0; });
    if (f.gravitational_constant != 0.0 && d_.bodies.size() < 2)
      note("fields.gravitational_constant", "there is one body only");
    if (f.coulomb_constant != 0.0 && charges < 2)
      note("fields.coulomb_constant", fmt::format("of the bodies {} have a charge", charges));
    if (f.electric_field != engine::Vec2{} && charges == 0)
      note("fields.electric_field", "no body has a charge");
    const auto& pairs = p_.model.fields.pairs;
    if (f.softening != 0.0 && pairs.empty())
      note("fields.softening", "no bodies act on each other at a distance");
    if (f.opening_angle != 0.0 && std::ranges::none_of(pairs, engine::uses_tree))
      note("fields.opening_angle",
           fmt::format("with fewer than {} bodies every pair is summed", engine::smallest_tree));
  }

  // Energy per area that the bond's springs hold at its strength: below it there is no falling branch.
  void note_bond(std::size_t i) {
    const BondChoice& bond = d_.bonds[i];
    const engine::BondStiffness& law = p_.model.bond_points[2 * i].law;
    const double first = law.tension / law.normal;
    if (!(law.last_opening > 0.0) || law.last_opening > first) return;
    note("bond." + bond.name + ".fracture_energy",
         fmt::format("its springs store {} when its strength is reached, so it breaks at once",
                     print_quantity(0.5 * *bond.tensile_strength * first, Dimension::fracture_energy)));
  }

  void note_solve() {
    const bool unbounded =
        engine::traits_of(p_.drive.integrator).rigid_contacts && !std::isfinite(p_.plan.bound);
    if (!unbounded) return;
    if (d_.solve.step_fraction) note("solve.step_fraction", "rigid contacts have no stability bound");
    if (d_.solve.accuracy != SceneSolve{}.accuracy)
      note("solve.accuracy", "rigid contacts have no stability bound");
  }

  const PreparedScene& p_;
  const SceneDescription& d_;
  Elasticity elasticity_;
  bool touching_;
  Findings findings_;
};

}  // namespace

Findings findings_of(const PreparedScene& p) {
  Findings findings = overlaps_at_start(p);
  append(findings, changed_outputs(p));
  append(findings, MootKeys(p).find());
  append(findings, RockingLimits{}.look(p.model, p.state));
  return findings;
}

}  // namespace dougong::app
