// Materials and what two of them do where they touch.
//
// Defaults are plain structural concrete: E 30 GPa, nu 0.2, 2400 kg/m3, friction 0.6 on itself.
// damping_ratio is local to a contact point: c = 2 xi sqrt(k m_eff), m_eff the mass that the point
// feels. xi = 1 gives a restitution of 0.14, and a rocking block loses what Housner's plastic impact
// takes to within 0.2 % of the velocity, whatever the stiffness (docs/validation.md, R01).
#pragma once

#include <optional>
#include <string>

namespace dougong::engine {

struct Material {
  std::string name = "concrete";
  double density = 2400.0;            // kg/m3
  double young_modulus = 30e9;        // Pa
  double poisson_ratio = 0.2;         // -
  double friction_coefficient = 0.6;  // -, static = kinetic
  double damping_ratio = 1.0;         // -, local to a contact point
  /// Spin after over spin before an impact of a rocking block (-), in (0, 1]; unset: what the corners' law
  /// gives, Housner's ratio at a damping ratio of 1 or more. A ratio above that cannot be had (rocking.h).
  std::optional<double> rocking_restitution = std::nullopt;
};

/// Damping ratio that gives the coefficient of restitution e (0..1) in a free impact on a linear
/// spring and dashpot whose force is cut at zero: never tensile.
/// Schwager and Poeschel, Granular Matter 9 (2007) 465-469, eq. 17-21.
double damping_ratio_for_restitution(double restitution);
double restitution_for_damping_ratio(double damping_ratio);

}  // namespace dougong::engine
