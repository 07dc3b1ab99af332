#include "seismic/synthesis/compatible_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "seismic/conditioning/baseline.h"
#include "seismic/design/scaling.h"
#include "seismic/measures/response_spectrum.h"
#include "seismic/numerics/fourier.h"
#include "seismic/synthesis/point_source.h"
#include "seismic/synthesis/random.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t band_periods = 150;
constexpr double rest = 5.0;  // s of the window's tail behind its duration

std::vector<double> windowed_noise(const CompatibleOptions& o) {
  const auto count = static_cast<std::size_t>(std::ceil((o.duration + rest) / o.interval)) + 1;
  std::vector<double> a = gaussian_noise(o.seed, 0, count);
  for (std::size_t k = 0; k < count; ++k) a[k] *= envelope(o.interval * static_cast<double>(k), o.duration);
  return a;
}

// ln of the ratio at a period, straight in ln T between the points, held outside.
double interpolated(const std::vector<double>& log_periods, const std::vector<double>& values, double at) {
  if (at <= log_periods.front()) return values.front();
  if (at >= log_periods.back()) return values.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(log_periods.begin(), log_periods.end(), at) -
                                          log_periods.begin());
  const double part = (at - log_periods[i - 1]) / (log_periods[i] - log_periods[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

class Matching {
 public:
  Matching(const DesignSpectrum& target, const CompatibleOptions& o)
      : options_(o),
        damping_(target.damping_ratio),
        periods_(log_spaced_periods(o.shortest_period, o.longest_period, band_periods)),
        wanted_(target.at(periods_)) {
    for (const double period : periods_) log_periods_.push_back(std::log(period));
  }

  CompatibleMotion measured(std::vector<double> a) const {
    const auto psa = pseudo_accelerations(a, options_.interval, periods_, damping_);
    CompatibleMotion m{std::move(a), spectrum_misfit(psa, wanted_, 1.0), psa[0] / wanted_[0],
                       psa[0] / wanted_[0]};
    for (std::size_t i = 0; i < psa.size(); ++i) {
      m.least_ratio = std::min(m.least_ratio, psa[i] / wanted_[i]);
      m.greatest_ratio = std::max(m.greatest_ratio, psa[i] / wanted_[i]);
    }
    return m;
  }

  std::vector<double> improved(const std::vector<double>& a) const {
    const auto psa = pseudo_accelerations(a, options_.interval, periods_, damping_);
    std::vector<double> logs;
    for (std::size_t i = 0; i < psa.size(); ++i) logs.push_back(std::log(wanted_[i] / psa[i]));
    std::vector<std::complex<double>> x(a.begin(), a.end());
    const std::size_t size = next_power_of_two(2 * a.size());
    x.resize(size);
    fourier_transform(x);
    const double df = 1.0 / (static_cast<double>(size) * options_.interval);
    x[0] = 0.0;
    for (std::size_t m = 1; m <= size / 2; ++m) {
      const double f = static_cast<double>(m) * df;
      x[m] *= std::exp(interpolated(log_periods_, logs, -std::log(f)));
      if (m < size / 2) x[size - m] = std::conj(x[m]);
    }
    inverse_fourier_transform(x);
    std::vector<double> out(a.size());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = x[k].real();
    return out;
  }

  // The motion below the band, which the rounds cannot judge, taken off once.
  std::vector<double> started() const {
    std::vector<double> a = windowed_noise(options_);
    std::vector<std::complex<double>> x(a.begin(), a.end());
    const std::size_t size = next_power_of_two(2 * a.size());
    x.resize(size);
    fourier_transform(x);
    const double df = 1.0 / (static_cast<double>(size) * options_.interval);
    x[0] = 0.0;
    for (std::size_t m = 1; m <= size / 2; ++m) {
      const double below = static_cast<double>(m) * df * options_.longest_period;
      x[m] *= below < 1.0 ? below * below * below * below : 1.0;
      if (m < size / 2) x[size - m] = std::conj(x[m]);
    }
    inverse_fourier_transform(x);
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = x[k].real();
    return a;
  }

 private:
  CompatibleOptions options_;
  double damping_;
  std::vector<double> periods_, wanted_, log_periods_;
};

}  // namespace

CompatibleMotion compatible_motion(const DesignSpectrum& target, const CompatibleOptions& o) {
  const Matching matching(target, o);
  std::vector<double> a = matching.started();
  CompatibleMotion best = matching.measured(a);
  for (int round = 0; round < o.rounds; ++round) {
    a = matching.improved(a);
    end_at_rest(a, o.interval);
    CompatibleMotion now = matching.measured(a);
    if (now.misfit < best.misfit) best = std::move(now);
  }
  return best;
}

}  // namespace dougong::seismic
