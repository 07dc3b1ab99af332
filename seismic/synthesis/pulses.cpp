#include "seismic/synthesis/pulses.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "seismic/conditioning/taper.h"
#include "seismic/constants.h"
#include "seismic/synthesis/random.h"

namespace dougong::seismic {
namespace {

using std::numbers::pi;

std::size_t steps_in(double time, double interval) {
  return static_cast<std::size_t>(std::llround(time / interval));
}

// f(t) for 0 <= t <= duration, zero before and behind.
template <typename Function>
std::vector<double> sampled(Function f, double duration, double interval, Silence silence) {
  const std::size_t lead = steps_in(silence.lead, interval), rest = steps_in(silence.rest, interval);
  const auto count = static_cast<std::size_t>(std::ceil(duration / interval - 1e-9)) + 1;
  std::vector<double> a(lead + count + rest, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = interval * static_cast<double>(k);
    a[lead + k] = t <= duration * (1.0 + 1e-12) ? f(t) : 0.0;
  }
  return a;
}

std::vector<double> ramped(std::vector<double> a, double ramp, double interval) {
  cosine_taper(a, steps_in(ramp, interval));
  return a;
}

}  // namespace

std::vector<double> sine_pulse(double peak, double f, double cycles, double interval, Silence silence) {
  return sampled([=](double t) { return peak * std::sin(two_pi * f * t); }, cycles / f, interval, silence);
}

std::vector<double> cosine_pulse(double peak, double f, double cycles, double interval, Silence silence) {
  return sampled([=](double t) { return peak * std::cos(two_pi * f * t); }, cycles / f, interval, silence);
}

std::vector<double> ricker_pulse(double peak, double f, double interval, Silence silence, double reach) {
  const double middle = reach / f;
  const auto wavelet = [=](double t) {
    const double x = std::pow(pi * f * (t - middle), 2);
    return peak * (1.0 - 2.0 * x) * std::exp(-x);
  };
  return sampled(wavelet, 2.0 * middle, interval, silence);
}

std::vector<double> near_fault_pulse(const NearFaultPulse& p, double interval, Silence silence) {
  const double half = p.gamma / (2.0 * p.frequency), w = two_pi * p.frequency;
  const auto pulse = [=](double t) {
    const double slow = w * (t - half) / p.gamma, fast = w * (t - half) + p.phase;
    return -p.velocity * pi * p.frequency / p.gamma *
           (std::sin(slow) * std::cos(fast) + p.gamma * std::sin(fast) * (1.0 + std::cos(slow)));
  };
  return sampled(pulse, 2.0 * half, interval, silence);
}

double residual_displacement(const NearFaultPulse& p) {
  return p.velocity * std::cos(p.phase) * std::sin(pi * p.gamma) /
         (two_pi * p.frequency * (1.0 - p.gamma * p.gamma));
}

std::vector<double> harmonic(double peak, double f, double duration, double ramp, double interval) {
  return ramped(sampled([=](double t) { return peak * std::sin(two_pi * f * t); }, duration, interval, {}),
                ramp, interval);
}

std::vector<double> sweep(double peak, double from, double to, SweepRate rate, double duration, double ramp,
                          double interval) {
  const double ratio = std::log(to / from);
  const auto turns = [=](double t) {
    if (rate == SweepRate::linear || ratio == 0.0) return from * t + 0.5 * (to - from) * t * t / duration;
    return from * duration / ratio * std::expm1(ratio * t / duration);
  };
  return ramped(sampled([=](double t) { return peak * std::sin(two_pi * turns(t)); }, duration, interval, {}),
                ramp, interval);
}

std::vector<double> white_noise(double deviation, double duration, double ramp, double interval,
                                std::uint64_t seed) {
  std::vector<double> a = gaussian_noise(seed, 0, steps_in(duration, interval) + 1);
  for (double& value : a) value *= deviation;
  return ramped(std::move(a), ramp, interval);
}

}  // namespace dougong::seismic
