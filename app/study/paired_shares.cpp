#include "app/study/paired_shares.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/study/spread.h"

namespace dougong::app {
namespace {

// Of the two answers, less what chance makes of counts (Newcombe's continuity correction).
double correlation(const PairedCounts& c) {
  const auto a = static_cast<double>(c.both), b = static_cast<double>(c.first),
             d = static_cast<double>(c.second), e = static_cast<double>(c.neither);
  const double product = (a + b) * (d + e) * (a + d) * (b + e);
  if (product == 0.0) return 0.0;
  const double excess = a * e - b * d, half = 0.5 * static_cast<double>(c.pairs());
  return (excess > half ? excess - half : std::min(excess, 0.0)) / std::sqrt(product);
}

double joined_length(double x, double y, double phi) {
  return std::sqrt(std::max(0.0, x * x - 2.0 * phi * x * y + y * y));
}

// Twice the smaller tail of the binomial distribution with equal chances.
double mcnemar(const PairedCounts& c) {
  const auto n = static_cast<unsigned>(c.first + c.second);
  if (n == 0) return 1.0;
  const auto fewer = static_cast<unsigned>(std::min(c.first, c.second));
  return std::min(1.0, 2.0 * gsl_cdf_binomial_P(fewer, 0.5, n));
}

}  // namespace

PairedShares compare_shares(const PairedCounts& c) {
  PairedShares shares;
  shares.difference = std::numeric_limits<double>::quiet_NaN();
  if (c.pairs() == 0) return shares;
  const Share one = share_of(c.both + c.first, c.pairs()), two = share_of(c.both + c.second, c.pairs());
  const double phi = correlation(c);
  shares.difference = two.value() - one.value();
  shares.low = shares.difference - joined_length(two.value() - two.low, one.high - one.value(), phi);
  shares.high = shares.difference + joined_length(two.high - two.value(), one.value() - one.low, phi);
  shares.p_value = mcnemar(c);
  return shares;
}

}  // namespace dougong::app
