// Who a joint or a bond connects, and where they stand where the scene describes them.
#pragma once

#include <string>
#include <vector>

#include "engine/frame.h"

namespace dougong::engine {

/// Index of an owner among bodies and terrains. Throws std::invalid_argument, naming what asks, when it does
/// not exist.
Index index_of(const Owner& owner, const Model& model, const std::string& asked_by);
/// Frames of the poses that the scene describes; terrains at zero displacement.
std::vector<Frame> described_frames(const Scene& scene, const Model& model);

}  // namespace dougong::engine
