// Motions that are given by a formula, as samples of acceleration (m/s2) at t = k h.
//
//   sine      A sin(2 pi f t), n cycles          one cycle leaves A/(2 pi f^2) of displacement and no
//   velocity cosine    A cos(2 pi f t), n cycles          leaves neither; starts and ends with a jump Ricker
//   A (1 - 2 x) exp(-x), x = (pi f (t - t0))^2         leaves neither Mavroeidis & Papageorgiou, BSSA 93
//   (2003) 1099-1131: |tau| <= gamma/(2 f), tau = t - t0, gamma > 1
//     v = (V/2) [1 + cos(2 pi f tau/gamma)] cos(2 pi f tau + nu)
//     a = -(V pi f/gamma) [sin(2 pi f tau/gamma) cos(2 pi f tau + nu)
//                          + gamma sin(2 pi f tau + nu) (1 + cos(2 pi f tau/gamma))]
//     leaves V cos(nu) sin(pi gamma)/(2 pi f (1 - gamma^2)) of displacement
//   harmonic  A sin(2 pi f t), risen and let fall by half cosines over `ramp` at its ends
//   sweep     A sin(phase), the frequency from f0 to f1 linearly or in equal octaves, ramps as above
//   noise     Gaussian white noise of standard deviation A up to the Nyquist frequency, ramps as above
#pragma once

#include <cstdint>
#include <vector>

namespace dougong::seismic {

/// Rest of `lead` s before a pulse and `rest` s behind it.
struct Silence {
  double lead = 0.0, rest = 0.0;
};

std::vector<double> sine_pulse(double peak, double frequency, double cycles, double interval,
                               Silence silence = {});
std::vector<double> cosine_pulse(double peak, double frequency, double cycles, double interval,
                                 Silence silence = {});
/// Over +-`reach`/frequency about its middle: at 1.5 its acceleration is 1e-8 of the peak.
std::vector<double> ricker_pulse(double peak, double frequency, double interval, Silence silence = {},
                                 double reach = 1.5);

struct NearFaultPulse {
  double velocity = 1.0;   // m/s, V: the envelope's peak
  double frequency = 0.5;  // Hz, f
  double gamma = 2.0;      // above 1: oscillations within the envelope
  double phase = 0.0;      // rad, nu
};
std::vector<double> near_fault_pulse(const NearFaultPulse& pulse, double interval, Silence silence = {});
double residual_displacement(const NearFaultPulse& pulse);  // m

std::vector<double> harmonic(double peak, double frequency, double duration, double ramp, double interval);
enum class SweepRate { linear, logarithmic };
std::vector<double> sweep(double peak, double from, double to, SweepRate rate, double duration, double ramp,
                          double interval);
std::vector<double> white_noise(double deviation, double duration, double ramp, double interval,
                                std::uint64_t seed);

}  // namespace dougong::seismic
