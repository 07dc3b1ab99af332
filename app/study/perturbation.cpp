#include "app/study/perturbation.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "seismic/synthesis/random.h"

namespace dougong::app {
namespace {

enum class What : std::uint64_t {
  position,
  friction,
  pair_friction,
  bond_friction,
  strength,
  damping,
  pair_damping,
  bond_damping,
  joint_damping,
  amplitude
};

// The numbers of one member, from -1 to 1.
class Numbers {
 public:
  Numbers(const Perturbation& by, std::size_t member)
      : seed_(static_cast<std::uint64_t>(by.seed)), member_(member) {}
  double operator()(What what, std::size_t which) const {
    constexpr std::uint64_t streams = 64;
    const std::uint64_t stream = streams * member_ + static_cast<std::uint64_t>(what);
    return 2.0 * seismic::uniform_number(seed_, stream, which) - 1.0;
  }
  double factor(double amount, What what, std::size_t which) const {
    return 1.0 + amount * (*this)(what, which);
  }

 private:
  std::uint64_t seed_, member_;
};

// Bodies that bonds and joints tie together, each by its first one; terrains are numbered behind the bodies.
class Parts {
 public:
  explicit Parts(const engine::Scene& scene)
      : bodies_(scene.bodies.size()), first_(bodies_ + scene.terrains.size()) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
    for (const engine::Bond& bond : scene.bonds) join(bond.a, bond.b);
    for (const engine::Joint& joint : scene.joints) join(joint.a, joint.b);
    for (std::size_t terrain = bodies_; terrain < first_.size(); ++terrain) held_.push_back(part_of(terrain));
  }
  std::size_t of(const engine::Owner& owner) { return part_of(place(owner)); }
  bool is_held(std::size_t part) const { return std::find(held_.begin(), held_.end(), part) != held_.end(); }

 private:
  std::size_t place(const engine::Owner& owner) const {
    return owner.terrain ? bodies_ + owner.index : owner.index;
  }
  std::size_t part_of(std::size_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  }
  void join(const engine::Owner& a, const engine::Owner& b) {
    const std::size_t pa = part_of(place(a)), pb = part_of(place(b));
    first_[std::max(pa, pb)] = std::min(pa, pb);
  }

  std::size_t bodies_;
  std::vector<std::size_t> first_, held_;
};

void move_parts(engine::Scene& scene, double amount, const Numbers& numbers) {
  Parts parts(scene);
  const auto way = [&](const engine::Owner& owner) {
    const std::size_t part = parts.of(owner);
    return parts.is_held(part) ? 0.0 : amount * numbers(What::position, part);
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].position.x += way({false, i});
  for (engine::Bond& bond : scene.bonds) {
    const double moved = way(bond.a);
    bond.start.x += moved, bond.end.x += moved;
  }
}

void scale(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

void change_materials(engine::Scene& scene, const Perturbation& by, const Numbers& numbers) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    scene.materials[i].friction_coefficient *= numbers.factor(by.friction, What::friction, i);
    scene.materials[i].damping_ratio *= numbers.factor(by.damping, What::damping, i);
  }
  for (std::size_t i = 0; i < scene.material_pairs.size(); ++i) {
    scale(scene.material_pairs[i].friction_coefficient, numbers.factor(by.friction, What::pair_friction, i));
    scale(scene.material_pairs[i].damping_ratio, numbers.factor(by.damping, What::pair_damping, i));
  }
}

void change_ties(engine::Scene& scene, const Perturbation& by, const Numbers& numbers) {
  for (std::size_t i = 0; i < scene.bonds.size(); ++i) {
    engine::Bond& bond = scene.bonds[i];
    const double strength = numbers.factor(by.strength, What::strength, i);
    bond.tensile_strength *= strength, bond.cohesion *= strength, bond.yield_strength *= strength;
    bond.compressive_strength *= strength;
    bond.friction_coefficient *= numbers.factor(by.friction, What::bond_friction, i);
    bond.damping_ratio *= numbers.factor(by.damping, What::bond_damping, i);
  }
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const double damping = numbers.factor(by.damping, What::joint_damping, i);
    scale(scene.joints[i].damping, damping);
    scene.joints[i].damping_ratio *= damping;
  }
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace

void perturb(structures::Building& building, const Perturbation& by, std::size_t member) {
  if (member == 0) return;
  const Numbers numbers(by, member);
  move_parts(building.scene, by.position, numbers);
  change_materials(building.scene, by, numbers);
  change_ties(building.scene, by, numbers);
}

std::shared_ptr<const seismic::GroundMotion> perturbed(std::shared_ptr<const seismic::GroundMotion> motion,
                                                       const Perturbation& by, std::size_t member) {
  if (member == 0) return motion;
  const double factor = Numbers(by, member).factor(by.amplitude, What::amplitude, 0);
  const auto x = scaled(motion->horizontal().acceleration, factor);
  std::vector<double> y;
  std::optional<std::span<const double>> vertical;
  if (motion->vertical()) vertical = y = scaled(motion->vertical()->acceleration, factor);
  // It comes to rest already.
  return std::make_shared<const seismic::GroundMotion>(
      x, vertical, motion->knot_interval(), seismic::EndOptions{.after = seismic::AfterEnd::coast});
}

}  // namespace dougong::app
