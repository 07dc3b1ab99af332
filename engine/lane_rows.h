// Rows and columns of lanes: loads, stores, shuffles and transposes. For kernels only (kernels.h): nothing of
// it may be left to the linker, which would take one instruction set's function for all.
#pragma once

#include <utility>

#include "engine/lanes.h"

namespace dougong::engine {
namespace {

#define DOUGONG_INLINE [[gnu::always_inline]] inline

// Consecutive numbers from a column, or a row of them.
template <class R>
DOUGONG_INLINE R load_row(const double* from) {
  R v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class R>
DOUGONG_INLINE void store_row(double* to, R v) {
  __builtin_memcpy(to, &v, sizeof v);
}
// Lane k of the result is lane source(k) of `a` followed by `b`.
template <auto source, class V, int... k>
DOUGONG_INLINE V shuffled(V a, V b, std::integer_sequence<int, k...>) {
  return __builtin_shufflevector(a, b, source(k)...);
}
template <auto source, class V>
DOUGONG_INLINE V shuffled(V a, V b) {
  return shuffled<source>(a, b, std::make_integer_sequence<int, lanes_of<V>>{});
}
// The other point of the pair; that in the even place; that in the odd one.
template <class V>
DOUGONG_INLINE V partners(V v) {
  return shuffled<[](int k) { return k ^ 1; }>(v, v);
}
template <class V>
DOUGONG_INLINE V evens(V v) {
  return shuffled<[](int k) { return k & ~1; }>(v, v);
}
template <class V>
DOUGONG_INLINE V odds(V v) {
  return shuffled<[](int k) { return k | 1; }>(v, v);
}
// The lanes of one in even places, of the other in odd ones.
template <class V>
DOUGONG_INLINE V alternate(V even, V odd) {
  return shuffled<[](int k) { return k % 2 == 0 ? k : k + lanes_of<V>; }>(even, odd);
}

// Flags, 0 or 1, a byte each.
template <class R>
struct FlagsOf {
  using Bytes [[gnu::vector_size(lanes_of<R>)]] = unsigned char;
  using Integers [[gnu::vector_size(4 * lanes_of<R>)]] = int;
};
// Bytes to integers is by intrinsics where there are any: GCC 12 converts one byte after the other.
template <class R>
DOUGONG_INLINE R load_flags(const unsigned char* from) {
  using Integers = typename FlagsOf<R>::Integers;
#if defined(DOUGONG_AVX512) || defined(DOUGONG_AVX2)
  if constexpr (lanes_of<R> == 8)
    return __builtin_convertvector(Integers(_mm256_cvtepu8_epi32(_mm_loadu_si64(from))), R);
  if constexpr (lanes_of<R> == 4)
    return __builtin_convertvector(Integers(_mm_cvtepu8_epi32(_mm_loadu_si32(from))), R);
#endif
  typename FlagsOf<R>::Bytes bytes;
  __builtin_memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(__builtin_convertvector(bytes, Integers), R);
}
template <class R>
DOUGONG_INLINE void store_flags(unsigned char* to, R flags) {
  const auto bytes = __builtin_convertvector(__builtin_convertvector(flags, typename FlagsOf<R>::Integers),
                                             typename FlagsOf<R>::Bytes);
  __builtin_memcpy(to, &bytes, sizeof bytes);
}

// A number a pair, for both its points; and what its first points hold.
DOUGONG_INLINE Real2 doubled(const double* from, Real2) {
  return all_lanes<Real2>(*from);
}
DOUGONG_INLINE Real4 doubled(const double* from, Real4) {
  const Real2 v = load_row<Real2>(from);
  return __builtin_shufflevector(v, v, 0, 0, 1, 1);
}
DOUGONG_INLINE Real8 doubled(const double* from, Real8) {
  const Real4 v = load_row<Real4>(from);
  return __builtin_shufflevector(v, v, 0, 0, 1, 1, 2, 2, 3, 3);
}
DOUGONG_INLINE void store_evens(double* to, Real2 v) {
  *to = v[0];
}
DOUGONG_INLINE void store_evens(double* to, Real4 v) {
  store_row(to, Real2(__builtin_shufflevector(v, v, 0, 2)));
}
DOUGONG_INLINE void store_evens(double* to, Real8 v) {
  store_row(to, Real4(__builtin_shufflevector(v, v, 0, 2, 4, 6)));
}

DOUGONG_INLINE void transpose(Real4& a, Real4& b, Real4& c, Real4& d) {
  const Real4 ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6),
              ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Real4 cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6),
              cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5), b = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7), d = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

DOUGONG_INLINE void transpose(Real8& r0, Real8& r1, Real8& r2, Real8& r3, Real8& r4, Real8& r5, Real8& r6,
                              Real8& r7) {
  const auto low = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 0, 8, 2, 10, 4, 12, 6, 14);
  };
  const auto high = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 1, 9, 3, 11, 5, 13, 7, 15);
  };
  const Real8 t0 = low(r0, r1), t1 = high(r0, r1), t2 = low(r2, r3), t3 = high(r2, r3), t4 = low(r4, r5),
              t5 = high(r4, r5), t6 = low(r6, r7), t7 = high(r6, r7);
  const auto first = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 0, 1, 8, 9, 4, 5, 12, 13);
  };
  const auto second = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 2, 3, 10, 11, 6, 7, 14, 15);
  };
  const Real8 u0 = first(t0, t2), u1 = first(t1, t3), u2 = second(t0, t2), u3 = second(t1, t3),
              u4 = first(t4, t6), u5 = first(t5, t7), u6 = second(t4, t6), u7 = second(t5, t7);
  const auto lower = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 0, 1, 2, 3, 8, 9, 10, 11);
  };
  const auto upper = [] [[gnu::always_inline]] (Real8 p, Real8 q) {
    return __builtin_shufflevector(p, q, 4, 5, 6, 7, 12, 13, 14, 15);
  };
  r0 = lower(u0, u4), r1 = lower(u1, u5), r2 = lower(u2, u6), r3 = lower(u3, u7);
  r4 = upper(u0, u4), r5 = upper(u1, u5), r6 = upper(u2, u6), r7 = upper(u3, u7);
}

#undef DOUGONG_INLINE

}  // namespace
}  // namespace dougong::engine
