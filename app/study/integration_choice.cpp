#include "app/study/integration_choice.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/accuracy.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

void refuse_tolerance(const IntegrationChoice& choice, const std::string& integrator) {
  if (choice.tolerance && !engine::traits_of(integrator).adaptive)
    throw std::invalid_argument(
        fmt::format("solve.tolerance: {} takes steps of a given size; leave it out", integrator));
}

template <std::size_t... I>
std::vector<std::string> names_at(std::index_sequence<I...>) {
  return {std::string(std::variant_alternative_t<I, engine::AnyIntegrator>::traits.name)...};
}

}  // namespace

std::vector<std::string> integrator_choices() {
  auto names = names_at(std::make_index_sequence<std::variant_size_v<engine::AnyIntegrator>>{});
  names.insert(names.begin(), automatic_integrator);
  return names;
}

std::string choose_integration(const IntegrationChoice& choice, const engine::Model& model,
                               engine::DriveOptions& options) {
  const auto chosen = engine::resolve_accuracy(engine::accuracy_from(choice.accuracy), model);
  engine::apply(chosen, options);
  const bool automatic = choice.integrator == automatic_integrator;
  if (!automatic) options.integrator = choice.integrator;
  refuse_tolerance(choice, options.integrator);
  options.step_fraction = choice.step_fraction.value_or(options.step_fraction);
  options.tolerance = choice.tolerance.value_or(options.tolerance);
  options.step = choice.step;
  return automatic ? chosen.explanation : "";
}

}  // namespace dougong::app
