// What can be said of a number that several runs gave, and of an event that some of them had.
#pragma once

#include <cstddef>
#include <vector>

namespace dougong::app {

/// Of the values that are numbers; all not a number when there is none.
struct Spread {
  std::size_t count = 0;
  double least = 0.0, low = 0.0, median = 0.0, high = 0.0, most = 0.0;  // low, high: 16 and 84 %
};
/// Quantiles by linear interpolation between the sorted values: Hyndman and Fan, American Statistician 50
/// (1996) 361-365, definition 7.
Spread spread_of(std::vector<double> values);
/// Not a number of none.
double mean_of(const std::vector<double>& values);
double quantile(const std::vector<double>& sorted, double part);

/// A share of so many trials with its interval of 95 %: Wilson, J. Am. Stat. Assoc. 22 (1927) 209-212.
/// Without trials anything from 0 to 1 is possible.
struct Share {
  std::size_t events = 0, trials = 0;
  double low = 0.0, high = 1.0;
  double value() const {
    return trials > 0 ? static_cast<double>(events) / static_cast<double>(trials) : 0.0;
  }
};
Share share_of(std::size_t events, std::size_t trials);

}  // namespace dougong::app
