// How often the free store was asked, in this program.
#pragma once

#include <cstddef>

namespace dougong::testing {

std::size_t allocations();

}  // namespace dougong::testing
