// Runs that were never computed: histories that tests make by hand.
#pragma once

#include <functional>
#include <string>

#include "structures/response.h"

namespace dougong::structures {

struct Pose {
  double x, y, angle;
};

/// A run that was never computed: every block follows a given motion from where it stands, on a ground
/// that moves as told.
struct Script {
  Building building;
  double interval = 0.01;
  std::size_t steps = 501;
  std::function<engine::Vec2(double)> ground = [](double) { return engine::Vec2{}; };
  /// Added to the block's starting pose, relative to the ground.
  std::function<Pose(const std::string&, double)> block = [](const std::string&, double) { return Pose{}; };
  std::function<double(const std::string&, double)> acceleration = [](const std::string&, double) {
    return 0.0;
  };
  std::function<double(double)> shear = [](double) { return 0.0; };

  Trajectory trajectory() const {
    Trajectory run;
    run.blocks = building.scene.bodies.size();
    for (std::size_t step = 0; step < steps; ++step) {
      const double t = interval * static_cast<double>(step);
      run.times.push_back(t);
      run.ground_displacement.push_back(ground(t));
      run.ground_reaction.push_back({shear(t), 1.0});
      for (const engine::Body& body : building.scene.bodies) {
        const Pose moved = block(body.name, t);
        run.poses.insert(run.poses.end(),
                         {body.position.x + ground(t).x + moved.x, body.position.y + ground(t).y + moved.y,
                          body.angle + moved.angle});
        run.accelerations.push_back(acceleration(body.name, t));
      }
    }
    return run;
  }
  Response response(const LossCriteria& criteria = {}) const {
    return compute_response(building, trajectory(), criteria);
  }
};

}  // namespace dougong::structures
