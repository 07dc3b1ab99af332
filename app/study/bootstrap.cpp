#include "app/study/bootstrap.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/study/spread.h"
#include "seismic/synthesis/random.h"

namespace dougong::app {
namespace {

using Groups = std::vector<std::vector<double>>;

std::vector<double> means_of(const Groups& groups) {
  std::vector<double> means;
  for (const auto& group : groups) means.push_back(mean_of(group));
  return means;
}

// The draws of one resample.
class Draws {
 public:
  Draws(std::uint64_t seed, std::size_t resample) : seed_(seed), resample_(resample) {}
  double mean(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[static_cast<std::size_t>(n * seismic::uniform_number(seed_, resample_, next_++))];
    return sum / n;
  }

 private:
  std::uint64_t seed_, resample_, next_ = 0;
};

struct Size {
  double n, freedom;
};

Size size_of(const Groups& groups, Resampled what) {
  const auto g = static_cast<double>(groups.size());
  if (what == Resampled::groups) return {g, g - 1.0};
  std::size_t least = groups.front().size(), all = 0;
  for (const auto& group : groups) least = std::min(least, group.size()), all += group.size();
  return {static_cast<double>(least), static_cast<double>(all) - g};
}

double tail_of(Size size) {
  constexpr double upper = 0.975;
  return gsl_cdf_ugaussian_P(-std::sqrt(size.n / (size.n - 1.0)) * gsl_cdf_tdist_Pinv(upper, size.freedom));
}

Resampled what_to_resample(const Groups& groups) {
  if (groups.size() >= least_resampled) return Resampled::groups;
  const bool enough =
      std::ranges::all_of(groups, [](const auto& group) { return group.size() >= least_resampled; });
  return enough && !groups.empty() ? Resampled::values : Resampled::nothing;
}

double resampled_mean(const Groups& groups, const std::vector<double>& means, Resampled what, Draws draws) {
  if (what == Resampled::groups) return draws.mean(means);
  double sum = 0.0;
  for (const auto& group : groups) sum += draws.mean(group);
  return sum / static_cast<double>(groups.size());
}

}  // namespace

MeanInterval bootstrap_mean(Groups groups, std::uint64_t seed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  MeanInterval interval{nan, nan, nan, what_to_resample(groups)};
  if (groups.empty()) return interval;
  const std::vector<double> means = means_of(groups);
  interval.mean = mean_of(means);
  if (interval.resampled == Resampled::nothing) return interval;
  std::vector<double> found(resamples);
  for (std::size_t i = 0; i < resamples; ++i)
    found[i] = resampled_mean(groups, means, interval.resampled, Draws(seed, i));
  std::sort(found.begin(), found.end());
  const double tail = tail_of(size_of(groups, interval.resampled));
  interval.low = quantile(found, tail), interval.high = quantile(found, 1.0 - tail);
  return interval;
}

}  // namespace dougong::app
