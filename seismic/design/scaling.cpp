#include "seismic/design/scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dougong::seismic {
namespace {

double least_ratio(std::span<const double> spectrum, std::span<const double> target) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < target.size(); ++i) least = std::min(least, spectrum[i] / target[i]);
  return least;
}

std::vector<double> mean_of(const std::vector<std::vector<double>>& spectra,
                            const std::vector<double>& factors) {
  std::vector<double> mean(spectra.front().size(), 0.0);
  for (std::size_t r = 0; r < spectra.size(); ++r)
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += factors[r] * spectra[r][i] / static_cast<double>(spectra.size());
  return mean;
}

}  // namespace

double scale_factor(std::span<const double> p, std::span<const double> t, ScalingRule rule) {
  if (p.empty() || p.size() != t.size() ||
      std::any_of(p.begin(), p.end(), [](double x) { return !(x > 0.0); }))
    throw std::invalid_argument("a record whose spectrum is zero cannot be scaled to a target");
  double logs = 0.0, product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    logs += std::log(t[i] / p[i]);
    product += t[i] * p[i];
    square += p[i] * p[i];
  }
  if (rule == ScalingRule::mean_log) return std::exp(logs / static_cast<double>(p.size()));
  return rule == ScalingRule::least_squares ? product / square : 1.0 / least_ratio(p, t);
}

double spectrum_misfit(std::span<const double> p, std::span<const double> t, double factor) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += std::pow(std::log(factor * p[i] / t[i]), 2);
  return p.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(p.size()));
}

SuiteScaling scale_suite(const std::vector<std::vector<double>>& spectra, std::span<const double> target,
                         ScalingRule rule, std::optional<double> floor) {
  if (spectra.empty()) throw std::invalid_argument("a suite needs a record");
  SuiteScaling out;
  for (const auto& spectrum : spectra) out.factors.push_back(scale_factor(spectrum, target, rule));
  if (floor) out.common_factor = std::max(1.0, *floor / least_ratio(mean_of(spectra, out.factors), target));
  for (double& factor : out.factors) factor *= out.common_factor;
  out.mean = mean_of(spectra, out.factors);
  for (std::size_t r = 0; r < spectra.size(); ++r)
    out.misfits.push_back(spectrum_misfit(spectra[r], target, out.factors[r]));
  out.mean_misfit = spectrum_misfit(out.mean, target, 1.0);
  out.least_ratio = least_ratio(out.mean, target);
  return out;
}

}  // namespace dougong::seismic
