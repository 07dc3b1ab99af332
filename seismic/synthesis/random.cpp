#include "seismic/synthesis/random.h"

#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace

double uniform_number(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  const std::uint64_t key = mixed(seed * golden + mixed(stream + golden));
  const std::uint64_t bits = mixed(key + (index + 1) * golden) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1.0p-53;
}

std::vector<double> gaussian_noise(std::uint64_t seed, std::uint64_t stream, std::size_t count) {
  std::vector<double> noise(count);
  for (std::size_t i = 0; i < count; i += 2) {
    const double radius = std::sqrt(-2.0 * std::log(uniform_number(seed, stream, i)));
    const double angle = two_pi * uniform_number(seed, stream, i + 1);
    noise[i] = radius * std::cos(angle);
    if (i + 1 < count) noise[i + 1] = radius * std::sin(angle);
  }
  return noise;
}

}  // namespace dougong::seismic
