// What a scene models and what it leaves out, in words: only what the scene has is modelled.
#include <fmt/format.h>

#include <algorithm>

#include "app/study/quantity.h"
#include "app/study/scene_run.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

template <class Member>
std::size_t bodies_with(const engine::Scene& scene, Member member) {
  std::size_t count = 0;
  for (const engine::Body& body : scene.bodies) count += body.*member != 0.0 ? 1 : 0;
  return count;
}

void add_contact(const PreparedScene& p, std::vector<std::string>& terms) {
  if (!p.model.has_contacts()) return;
  if (engine::traits_of(p.drive.integrator).rigid_contacts) {
    terms.emplace_back("contact: rigid, impulses with the restitution of the damping ratio, never tensile");
    terms.emplace_back("Coulomb friction by impulses");
    return;
  }
  terms.push_back(fmt::format("contact: springs {}, dashpots from the damping ratio, never tensile",
                              p.scene.contact.point_stiffness ? "of the stiffness that is given"
                                                              : "from the Young's moduli and sizes"));
  terms.emplace_back("Coulomb friction with an elastic spring");
}

void add_fields(const PreparedScene& p, std::vector<std::string>& terms) {
  const engine::Scene& scene = p.scene;
  const engine::Fields& f = scene.fields;
  if (f.gravitational_constant != 0.0)
    terms.push_back(fmt::format(
        "gravitation between all bodies, G = {}{}",
        print_quantity(f.gravitational_constant, Dimension::gravitational_constant),
        f.softening > 0.0 ? ", softened over " + print_quantity(f.softening, Dimension::length) : ""));
  if (f.coulomb_constant != 0.0)
    terms.push_back(fmt::format("Coulomb forces between {}, k = {}",
                                counted(bodies_with(scene, &engine::Body::charge), "charge", "charges"),
                                print_quantity(f.coulomb_constant, Dimension::coulomb_constant)));
  if (!p.tree_errors.empty())
    terms.push_back(
        fmt::format("far bodies as one: a Barnes-Hut tree with an opening angle of {}", f.opening_angle));
  if (f.electric_field != engine::Vec2{}) terms.emplace_back("a uniform electric field");
}

void add_applied(const engine::Scene& scene, std::vector<std::string>& terms) {
  const auto loaded = static_cast<std::size_t>(std::ranges::count_if(
      scene.bodies, [](const engine::Body& body) { return body.applied_force != engine::Vec2{}; }));
  if (loaded > 0) terms.push_back(fmt::format("a constant force on {}", counted(loaded, "body", "bodies")));
}

void add_drag(const engine::Scene& scene, std::vector<std::string>& terms) {
  const std::size_t linear = bodies_with(scene, &engine::Body::linear_drag),
                    quadratic = bodies_with(scene, &engine::Body::quadratic_drag);
  if (linear > 0) terms.push_back(fmt::format("linear drag on {}", counted(linear, "body", "bodies")));
  if (quadratic > 0)
    terms.push_back(fmt::format("quadratic drag on {}", counted(quadratic, "body", "bodies")));
}

void add_connections(const engine::Scene& scene, std::vector<std::string>& terms) {
  if (!scene.joints.empty()) terms.push_back(counted(scene.joints.size(), "joint", "joints"));
  if (!scene.bonds.empty()) terms.push_back(counted(scene.bonds.size(), "bond", "bonds"));
}

void add_motions(const PreparedScene& p, std::vector<std::string>& terms) {
  for (std::size_t i = 0; i < p.motions.size(); ++i)
    if (p.motions[i].motion)
      terms.push_back(fmt::format("motion of terrain {}: {}", p.scene.terrains[i].name, p.motions[i].title));
}

}  // namespace

std::vector<std::string> modelled_terms(const PreparedScene& p) {
  std::vector<std::string> terms{fmt::format("{} with three degrees of freedom each",
                                             counted(p.model.body_count, "rigid body", "rigid bodies"))};
  add_contact(p, terms);
  if (p.scene.gravity != engine::Vec2{})
    terms.push_back(fmt::format("uniform gravity of {:.6g} m/s2", engine::norm(p.scene.gravity)));
  add_fields(p, terms);
  add_applied(p.scene, terms);
  add_drag(p.scene, terms);
  add_connections(p.scene, terms);
  add_motions(p, terms);
  return terms;
}

std::vector<std::string> missing_terms(const PreparedScene& p) {
  std::vector<std::string> terms{
      "deformation and breaking within a body: bodies are rigid, their elasticity acts at the contacts",
      "motion out of the plane"};
  if (!p.model.has_contacts()) terms.emplace_back("contact and friction: nothing can touch");
  if (p.scene.gravity == engine::Vec2{}) terms.emplace_back("uniform gravity: switched off");
  const std::size_t charges = bodies_with(p.scene, &engine::Body::charge);
  if (charges > 0 && p.scene.fields.coulomb_constant == 0.0 &&
      p.scene.fields.electric_field == engine::Vec2{})
    terms.push_back(fmt::format("forces on {}: fields.coulomb_constant and fields.electric_field are zero",
                                counted(charges, "charge", "charges")));
  return terms;
}

}  // namespace dougong::app
