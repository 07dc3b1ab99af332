// The moment at which something ends, by bisection down to rounding.
#pragma once

namespace dougong::oracles {

/// A moment between: it holds at `before` and no more at `after`.
struct Moment {
  double before, after;
};

/// `holds` at low and not at high.
template <class Holds>
Moment last_time(Holds holds, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return {low, high};
}

}  // namespace dougong::oracles
