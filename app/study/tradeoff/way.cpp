#include "app/study/tradeoff/way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/study/scene_keys.h"

namespace dougong::app {
namespace {

bool changes_stiffness(const Way& way) {
  return way.stiffness != 1.0 && std::isfinite(way.stiffness);
}

// The keys by which one differs from the other, with the values of the other.
template <class Owner>
void add_changed(std::vector<std::string>& lines, const Owner& from, const Owner& to) {
  for (const Key<Owner>& key : keys_of<Owner>())
    if (toml_value(key, from) != toml_value(key, to))
      lines.push_back(key.name + (" = " + toml_value(key, to)));
}

MaterialChoice& choice_of(SceneDescription& description, const std::string& name) {
  const auto it = std::ranges::find(description.materials, name, &MaterialChoice::name);
  if (it != description.materials.end()) return *it;
  description.materials.emplace_back().name = name;
  return description.materials.back();
}

std::vector<std::string> stiffness_keys(const SceneDescription& stiffened) {
  std::vector<std::string> lines;
  for (const MaterialChoice& material : stiffened.materials) {
    lines.push_back(fmt::format("[materials.{}]", toml_key(material.name)));
    lines.push_back("young_modulus = " + toml_number(*material.young_modulus, Dimension::pressure));
  }
  if (stiffened.contact.point_stiffness) {
    lines.emplace_back("[contact]");
    lines.push_back("point_stiffness = " +
                    toml_number(*stiffened.contact.point_stiffness, Dimension::stiffness));
  }
  return lines;
}

}  // namespace

double Way::coarseness() const {
  if (solve.tolerance) return *solve.tolerance;
  return solve.step ? *solve.step : solve.step_fraction.value_or(0.0);
}

bool operator==(const Way& a, const Way& b) {
  return a.is_of_series(b) && a.solve.tolerance == b.solve.tolerance && a.solve.step == b.solve.step &&
         a.solve.step_fraction == b.solve.step_fraction;
}

Way coarsened(Way way, double factor) {
  for (auto* control : {&way.solve.tolerance, &way.solve.step, &way.solve.step_fraction})
    if (*control) **control *= factor;
  return way;
}

std::string stiffness_text(double stiffness) {
  if (stiffness == rigid) return "rigid";
  return stiffness == 1.0 ? "as described" : fmt::format("x {:g}", stiffness);
}

std::string control_text(const Way& way) {
  if (way.solve.tolerance) return fmt::format("tolerance {:.3g}", *way.solve.tolerance);
  if (way.solve.step) return fmt::format("step {:.3g} ms", 1e3 * *way.solve.step);
  return fmt::format("{:.3g} of the bound", way.solve.step_fraction.value_or(0.0));
}

SceneDescription with_stiffness(SceneDescription description, const engine::Scene& scene, double factor) {
  for (const engine::Material& material : scene.materials)
    if (!material.name.empty())
      choice_of(description, material.name).young_modulus = factor * material.young_modulus;
  if (description.contact.point_stiffness) *description.contact.point_stiffness *= factor;
  return description;
}

std::vector<std::string> keys_of(const Way& way, const SceneDescription& description,
                                 const engine::Scene& scene) {
  SceneSolve solve = description.solve;
  static_cast<IntegrationChoice&>(solve) = way.solve;
  solve.threads = description.solve.threads;
  std::vector<std::string> lines{"[solve]"};
  add_changed(lines, description.solve, solve);
  // Rigid contacts have no springs to speak of.
  if (way.stiffness == rigid) {
    lines.emplace_back("[contact]");
    add_changed(lines, description.contact, engine::ContactOptions{});
    if (lines.back() == "[contact]") lines.pop_back();
  }
  if (!changes_stiffness(way)) return lines;
  for (std::string& line : stiffness_keys(with_stiffness(description, scene, way.stiffness)))
    lines.push_back(std::move(line));
  return lines;
}

}  // namespace dougong::app
