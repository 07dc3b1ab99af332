#include "engine/kernels.h"

#include <vector>

#include "engine/kernels_lanes.h"

namespace dougong::engine {
namespace {

std::vector<Kernels> find_kernels() {
  std::vector<Kernels> kernels{kernels_with<Real4>("plain")};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2_kernels());
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    kernels.push_back(avx512_kernels());
#endif
  return kernels;
}

}  // namespace

std::span<const Kernels> supported_kernels() {
  static const std::vector<Kernels> kernels = find_kernels();
  return kernels;
}

const Kernels& best_kernels() {
  static const Kernels best = supported_kernels().back();
  return best;
}

}  // namespace dougong::engine
