// The recursion with 256-bit vectors.
#include "seismic/measures/peak_kernels.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <span>
#include <vector>
#pragma GCC target("avx2")

#include "seismic/measures/peak_lanes.h"

namespace dougong::seismic {
namespace {

struct Avx2 {
  using Lanes [[gnu::vector_size(32)]] = double;
  static constexpr std::size_t side_by_side = 3;
  [[gnu::always_inline]] static Lanes magnitude(Lanes x) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x); }
  [[gnu::always_inline]] static Lanes larger(Lanes a, Lanes b) { return _mm256_max_pd(a, b); }
  [[gnu::always_inline]] static void put(Lanes& to, std::size_t lane, double value) { to[lane] = value; }
  [[gnu::always_inline]] static double get(const Lanes& from, std::size_t lane) { return from[lane]; }
};

}  // namespace

PeakKernel avx2_peak_kernel() {
  return PeakLanes<Avx2>::kernel("avx2");
}

}  // namespace dougong::seismic
#endif
