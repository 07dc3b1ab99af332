// Several doubles at once, by the compiler's vector extension: one source for every instruction set, lane by
// lane the bits that a double alone gives (no contraction, no reassociation).
//
// A kernel is a template on the type R of its numbers: double, Real2, Real4 or Real8. All of it must be
// inlined, since functions compiled for different instruction sets pass such vectors in different registers.
#pragma once

#if defined(DOUGONG_AVX512) || defined(DOUGONG_AVX2)
#include <immintrin.h>
#endif

namespace dougong::engine {

using Real2 [[gnu::vector_size(16)]] = double;
using Real4 [[gnu::vector_size(32)]] = double;
using Real8 [[gnu::vector_size(64)]] = double;

template <class R>
inline constexpr int lanes_of = static_cast<int>(sizeof(R) / sizeof(double));

template <class R>
[[gnu::always_inline]] inline R all_lanes(double value) {
  return R{} + value;
}

// Choices by lane. Conditions that are kept are flags, 0 or 1 of the type R: comparing and choosing at once
// is what every instruction set can do.
template <class R>
[[gnu::always_inline]] inline R where_less(R a, R b, R yes, R no) {
#if defined(DOUGONG_AVX512)
  if constexpr (lanes_of<R> == 8)
    return _mm512_mask_blend_pd(_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ), no, yes);
  else if constexpr (lanes_of<R> == 4)
    return _mm256_mask_blend_pd(_mm256_cmp_pd_mask(a, b, _CMP_LT_OQ), no, yes);
  else if constexpr (lanes_of<R> == 2)
    return _mm_mask_blend_pd(_mm_cmp_pd_mask(a, b, _CMP_LT_OQ), no, yes);
  else
#endif
    return a < b ? yes : no;
}
template <class R>
[[gnu::always_inline]] inline R where_positive(R a, R yes, R no) {
  return where_less(R{}, a, yes, no);
}
template <class R>
[[gnu::always_inline]] inline R where(R flag, R yes, R no) {
  return where_positive(flag, yes, no);
}
/// Whether any lane is positive.
template <class R>
[[gnu::always_inline]] inline bool any_positive(R a) {
#if defined(DOUGONG_AVX512)
  if constexpr (lanes_of<R> == 8) return _mm512_cmp_pd_mask(R{}, a, _CMP_LT_OQ) != 0;
  if constexpr (lanes_of<R> == 4) return _mm256_cmp_pd_mask(R{}, a, _CMP_LT_OQ) != 0;
  if constexpr (lanes_of<R> == 2) return _mm_cmp_pd_mask(R{}, a, _CMP_LT_OQ) != 0;
#endif
#if defined(DOUGONG_AVX2)
  if constexpr (lanes_of<R> == 4) return _mm256_movemask_pd(_mm256_cmp_pd(R{}, a, _CMP_LT_OQ)) != 0;
#endif
  if constexpr (lanes_of<R> == 1) {
    return a > 0.0;
  } else {
    bool any = false;
    for (int k = 0; k < lanes_of<R>; ++k) any |= a[k] > 0.0;
    return any;
  }
}
/// As std::min and std::max, which is how the instructions treat equal and missing numbers too; they answer
/// in a third of the time that comparing into a mask and choosing by it takes.
template <class R>
[[gnu::always_inline]] inline R lesser(R a, R b) {
#if defined(DOUGONG_AVX512)
  if constexpr (lanes_of<R> == 8) return _mm512_min_pd(b, a);
#endif
#if defined(DOUGONG_AVX512) || defined(DOUGONG_AVX2)
  if constexpr (lanes_of<R> == 4) return _mm256_min_pd(b, a);
  if constexpr (lanes_of<R> == 2) return _mm_min_pd(b, a);
#endif
  return where_less(b, a, b, a);
}
template <class R>
[[gnu::always_inline]] inline R greater(R a, R b) {
#if defined(DOUGONG_AVX512)
  if constexpr (lanes_of<R> == 8) return _mm512_max_pd(b, a);
#endif
#if defined(DOUGONG_AVX512) || defined(DOUGONG_AVX2)
  if constexpr (lanes_of<R> == 4) return _mm256_max_pd(b, a);
  if constexpr (lanes_of<R> == 2) return _mm_max_pd(b, a);
#endif
  return where_less(a, b, b, a);
}
/// As std::fabs: without the sign bit.
template <class R>
[[gnu::always_inline]] inline R magnitude(R a) {
  if constexpr (lanes_of<R> == 1) {
    return __builtin_fabs(a);
  } else {
    using Bits [[gnu::vector_size(sizeof(R))]] = long long;
    return R(Bits(a) & 0x7fff'ffff'ffff'ffff);
  }
}

}  // namespace dougong::engine
