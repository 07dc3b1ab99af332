// Rows of blocks that do not fit the caches come from memory, and working on one takes less time than
// fetching it: so it is asked for some blocks ahead.
#pragma once

#include <cstddef>

namespace dougong::engine {

constexpr std::size_t fetched_ahead = 4;                  // blocks
constexpr std::size_t room_in_caches = 24 * 1024 * 1024;  // bytes, of the last level

template <class Block>
constexpr bool outgrow_the_caches(std::size_t blocks) {
  return blocks * sizeof(Block) > room_in_caches;
}

template <class Block>
[[gnu::always_inline]] inline void fetch(const Block& block) {
  const char* const lines = reinterpret_cast<const char*>(&block);
  for (std::size_t k = 0; k < sizeof(Block); k += 64) __builtin_prefetch(lines + k);
}

}  // namespace dougong::engine
