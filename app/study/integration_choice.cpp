#include "app/study/integration_choice.h"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/accuracy.h"
#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

bool is_automatic(const IntegrationChoice& choice) {
  return choice.integrator == automatic_integrator;
}

void refuse(const char* key, const std::string& integrator, const char* what) {
  throw std::invalid_argument(fmt::format("solve.{}: {} {}; leave it out", key, integrator, what));
}

// What an integrator does not look at is not passed over in silence.
void refuse_what_does_nothing(const IntegrationChoice& choice, const std::string& integrator) {
  const bool adaptive = engine::traits_of(integrator).adaptive, automatic = is_automatic(choice);
  if (choice.tolerance && !adaptive && !automatic)
    refuse("tolerance", integrator, "takes steps of a given size");
  if (choice.step_fraction && adaptive) refuse("step_fraction", integrator, "chooses its own steps");
  if (choice.accuracy == IntegrationChoice{}.accuracy) return;
  if (choice.tolerance && (automatic || adaptive)) refuse("accuracy", "the tolerance", "stands in its place");
  if (!automatic && (choice.step || choice.step_fraction))
    refuse("accuracy", "with a named integrator its step", "stands in its place");
}

// With the integrator left open a tolerance is a position of the dial.
engine::Accuracy accuracy_asked_for(const IntegrationChoice& choice) {
  const bool dials = is_automatic(choice) && choice.tolerance;
  return engine::accuracy_from(dials ? fmt::format("{}", *choice.tolerance) : choice.accuracy);
}

std::string explained(const engine::ResolvedAccuracy& chosen, const IntegrationChoice& choice) {
  if (choice.step) return chosen.explanation + "; but the step that was asked for";
  if (choice.step_fraction)
    return fmt::format("{}; but {} of the bound, as asked for", chosen.explanation, *choice.step_fraction);
  return chosen.explanation;
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
  const auto chosen = engine::resolve_accuracy(accuracy_asked_for(choice), model);
  engine::apply(chosen, options);
  const bool automatic = is_automatic(choice);
  if (!automatic) options.integrator = choice.integrator;
  refuse_what_does_nothing(choice, options.integrator);
  options.step_fraction = choice.step_fraction.value_or(options.step_fraction);
  if (!automatic) options.tolerance = choice.tolerance.value_or(options.tolerance);
  options.step = choice.step;
  options.threads = static_cast<std::size_t>(choice.threads);
  return automatic ? explained(chosen, choice) : "";
}

}  // namespace dougong::app
