// The drivers, each in a file of its own that is compiled where its library is present.
#pragma once

#include "tests/bench/peers/peer.h"

namespace dougong::peers {

std::unique_ptr<Peer> box2d(const Wall& wall);
std::unique_ptr<Peer> chipmunk(const Wall& wall);
std::unique_ptr<Peer> bullet(const Wall& wall);
std::unique_ptr<Peer> ode(const Wall& wall);

}  // namespace dougong::peers
