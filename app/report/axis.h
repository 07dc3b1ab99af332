// Round numbers for axes.
#pragma once

#include <vector>

namespace dougong::app {

/// 1, 2 or 5 times a power of ten, so that the span has about `count` steps.
double round_step(double span, int count);
/// The largest of 1, 2, 5 times a power of ten not above the value.
double round_below(double value);
/// The end of a colour scale: the next number above of one or one and a half digits.
double round_up(double value);

struct Range {
  double low = 0.0, high = 0.0;
  double span() const { return high - low; }
};

/// Smallest and largest finite value; {0, 0} when there is none.
Range range_of(const std::vector<double>& values);
Range joined(Range a, Range b);
/// Room of a share of the span on both sides; a flat range becomes value ± `flat`.
Range padded(Range range, double share, double flat);

}  // namespace dougong::app
