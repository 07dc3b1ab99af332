#include "structures/pushover.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/fields/applied_force.h"
#include "structures/bond_damage.h"

namespace dougong::structures {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("pushover: " + what);
}

double sign_of(Direction side) {
  return side == Direction::right ? 1.0 : -1.0;
}

/// Mean displacement along the push of some blocks, by weights.
struct Gauge {
  std::vector<std::size_t> blocks;
  std::vector<double> weights;
  double start = 0.0;

  double read(const engine::State& state) const {
    double sum = 0.0, all = 0.0;
    for (std::size_t k = 0; k < blocks.size(); ++k)
      sum += weights[k] * state.q()[blocks[k]], all += weights[k];
    return sum / all;
  }
};

class Curve {
 public:
  Curve(const engine::Scene& scene, const std::vector<double>& forces, const PushoverOptions& options)
      : options_(options),
        sign_(sign_of(options.towards)),
        scene_(pushed(scene, forces, 1.0, options.towards)),
        model_(engine::compile(scene)),
        state_(engine::initial_state(model_, scene)) {
    for (const double force : forces) weight_ += force;
    kappa_ = options.stiffness * options.peak / options.target;
    make_gauges(forces);
    cracked_.assign(model_.bond_points.size() / 2, false);
  }

  CapacityCurve run() {
    if (!rest(model_)) return curve_;
    load_gauge_.start = load_gauge_.read(state_), roof_gauge_.start = roof_gauge_.read(state_);
    work_start_ = work();
    note(0.0);
    const double first = options_.rising_step * options_.peak / kappa_;
    for (double stretch = first, step = first; step_to(stretch); stretch += step) step = next_step(step);
    return curve_;
  }

 private:
  void make_gauges(const std::vector<double>& forces) {
    for (std::size_t i = 0; i < forces.size(); ++i)
      load_gauge_.blocks.push_back(i), load_gauge_.weights.push_back(forces[i]);
    roof_gauge_ = load_gauge_;
    if (options_.roof.empty()) return;
    roof_gauge_ = {};
    for (const std::size_t block : options_.roof)
      roof_gauge_.blocks.push_back(block), roof_gauge_.weights.push_back(model_.mass[block]);
  }

  /// J, that a multiplier of 1 works on from the origin.
  double work() const {
    return engine::applied_work(engine::applied_forces(scene_), engine::frames_of(model_, state_, true));
  }
  double displacement() const { return sign_ * (load_gauge_.read(state_) - load_gauge_.start); }
  double roof() const { return sign_ * (roof_gauge_.read(state_) - roof_gauge_.start); }

  bool rest(const engine::Model& model) {
    engine::SettleOptions settle;
    settle.longest_time = options_.trial.longest_time;
    settle.unbalanced_ratio = options_.trial.unbalanced_ratio;
    settle.local_damping = options_.trial.local_damping;
    settle.longest_movement = options_.target;
    const engine::SettleReport report = engine::settle(model, state_, settle);
    unbalanced_ = report.unbalanced_ratio;
    if (report.settled) return true;
    curve_.end =
        report.outcome == engine::Outcome::diverged ? CurveEnd::numerically_invalid : CurveEnd::no_rest;
    curve_.detail = report.detail;
    return false;
  }

  /// Holds the spring's end at s; whether the curve goes on.
  bool step_to(double stretch) {
    const double relief = kappa_ / weight_;  // 1/J
    scene_.fields.applied_relief = relief;
    scene_.fields.applied_factor = relief * work_start_ + kappa_ * stretch;
    if (!rest(engine::compile(scene_))) return false;
    note(kappa_ * (stretch - displacement()));
    return goes_on();
  }

  bool goes_on() {
    const CapacityPoint& last = curve_.points.back();
    if (options_.go_on && !options_.go_on(last.roof / options_.target)) {
      curve_.end = CurveEnd::interrupted;
      return false;
    }
    if (last.multiplier < options_.least_share * curve_.points[curve_.peak()].multiplier) {
      curve_.end = CurveEnd::spent;
      return false;
    }
    return last.roof < options_.target;
  }

  /// While the structure takes what the spring gives, small; once it gives way, up to the greatest.
  double next_step(double step) const {
    if (curve_.points.size() < 2) return step;
    const CapacityPoint &a = curve_.points[curve_.points.size() - 2], &b = curve_.points.back();
    const double gained = (b.multiplier - a.multiplier) / (kappa_ * step);
    if (gained > 0.5) return options_.rising_step * options_.peak / kappa_;
    return std::min(1.5 * step, options_.falling_step * options_.target);
  }

  void note(double multiplier) {
    const std::size_t index = curve_.points.size(), before = curve_.events.size();
    const std::vector<BondDamage> damage = bond_damage(model_, state_);
    for (std::size_t bond = 0; bond < cracked_.size(); ++bond) {
      if (cracked_[bond] || damage[bond].mode.empty()) continue;
      cracked_[bond] = true;
      curve_.events.push_back({bond, index, std::string(damage[bond].mode)});
    }
    std::stable_sort(curve_.events.begin() + static_cast<std::ptrdiff_t>(before), curve_.events.end(),
                     [&](const BondEvent& a, const BondEvent& b) { return width(a.bond) > width(b.bond); });
    curve_.points.push_back({multiplier, displacement(), roof(), unbalanced_, curve_.events.size()});
  }

  /// How far the face has opened or closed (m).
  double width(std::size_t bond) const {
    const auto opened = [&](std::size_t end) {
      const engine::BondHistory& h = history(bond, end);
      return std::max({h.widest, h.plastic, h.crushed});
    };
    return std::max(opened(0), opened(1));
  }
  const engine::BondHistory& history(std::size_t bond, std::size_t end) const {
    return state_.bonds.history[2 * bond + end];
  }
  const PushoverOptions& options_;
  double sign_;
  engine::Scene scene_;  // under the loads
  engine::Model model_;  // without them
  engine::State state_;
  Gauge load_gauge_, roof_gauge_;
  double weight_ = 0.0, kappa_ = 0.0, work_start_ = 0.0;  // N, 1/m, J
  double unbalanced_ = 0.0;
  std::vector<bool> cracked_;  // bonds
  CapacityCurve curve_;
};

}  // namespace

engine::Scene pushed(const engine::Scene& scene, const std::vector<double>& forces, double multiplier,
                     Direction towards) {
  require(forces.size() == scene.bodies.size(), "expected a force for each of " +
                                                    std::to_string(scene.bodies.size()) + " blocks, found " +
                                                    std::to_string(forces.size()));
  engine::Scene loaded = scene;
  for (std::size_t i = 0; i < forces.size(); ++i)
    loaded.bodies[i].applied_force += {sign_of(towards) * multiplier * forces[i], 0.0};
  return loaded;
}

std::string to_string(CurveEnd end) {
  switch (end) {
    case CurveEnd::target:
      return "the target displacement was reached";
    case CurveEnd::spent:
      return "hardly any resistance was left";
    case CurveEnd::no_rest:
      return "no equilibrium was found near by";
    case CurveEnd::numerically_invalid:
      return "the numbers failed";
    case CurveEnd::interrupted:
      return "interrupted";
  }
  return "";
}

std::size_t CapacityCurve::peak() const {
  if (points.empty()) return 0;
  return static_cast<std::size_t>(std::ranges::max_element(points, {}, &CapacityPoint::multiplier) -
                                  points.begin());
}

CapacityCurve capacity_curve(const engine::Scene& scene, const std::vector<double>& forces,
                             const PushoverOptions& options) {
  require(!scene.bodies.empty(), "expected a scene with blocks, found none");
  require(engine::norm(scene.gravity) > 0.0, "expected a scene with gravity, found none");
  require(options.peak > 0.0 && options.target > 0.0, "expected a positive peak and a positive target");
  require(options.stiffness > 0.0 && options.rising_step > 0.0 && options.falling_step > 0.0,
          "expected positive steps and stiffness");
  return Curve(scene, forces, options).run();
}

}  // namespace dougong::structures
