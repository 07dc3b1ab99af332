// What a scene says that is accepted and perhaps not meant: bodies that overlap at the start, outputs at
// other times, keys that make no difference here. Keys that contradict what stands beside them are errors
// instead (scene_ignored.h).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/study/scene_run.h"

namespace dougong::app {

/// Of a scene that is compiled and at its start.
std::vector<std::string> findings_of(const PreparedScene& scene);

/// Faces whose contact law cannot give the rocking restitution that is asked for (engine/contact/rocking.h),
/// once a pair of bodies.
class RockingLimits {
 public:
  /// Of the faces that meet in this state and did not before.
  std::vector<std::string> look(const engine::Model& model, const engine::State& state);

 private:
  std::set<engine::BodyPair> seen_;
};

}  // namespace dougong::app
