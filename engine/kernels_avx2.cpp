// The kernels with 256-bit vectors.
#include "engine/standard_headers.h"

#if defined(__x86_64__)
#include <immintrin.h>
#pragma GCC target("avx2")
#define DOUGONG_AVX2

#include "engine/kernels_lanes.h"

namespace dougong::engine {

Kernels avx2_kernels() {
  return kernels_with<Real4>("avx2");
}

}  // namespace dougong::engine
#endif
