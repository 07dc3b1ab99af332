#include "seismic/measures/spectrum_intensity.h"

#include <algorithm>
#include <cmath>

namespace dougong::seismic {
namespace {

constexpr PeriodBand housner_band{0.1, 2.5}, acceleration_band{0.1, 0.5}, velocity_band{0.1, 2.5};  // s

std::vector<double> evenly_spaced(PeriodBand band, std::size_t steps) {
  std::vector<double> periods;
  for (std::size_t i = 0; i <= steps; ++i)
    periods.push_back(band.from +
                      (band.to - band.from) * static_cast<double>(i) / static_cast<double>(steps));
  return periods;
}

}  // namespace

double spectrum_integral(std::span<const double> acceleration, double interval, PeriodBand band,
                         double SpectralPoint::*ordinate, double damping_ratio, double step) {
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil((band.to - band.from) / step - 1e-9)));
  const auto spectrum =
      response_spectrum(acceleration, interval, evenly_spaced(band, steps), {damping_ratio, 1});
  double sum = 0.5 * (spectrum.front().*ordinate + spectrum.back().*ordinate);
  for (std::size_t i = 1; i < steps; ++i) sum += spectrum[i].*ordinate;
  return sum * (band.to - band.from) / static_cast<double>(steps);
}

double housner_intensity(std::span<const double> acceleration, double interval, double damping_ratio,
                         double step) {
  return spectrum_integral(acceleration, interval, housner_band, &SpectralPoint::pseudo_velocity,
                           damping_ratio, step);
}

double acceleration_spectrum_intensity(std::span<const double> acceleration, double interval,
                                       double damping_ratio, double step) {
  return spectrum_integral(acceleration, interval, acceleration_band, &SpectralPoint::acceleration,
                           damping_ratio, step);
}

double velocity_spectrum_intensity(std::span<const double> acceleration, double interval,
                                   double damping_ratio, double step) {
  return spectrum_integral(acceleration, interval, velocity_band, &SpectralPoint::velocity, damping_ratio,
                           step);
}

double predominant_period(std::span<const double> acceleration, double interval,
                          std::span<const double> periods, double damping_ratio) {
  double period = 0.0, most = 0.0;
  for (const SpectralPoint& point : response_spectrum(acceleration, interval, periods, {damping_ratio, 1})) {
    if (point.acceleration > most) period = point.period, most = point.acceleration;
  }
  return period;
}

double average_spectral_acceleration(std::span<const double> acceleration, double interval,
                                     std::span<const double> periods, double damping_ratio) {
  double sum = 0.0;
  for (const double psa : pseudo_accelerations(acceleration, interval, periods, damping_ratio)) {
    if (psa <= 0.0) return 0.0;
    sum += std::log(psa);
  }
  return periods.empty() ? 0.0 : std::exp(sum / static_cast<double>(periods.size()));
}

std::vector<double> average_acceleration_periods(double first_period, std::size_t count) {
  return evenly_spaced({0.2 * first_period, 3.0 * first_period}, std::max<std::size_t>(2, count) - 1);
}

}  // namespace dougong::seismic
