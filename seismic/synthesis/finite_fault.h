// Stochastic finite fault: a rupture that runs over a grid of point sources, each with the corner frequency
// of what has broken when it starts.
//
//   N = n_l n_w subfaults of moment M0_i = M0 slip_i/sum(slip)
//   f0_i = 4.9e6 beta (stress drop/(M0/N))^(1/3) N_R^(-1/3)          [km/s, bar, dyne cm]
//     N_R subfaults are pulsing when i starts: those in its ring about the hypocentre and the n_l pulsing/2
//     rings behind it (at least one);  ring r = max(|i - i0|, |j - j0|) + 1
//   H_i^2 = N sum_f s(F0)^2/sum_f s(f0_i)^2,  s(f0) = (2 pi f)^2 D/(1 + (f/f0)^2): high-frequency energy of
//   the whole A_i(f) = C M0_i (2 pi f)^2 H_i Cc/(1 + (f/fe)^2) on its way,  Cc = sqrt(N)/H_i, fe =
//   f0_i/sqrt(Cc): the
//     incoherent sum keeps the moment at low frequency (Boore 2009)
//   arrival = (distance on the fault from the hypocentre)/v_r + R_i/beta + a random part of the rise time
//   rise time = radius/v_r, radius = sqrt(dl dw/pi);   duration = path(R_i) + rise time
//
// Slip is uniform, random, or larger in asperities: what breaks stronger than its surroundings sends the
// phases that stand out of a long rupture. The moment stays M0; the energy of the high frequencies grows by
// N sum(slip^2)/sum(slip)^2, which is how EXSIM weighs slips too. Several planes that break one after the
// other are added in time.
//
// Sources: Motazedian & Atkinson, BSSA 95 (2005) 995-1010; Boore, BSSA 99 (2009) 3202-3216; asperities:
// Somerville et al., Seismol. Res. Lett. 70 (1999) 59-80 (22 % of the area in the mean, with twice the mean
// slip); window and noise as in point_source.h (t_n = 2 T_gm). Holds for about 0.1 s to 5 s: no coherent long
// period, no directivity pulse. Local axes: x east, y north, z down, from the upper corner of the fault from
// which the strike runs (m).
#pragma once

#include <cstdint>
#include <vector>

#include "seismic/synthesis/point_source.h"

namespace dougong::seismic {

enum class SlipModel { uniform, random };

/// A rectangle of the plane in which the slip is so many times that around it.
struct Asperity {
  double along = 0.0, down = 0.0;    // m, its centre from the upper corner
  double length = 0.0, width = 0.0;  // m
  double slip = 3.0;
};

struct FiniteFault {
  double magnitude = 7.0;                         // Mw
  double stress_drop = 1e7;                       // Pa
  double length = 60000.0, width = 20000.0;       // m
  double strike = 0.0, dip = 1.5707963267948966;  // rad; clockwise from north, down to the right of it
  double top_depth = 0.0;                         // m
  double subfault_length = 5000.0, subfault_width = 5000.0;  // m, adjusted so that they fill the plane
  double hypocentre_along = 0.5, hypocentre_down = 0.5;      // of length and width
  double rupture_ratio = 0.8;                                // v_r/beta
  double pulsing_share = 0.5;                                // of the length
  SlipModel slip = SlipModel::uniform;                       // random: uniform in 0..1 of every subfault
  std::vector<Asperity> asperities = {};                     // their factors on that slip
};

/// Of the site from the upper corner, on the surface, m.
struct SitePlace {
  double east = 0.0, north = 0.0;
};

/// One plane of an earthquake that breaks several.
struct RupturePlane {
  FiniteFault fault;
  SitePlace corner;    // its upper corner, from the origin of the earthquake's map
  double onset = 0.0;  // s, when its hypocentre breaks
};

struct Subfault {
  double moment = 0.0;            // N m
  double distance = 0.0;          // m, of its centre from the site
  double arrival = 0.0;           // s after the rupture begins, without the random part
  double rise_time = 0.0;         // s
  double corner_frequency = 0.0;  // Hz
  double high_scale = 1.0;        // H
};
/// Row by row down the dip. `plane` counts those of an earthquake: each has its own random slips.
std::vector<Subfault> subfaults(const FiniteFault& fault, const Region& region, const SitePlace& site,
                                std::uint64_t seed, std::uint64_t plane = 0);
double closest_distance(const std::vector<Subfault>& subfaults);  // m, to a centre

/// Mean Fourier amplitude (m/s) of one subfault at the site.
double fourier_amplitude(const Subfault& subfault, std::size_t subfaults, const Region& region,
                         double frequency);

/// Acceleration (m/s2), the first arrival at `lead` s, until the last window is over or `longest` s.
std::vector<double> simulate(const FiniteFault& fault, const Region& region, const SitePlace& site,
                             double interval, double lead, std::uint64_t seed, std::uint64_t component,
                             double longest = 600.0);

/// The same of several planes, the site on their map; cut or filled with rest to `samples`.
std::vector<double> simulate(const std::vector<RupturePlane>& planes, const Region& region,
                             const SitePlace& site, double interval, double lead, std::uint64_t seed,
                             std::uint64_t component, std::size_t samples);

enum class FaultStyle { strike_slip, reverse, normal, all };
/// Wells & Coppersmith, BSSA 84 (1994), times (70 bar/stress drop)^(1/3): length and width (m).
struct FaultSize {
  double length, width;
};
FaultSize fault_size(double magnitude, FaultStyle style, double stress_drop);

}  // namespace dougong::seismic
