// What an integrator is: one step of q'' = a(t, q, v), and the facts about it. An adaptive one divides the
// step as its tolerance asks (adaptive.h).
//
// The system may depend on velocity (dashpots, friction). Beside the motion every integrator cumulates
// the system's powers into work, with its own quadrature, so that the energy ledger has the order of the
// motion. Time, step choice, output and health belong to drive(), not here.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace dougong::engine {

/// Rates of the energies that the ledger follows (W): terrain input, dashpots, tangential forces of contacts,
/// springs of bonds; and, in the work of a step only, what the method's velocities at the ends of steps hold
/// beyond its own energy (J, energy.h).
struct Powers {
  std::array<double, 5> values{};
  friend Powers operator+(Powers a, const Powers& b) {
    for (std::size_t i = 0; i < a.values.size(); ++i) a.values[i] += b.values[i];
    return a;
  }
  friend Powers operator*(double s, Powers a) {
    for (double& value : a.values) value *= s;
    return a;
  }
};

struct IntegratorTraits {
  std::string_view name;
  int order;               // smooth forces that depend on position only
  int order_with_damping;  // smooth forces that depend on velocity too
  int evaluations;         // of the forces, a step
  bool symplectic;
  double stability_limit;  // of omega h, undamped oscillator; no meaning for an adaptive one
  bool adaptive = false;
  bool rigid_contacts = false;  // impulses in place of contact stiffness (moreau_jean.h)
  /// s, the longest step that drive() takes unless one is asked for: of methods that nothing else may bound.
  double longest_step = std::numeric_limits<double>::infinity();
};

template <class S>
concept SecondOrderSystem = requires(S s, double t, std::span<const double> q, std::span<double> a,
                                     bool first) {
  { s.degrees_of_freedom() } -> std::convertible_to<std::size_t>;
  { s.accelerate(t, q, q, a, first) } -> std::same_as<Powers>;
  { s.work() } -> std::same_as<Powers>;
};

/// A system may also offer, and adaptive integrators then use:
///     has_memory()               whether begins_step changes what later evaluations give (friction)
///     scales()                   what errors are measured by (error_control.h)
///     event_count(), events(values, at_start)   signed values at the last evaluated state whose sign changes
///                                a step must not straddle; not a number: not watched (events.h)
/// An adaptive integrator also has set_tolerance() and trouble().
///
/// step() advances q and v from t to t + h and returns the work done. restart() forgets what was kept
/// from the step before (after a change of step, contacts or state).
/// stable_step(w2, c) is the largest stable h for every pair of eigenvalues w2 of M^-1 K (rad2/s2) and c
/// of M^-1 C (1/s) not above the ones given.
template <class I, class S>
concept Integrator = SecondOrderSystem<S> && requires(I i, S s, double t, double h, std::span<double> q) {
  { I::traits } -> std::convertible_to<IntegratorTraits>;
  { I::stable_step(h, h) } -> std::same_as<double>;
  { i.step(s, t, h, q, q) } -> std::same_as<Powers>;
  i.restart();
};

}  // namespace dougong::engine
