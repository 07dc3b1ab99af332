// The kernels with 512-bit vectors.
#include "engine/standard_headers.h"

#if defined(__x86_64__)
#include <immintrin.h>
#pragma GCC target("avx512f,avx512dq,avx512vl")
#define DOUGONG_AVX512
// GCC 12 takes the operands that its own intrinsics leave out for uninitialized (its bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "engine/kernels_lanes.h"

namespace dougong::engine {

Kernels avx512_kernels() {
  return kernels_with<Real8>("avx512");
}

}  // namespace dougong::engine
#endif
