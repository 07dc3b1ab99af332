#include "seismic/formats/even_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dougong::seismic {
namespace {

constexpr double most_jitter = 0.25;         // of a step
constexpr double drift_of_a_clock = 5e-4;    // relative
constexpr double most_stray = 2e-3;          // of the record's length
constexpr std::size_t most_stretching = 20;  // samples made of one

// Greatest departure of times from index `first` on from equal steps (s).
double departure(const std::vector<double>& times, std::size_t first) {
  const std::size_t last = times.size() - 1;
  const double step = (times[last] - times[first]) / static_cast<double>(last - first);
  double worst = 0.0;
  for (std::size_t k = first; k <= last; ++k)
    worst = std::max(worst, std::abs(times[k] - times[first] - step * static_cast<double>(k - first)));
  return worst;
}

double mean_step(const std::vector<double>& times, std::size_t first) {
  return (times.back() - times[first]) / static_cast<double>(times.size() - 1 - first);
}

// Steps alike one by one, whatever they add up to.
bool keeps_pace(const std::vector<double>& times) {
  const double usual = mean_step(times, 0), jitter = most_jitter * usual * (1.0 + 1e-9);
  std::size_t shorter = 0;
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double step = times[k] - times[k - 1];
    if (step > usual + jitter) return false;
    if (step < usual - jitter) ++shorter;
  }
  return shorter <= times.size() / 1000 && departure(times, 0) <= most_stray * (times.back() - times.front());
}

EvenSeries as_they_are(const std::vector<double>& times, std::vector<double> values, std::size_t first) {
  EvenSeries series;
  const double step = mean_step(times, first);
  series.interval = plain_interval(step, drift_of_a_clock);
  series.values = std::move(values);
  const double drift = std::abs(series.interval - step) * static_cast<double>(times.size() - 1);
  const double stray = departure(times, first);
  if (std::max(drift, stray) > 0.5 * step)
    series.warnings.push_back(fmt::format(
        "the times are {:.6g} s apart on average, {:.6g} s is used; they stray from equal steps by up "
        "to {:.2g} s",
        step, series.interval, std::max(drift, stray)));
  if (first > 0)
    series.warnings.push_back(fmt::format("the first step is {:.6g} s, the others are {:.6g} s: used for all",
                                          times[1] - times[0], series.interval));
  return series;
}

// Largest of 1, 2, 5 x 10^k not above `step`.
double plain_below(double step) {
  const double decade = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  for (const double digit : {5.0, 2.0})
    if (digit * decade <= step * (1.0 + 1e-9)) return digit * decade;
  return decade;
}

double greatest(const std::vector<double>& values) {
  double top = 0.0;
  for (const double value : values) top = std::max(top, std::abs(value));
  return top;
}

std::vector<double> interpolated(const std::vector<double>& times, const std::vector<double>& values,
                                 double interval, std::size_t count) {
  std::vector<double> out;
  out.reserve(count);
  std::size_t k = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = std::min(times.front() + interval * static_cast<double>(i), times.back());
    while (k + 2 < times.size() && times[k + 1] < t) ++k;
    const double share = (t - times[k]) / (times[k + 1] - times[k]);
    out.push_back(values[k] + share * (values[k + 1] - values[k]));
  }
  return out;
}

}  // namespace

std::optional<std::size_t> first_time_back(const std::vector<double>& times) {
  for (std::size_t k = 1; k < times.size(); ++k)
    if (!(times[k] > times[k - 1])) return k;
  return std::nullopt;
}

std::optional<EvenSeries> to_even_steps(const std::vector<double>& times, std::vector<double> values,
                                        std::optional<double> interval) {
  const bool even = departure(times, 0) <= most_jitter * mean_step(times, 0) || keeps_pace(times);
  const bool first_differs =
      !even && times.size() > 3 && departure(times, 1) <= most_jitter * mean_step(times, 1);
  if (even || first_differs) {
    EvenSeries series = as_they_are(times, std::move(values), first_differs ? 1 : 0);
    if (!interval || std::abs(*interval - series.interval) <= 1e-6 * series.interval) return series;
    values = std::move(series.values);
  }
  double shortest = times[1] - times[0], longest = shortest;
  for (std::size_t k = 1; k < times.size(); ++k) {
    shortest = std::min(shortest, times[k] - times[k - 1]);
    longest = std::max(longest, times[k] - times[k - 1]);
  }
  const double step = interval.value_or(plain_below(shortest));
  const double samples = std::floor((times.back() - times.front()) / step * (1.0 + 1e-12)) + 1.0;
  if (!(step > 0.0) || !(samples <= static_cast<double>(most_stretching * times.size()))) return std::nullopt;
  EvenSeries series;
  series.interval = step;
  series.values = interpolated(times, values, step, static_cast<std::size_t>(samples));
  series.steps.push_back(fmt::format(
      "read: {} samples {:.6g} to {:.6g} s apart resampled to {} every {:.6g} s, linear between them; peak "
      "{:.6g} before, {:.6g} after (in the file's units)",
      times.size(), shortest, longest, series.values.size(), step, greatest(values),
      greatest(series.values)));
  return series;
}

double plain_interval(double step, double tolerance) {
  const auto is_near = [&](double plain) {
    return plain > 0.0 && std::abs(plain - step) <= tolerance * step;
  };
  // Few decimals first (0.005), then whole rates (1/128), then many decimals.
  for (double scale = 1e2; scale <= 1e4; scale *= 10.0)
    if (const double plain = std::round(step * scale) / scale; is_near(plain)) return plain;
  if (const double plain = 1.0 / std::max(1.0, std::round(1.0 / step)); is_near(plain)) return plain;
  for (double scale = 1e5; scale <= 1e7; scale *= 10.0)
    if (const double plain = std::round(step * scale) / scale; is_near(plain)) return plain;
  return step;
}

}  // namespace dougong::seismic
