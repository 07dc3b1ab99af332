// An oscillator that yields: bilinear with kinematic hardening, exact between its changes of branch.
//
//   u'' + 2 zeta w u' + q = -a(t),   q = alpha w^2 u + (1 - alpha) w^2 (u - p),   |u - p| <= u_y
//
//   u    relative displacement  m      p  plastic displacement  m      u_y  yield displacement  m
//   q    restoring force over mass  m/s2       alpha  hardening ratio, 0 to 1       a linear between samples
//
// While it is elastic p rests, while it yields p = u -+ u_y: both are linear oscillators under a linear
// force, whose solution is a power series in time, u(n+2) = -2 zeta w u(n+1) - K u(n). Steps are divided so
// that w h <= 0.5, where sixteen terms reach the last bit, and the changes (u - p reaches u_y; u' turns) are
// found as roots of the series. Peaks are taken wherever they fall. Ductility is max|u|/u_y. Constant
// ductility: the greatest yield displacement whose ductility reaches the one asked for (Mahin & Bertero, J.
// Struct. Div. ASCE 107, 1981; Chopra, Dynamics of Structures, sec. 7.5).
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "seismic/measures/oscillator.h"

namespace dougong::seismic {

struct BilinearOscillator {
  Oscillator elastic;
  double yield_displacement = std::numeric_limits<double>::infinity();  // m
  double hardening_ratio = 0.0;
};

struct BilinearResponse {
  double peak_displacement = 0.0;     // m
  double peak_force = 0.0;            // over mass, m/s2
  double peak_acceleration = 0.0;     // absolute, m/s2, at the samples and changes
  double last_displacement = 0.0;     // m
  double plastic_displacement = 0.0;  // m, at the end: the residual one
  double plastic_work = 0.0;          // J/kg, (1 - alpha) w^2 u_y times the way of p
  int branch_changes = 0;
};

/// From rest.
BilinearResponse bilinear_response(std::span<const double> acceleration, double interval,
                                   const BilinearOscillator& oscillator);

struct DuctilityPoint {
  double period = 0.0;              // s
  double ductility = 0.0;           // met
  double yield_displacement = 0.0;  // m
  double yield_acceleration = 0.0;  // w^2 u_y, m/s2
  double strength_reduction = 1.0;  // R, elastic peak over yield displacement
  double inelastic_ratio = 1.0;     // C, inelastic over elastic peak
};

/// Ductility 1 is elastic. Of a record of zeros all is zero.
DuctilityPoint constant_ductility(std::span<const double> acceleration, double interval,
                                  const Oscillator& elastic, double ductility, double hardening_ratio = 0.0);

std::vector<DuctilityPoint> constant_ductility_spectrum(std::span<const double> acceleration, double interval,
                                                        std::span<const double> periods, double ductility,
                                                        double damping_ratio = 0.05,
                                                        double hardening_ratio = 0.0);

}  // namespace dougong::seismic
