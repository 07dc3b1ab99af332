// How a scene or a scenario asks for its integration, and what the dial makes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/drive.h"

namespace dougong::app {

inline const std::string automatic_integrator = "automatic";

struct IntegrationChoice {
  std::string integrator = automatic_integrator;
  std::string accuracy = "standard";    // draft, standard, reference
  std::optional<double> step_fraction;  // of the stability bound, instead of accuracy's
  std::optional<double> step;           // s, instead of both
  std::optional<double> tolerance;      // of an integrator that chooses its own step
  double threads = 1;                   // that share every step
};

/// "automatic" and the integrators by name.
std::vector<std::string> integrator_choices();
/// Sets integrator, step and tolerance: the dial resolves by what the model contains, and what is said beside
/// it goes before. Returns what was chosen and why; empty where the integrator was named. Throws
/// std::invalid_argument for a tolerance that the integrator has no use for.
std::string choose_integration(const IntegrationChoice& choice, const engine::Model& model,
                               engine::DriveOptions& options);

}  // namespace dougong::app
