// Faces whose contact law cannot give the rocking restitution that is asked for (engine/contact/rocking.h):
// an impact acts between the corner and the middle of a face, and a couple can take no more than all that is
// left.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/state.h"

namespace dougong::app {

class RockingLimits {
 public:
  /// Of the faces that meet in this state and did not before, once a pair of bodies; the first few in words.
  std::vector<std::string> look(const engine::Model& model, const engine::State& state);

 private:
  std::set<engine::BodyPair> seen_;
  std::size_t said_ = 0;
};

}  // namespace dougong::app
