#include "tests/bench/peers/drivers.h"

namespace dougong::peers {
namespace {

// The empty one ends the list where no library was found.
constexpr PeerKind table[] = {
#ifdef DOUGONG_BOX2D
    {"Box2D " DOUGONG_BOX2D, "100 units a metre; 8 velocity, 3 position iterations", box2d},
#endif
#ifdef DOUGONG_CHIPMUNK
    {"Chipmunk " DOUGONG_CHIPMUNK, "collision slop 0.05 mm; 10 iterations", chipmunk},
#endif
#ifdef DOUGONG_BULLET
    {"Bullet " DOUGONG_BULLET, "3D, linear and angular factors; 10 iterations", bullet},
#endif
#ifdef DOUGONG_ODE
    {"ODE " DOUGONG_ODE, "3D, plane2d joints; quick step, 20 iterations", ode},
#endif
    {"", "", nullptr},
};

}  // namespace

std::span<const PeerKind> peers() {
  return {table, std::size(table) - 1};
}

}  // namespace dougong::peers
