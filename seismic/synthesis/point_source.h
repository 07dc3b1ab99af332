// Stochastic point source: what one patch of a fault sends to a site, as shaped noise.
//
//   A(f) = C M0 (2 pi f)^2 S(f) G(R) exp(-pi f R/(Q(f) beta)) exp(-pi kappa f) A_site(f) L(f)     Fourier
//   amplitude C = R_p V F/(4 pi rho beta^3 R0),  R_p = 0.55, V = 0.707, F = 2, R0 = 1 km S = 1/(1 +
//   (f/f0)^2),  f0 = 4.9e6 beta (stress drop/M0)^(1/3)        [km/s, bar, dyne cm] M0 = 10^(1.5 M + 16.05)
//   dyne cm G = continuous pieces (R/R_k)^p_k,  Q = Q0 f^n (not below its value at 0.1 Hz) L = 1/sqrt(1 +
//   (f_low/f)^8): nothing below the band that a stochastic source may claim
//
// A time series: Gaussian noise of the length of the motion, windowed by the shape of Saragoni & Hart (1974)
// (peak at 0.2, 5 % left at t_n, t_n = 2 T_gm), transformed, divided by the rms of its spectrum, multiplied
// by A(f), transformed back. Duration T_gm = 1/f0 + path duration. Assumes a far field, one mean radiation
// pattern and no directivity; holds for about 0.1 s to 5 s. Sources: Boore, Pure Appl. Geophys. 160 (2003)
// 635-676; path durations of Boore & Thompson, BSSA 104 (2014) and 105 (2015); site amplification of a
// table below.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace dougong::seismic {

/// Amplification against frequency, linear in lg f and flat outside, of ground with a stated Vs30.
enum class SiteTable {
  generic_rock_760,  // Boore, BSSA 106 (2016)
  japan_500,         // EXSIM method note of 2022 (Atkinson, Assatourians, Hassani)
  california_500,    // the same
};

/// The crust that the waves pass: SI but for distances in km, where the published pieces are.
struct Region {
  double density = 2800.0;         // kg/m3
  double shear_velocity = 3500.0;  // m/s
  double q0 = 200.0, q_exponent = 0.5;
  double kappa = 0.03;                                               // s
  std::vector<std::pair<double, double>> spreading = {{1.0, -1.0}};  // from R (km): exponent
  double site_factor = 1.0;  // on the amplification of the site's table, all frequencies
  double low_cut = 0.05;     // Hz
  SiteTable site = SiteTable::generic_rock_760;
};

struct PointSource {
  double magnitude = 7.0;      // Mw
  double stress_drop = 1.0e7;  // Pa
  double distance = 30000.0;   // m, effective
  double onset = 0.0;          // s, when its first waves reach the site
};

/// A source spectrum C M0 (2 pi f)^2 S(f) (m/s at R0) on its way: spreading, Q, kappa, site and low cut.
double at_the_site(double source, const Region& region, double distance, double frequency);
/// C (2 pi f)^2 M0 (m/s), a source of moment M0 (N m) before its corner.
double source_amplitude(const Region& region, double moment, double frequency);
double seismic_moment(double magnitude);  // N m
double moment_magnitude(double moment);   // of N m
/// f0 (Hz) of moment (N m) and stress drop (Pa).
double corner_frequency(const Region& region, double moment, double stress_drop);
double path_duration(double distance);  // s, m

/// m/s.
double fourier_amplitude(const PointSource& source, const Region& region, double frequency);
double corner_frequency(const PointSource& source, const Region& region);  // Hz
double motion_duration(const PointSource& source, const Region& region);   // s, T_gm

/// Saragoni & Hart window with peak 1 at 0.2 t_n and 0.05 at t_n.
double envelope(double time, double end);

/// Noise whose mean square spectrum is that of `amplitude` (m/s at a frequency in Hz), windowed over
/// `duration` s (T_gm), added to `motion` from `onset` s on.
void add_shaped_noise(std::vector<double>& motion, const std::function<double(double)>& amplitude,
                      double duration, double onset, double interval, std::uint64_t seed,
                      std::uint64_t stream);

/// Acceleration (m/s2) at the site from `onset` on, `count` samples; the same seed and stream give the same.
std::vector<double> simulate(const PointSource& source, const Region& region, double interval,
                             std::size_t count, std::uint64_t seed, std::uint64_t stream);

}  // namespace dougong::seismic
