// A plane vector: x right, y up.
#pragma once

#include <cmath>

namespace dougong::engine {

/// Of doubles, or of several at once (lanes.h).
template <class R>
struct VecOf {
  R x{};
  R y{};

  constexpr VecOf& operator+=(VecOf o) { return x += o.x, y += o.y, *this; }
  constexpr VecOf& operator-=(VecOf o) { return x -= o.x, y -= o.y, *this; }
#define DOUGONG_LANEWISE [[gnu::always_inline]] friend constexpr
  DOUGONG_LANEWISE VecOf operator+(VecOf a, VecOf b) {
    return {a.x + b.x, a.y + b.y};
  }
  DOUGONG_LANEWISE VecOf operator-(VecOf a, VecOf b) {
    return {a.x - b.x, a.y - b.y};
  }
  DOUGONG_LANEWISE VecOf operator-(VecOf a) {
    return {-a.x, -a.y};
  }
  DOUGONG_LANEWISE VecOf operator*(R s, VecOf a) {
    return {s * a.x, s * a.y};
  }
  DOUGONG_LANEWISE VecOf operator*(VecOf a, R s) {
    return {s * a.x, s * a.y};
  }
#undef DOUGONG_LANEWISE
  friend constexpr bool operator==(VecOf a, VecOf b) = default;
};

using Vec2 = VecOf<double>;

template <class R>
[[gnu::always_inline]] inline constexpr R dot(VecOf<R> a, VecOf<R> b) {
  return a.x * b.x + a.y * b.y;
}
/// z component of the cross product of two plane vectors.
template <class R>
[[gnu::always_inline]] inline constexpr R cross(VecOf<R> a, VecOf<R> b) {
  return a.x * b.y - a.y * b.x;
}
/// The vector turned by +90 degrees: the velocity field of a unit spin.
template <class R>
[[gnu::always_inline]] inline constexpr VecOf<R> turned(VecOf<R> a) {
  return {-a.y, a.x};
}

inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
inline Vec2 rotated(Vec2 a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

}  // namespace dougong::engine
