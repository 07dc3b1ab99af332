// How far a mean of differences may be from the one that many more runs would have: the bootstrap.
//
// The statistic is the mean of the groups' means, d = mean_g(mean_m(d[g][m])); a group is a record, its
// values the members of the ensemble. It is computed again for many resamples, drawn with replacement, and
// the interval lies between two quantiles of them:
//
//   alpha' = Phi(-sqrt(n/(n-1)) t(1 - alpha/2; f))    alpha = 5 %
//
// in place of alpha/2, which for few values is too narrow: the spread of a resample is that of n, not n - 1,
// and its ends are those of a normal distribution, not of t. Expanded percentile interval: Hesterberg,
// American Statistician 69 (2015) 371-386, section 4.3. What is resampled depends on what there is:
//
//   groups   n groups of any size: groups are drawn, f = n - 1. Speaks of records like these.
//   values   within every group, n the least number of values in one, f = sum(n_g - 1). Speaks of these
//            records only, under the changes of the ensemble.
//   nothing  too few of both: no interval
#pragma once

#include <cstdint>
#include <vector>

namespace dougong::app {

enum class Resampled { nothing, values, groups };

struct MeanInterval {
  double mean = 0.0;             // not a number without values
  double low = 0.0, high = 0.0;  // 95 %; not numbers where nothing is resampled
  Resampled resampled = Resampled::nothing;
};

inline constexpr std::size_t least_resampled = 5;  // groups, or values in every group
inline constexpr std::size_t resamples = 9999;

/// Groups without values are left out. The draws are counted numbers of (seed, resample): the same for the
/// same arguments.
MeanInterval bootstrap_mean(std::vector<std::vector<double>> groups, std::uint64_t seed = 1);

}  // namespace dougong::app
