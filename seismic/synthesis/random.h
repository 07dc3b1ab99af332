// Random numbers of the synthesis: counted, not remembered, so that any one can be had by itself.
//
// The i-th number of a stream is a hash of (seed, stream, i): SplitMix64's finaliser (Steele, Lea & Flood
// 2014) on a counter. Gaussians by Box & Muller (1958).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dougong::seismic {

/// Uniform in (0, 1), 53 bits.
double uniform_number(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// `count` independent standard normal numbers.
std::vector<double> gaussian_noise(std::uint64_t seed, std::uint64_t stream, std::size_t count);

}  // namespace dougong::seismic
