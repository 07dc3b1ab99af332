// The integrators there are: one line each.
#pragma once

#include <stdexcept>
#include <string>
#include <variant>

#include "engine/integrators/dormand_prince.h"
#include "engine/integrators/explicit_euler.h"
#include "engine/integrators/leapfrog.h"
#include "engine/integrators/moreau_jean.h"
#include "engine/integrators/rk3.h"
#include "engine/integrators/rk4.h"
#include "engine/integrators/rk8.h"
#include "engine/integrators/symplectic_euler.h"
#include "engine/integrators/velocity_verlet.h"

namespace dougong::engine {

using AnyIntegrator = std::variant<VelocityVerlet, SymplecticEuler, Leapfrog, Rk4, Rk3, ExplicitEuler,
                                   DormandPrince, Rk8, MoreauJean>;

namespace detail {
template <std::size_t I = 0>
AnyIntegrator integrator_named(std::string_view name, std::string known) {
  if constexpr (I == std::variant_size_v<AnyIntegrator>) {
    throw std::invalid_argument("there is no integrator \"" + std::string(name) + "\"; known are" + known);
  } else {
    using Candidate = std::variant_alternative_t<I, AnyIntegrator>;
    if (Candidate::traits.name == name) return Candidate{};
    return integrator_named<I + 1>(name, std::move(known) + " " + std::string(Candidate::traits.name));
  }
}
}  // namespace detail

/// Throws std::invalid_argument, naming the known ones.
inline AnyIntegrator make_integrator(std::string_view name) {
  return detail::integrator_named(name, "");
}

/// Throws as make_integrator().
inline IntegratorTraits traits_of(std::string_view name) {
  return std::visit([](const auto& i) -> IntegratorTraits { return i.traits; }, make_integrator(name));
}

}  // namespace dougong::engine
