// One way of computing a scene: an integrator, what controls its step, and how stiff the contacts are.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "app/study/scene_description.h"
#include "engine/scene.h"

namespace dougong::app {

/// The stiffness of contacts that impulses hold.
inline constexpr double rigid = std::numeric_limits<double>::infinity();

struct Way {
  /// -, over what the scene says; `rigid` for an integrator that knows no contact stiffness.
  double stiffness = 1.0;
  /// The integrator by name and one of step_fraction, step and tolerance.
  IntegrationChoice solve;

  /// Whether both integrate the same model in the same manner, and differ in their steps only.
  bool is_of_series(const Way& other) const {
    return stiffness == other.stiffness && solve.integrator == other.solve.integrator;
  }
  /// The tolerance, the step (s) or the part of the bound: smaller is finer within a series.
  double coarseness() const;
};

bool operator==(const Way& a, const Way& b);

/// The same way with all steps, or the tolerance, so many times as long.
Way coarsened(Way way, double factor);

std::string stiffness_text(double stiffness);  // "as described", "x 0.1", "rigid"
std::string control_text(const Way& way);      // "0.5 of the bound", "step 0.25 ms", "tolerance 1e-08"

/// The scene with every Young's modulus, and a contact.point_stiffness, times the factor. Bonds and joints
/// that take their stiffness from the moduli follow.
SceneDescription with_stiffness(SceneDescription description, const engine::Scene& scene, double factor);

/// The lines of a scene file that ask for this way: "[solve]", "integrator = \"rk4\"" ...
std::vector<std::string> keys_of(const Way& way, const SceneDescription& description,
                                 const engine::Scene& scene);

}  // namespace dougong::app
