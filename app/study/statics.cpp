#include "app/study/statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

using structures::Direction;

void check(StaticResult& r, const Scenario& scenario) {
  r.building = building_of(scenario);
  r.findings = checked_findings(r.building);
  const auto& bodies = r.building.scene.bodies;
  const auto forced = std::ranges::find_if(
      bodies, [](const engine::Body& body) { return body.applied_force != engine::Vec2{}; });
  if (forced != bodies.end())
    throw ModelError(forced->name + ": expected a building without forces of its own, found one");
  r.model = model_sheet(r.building);
  r.weight = r.model.mass * engine::norm(r.building.scene.gravity);
}

/// The storey whose floor is the highest; of neighbours the higher one's.
const structures::Storey& roof_of(const structures::Building& building) {
  return *std::ranges::max_element(
      building.storeys, {}, [](const structures::Storey& storey) { return storey.base + storey.height; });
}

class Analysis {
 public:
  Analysis(StaticResult& result, const std::function<bool(const StaticProgress&)>& progress)
      : r_(result), progress_(progress), scene_(result.building.scene) {
    if (r_.choice.pattern) forces_ = forces_at_rest();
  }

  void run() {
    for (const Direction side : r_.choice.sides) {
      if (r_.interrupted) return;
      r_.sides.push_back({side, {}, {}, {}});
      bracket(r_.sides.back());
      if (r_.choice.pattern && !r_.interrupted) follow(r_.sides.back());
    }
  }

 private:
  std::vector<double> forces_at_rest() const {
    const engine::Model model = engine::compile(scene_);
    engine::State state = engine::initial_state(model, scene_);
    engine::settle(model, state);
    return structures::pattern_forces(model, state, *r_.choice.pattern);
  }

  engine::Scene loaded(double multiplier, Direction side) const {
    return r_.choice.pattern ? structures::pushed(scene_, forces_, multiplier, side)
                             : structures::tilted(scene_, multiplier, side);
  }

  bool tell(Direction side, const std::string& doing, double of_side) {
    if (!progress_) return true;
    const double done = static_cast<double>(r_.sides.size()) - 1.0 + of_side;
    const bool go_on = progress_({side, doing, done / static_cast<double>(r_.choice.sides.size())});
    r_.interrupted |= !go_on;
    return go_on;
  }

  void bracket(SideResult& s) {
    structures::TiltOptions options;
    options.towards = s.side;
    options.first_increment = r_.choice.first_step;
    options.largest = r_.choice.largest;
    options.precision = r_.choice.precision;
    options.trial.hold_time = r_.choice.hold_time;
    std::size_t trials = 0;
    options.go_on = [&](const structures::Trial& trial) {
      ++trials;
      return tell(s.side,
                  fmt::format("trial {}: λ = {:.4f} {}", trials, trial.multiplier, to_string(trial.result)),
                  (r_.choice.pattern ? 0.5 : 1.0) * (1.0 - std::exp(-static_cast<double>(trials) / 12.0)));
    };
    s.found = structures::find_collapse_multiplier(
        scene_, [&](double multiplier) { return loaded(multiplier, s.side); }, options);
    s.mechanism = structures::mechanism_of(engine::compile(scene_), s.found.standing, s.found.mechanism);
  }

  void follow(SideResult& s) {
    if (s.found.stands <= 0.0) return;
    structures::PushoverOptions options;
    options.towards = s.side;
    options.peak = s.found.stands;
    options.target = r_.choice.target_drift * r_.height;
    if (!r_.building.storeys.empty()) options.roof = roof_of(r_.building).level_blocks;
    options.go_on = [&](double share) {
      return tell(s.side, fmt::format("capacity curve: {:.0f} % of the target", 100.0 * share),
                  0.5 + 0.5 * std::clamp(share, 0.0, 1.0));
    };
    s.curve = structures::capacity_curve(scene_, forces_, options);
  }

  StaticResult& r_;
  const std::function<bool(const StaticProgress&)>& progress_;
  const engine::Scene& scene_;
  std::vector<double> forces_;  // N, of a pushover
};

double height_of(const structures::Building& building) {
  if (building.storeys.empty()) return 1.0;
  const structures::Storey& roof = roof_of(building);
  return roof.base + roof.height - building.storeys.front().base;
}

}  // namespace

std::string kind_of(const StaticChoice& choice) {
  return choice.pattern ? "pushover" : "tilt";
}

std::string to_string(Direction side) {
  return side == Direction::left ? "left" : "right";
}

StaticResult run_statics(const Scenario& scenario, const StaticChoice& choice,
                         const std::function<bool(const StaticProgress&)>& progress) {
  StaticResult result;
  result.choice = choice;
  check(result, scenario);
  result.height = height_of(result.building);
  Analysis(result, progress).run();
  return result;
}

}  // namespace dougong::app
