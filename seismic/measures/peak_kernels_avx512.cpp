// The recursion with 512-bit vectors.
#include "seismic/measures/peak_kernels.h"

#if defined(__x86_64__)
#include <immintrin.h>

#include <span>
#include <vector>
#pragma GCC target("avx512f")

#include "seismic/measures/peak_lanes.h"

namespace dougong::seismic {
namespace {

struct Avx512 {
  using Lanes [[gnu::vector_size(64)]] = double;
  static constexpr std::size_t side_by_side = 4;
  [[gnu::always_inline]] static Lanes magnitude(Lanes x) { return _mm512_abs_pd(x); }
  // Masked, since g++ 12 warns of the unmasked form (GCC bug 105593).
  [[gnu::always_inline]] static Lanes larger(Lanes a, Lanes b) { return _mm512_maskz_max_pd(0xff, a, b); }
  [[gnu::always_inline]] static void put(Lanes& to, std::size_t lane, double value) { to[lane] = value; }
  [[gnu::always_inline]] static double get(const Lanes& from, std::size_t lane) { return from[lane]; }
};

}  // namespace

PeakKernel avx512_peak_kernel() {
  return PeakLanes<Avx512>::kernel("avx512");
}

}  // namespace dougong::seismic
#endif
