#include "engine/accuracy.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "engine/fields/pair_field.h"

namespace dougong::engine {
namespace {

// From here on the order 8 pair errs less for fewer evaluations on an orbit (measured at 1e-8 and below).
constexpr double many_digits = 1e-7;
// With more bodies some contact closes or slips within every step, and ending steps there cannot pay.
constexpr std::size_t few_bodies = 5;
constexpr double loosest = 1e-2, tightest = 1e-14;

struct LevelValues {
  const char* name;
  double smooth_tolerance, contact_fraction, tree_fraction;
};
// Fractions below 0.9 of the bound: see the rocking block. A contact's tenth is the floor of its law.
constexpr std::array<LevelValues, 3> levels{
    {{"draft", 1e-5, 0.9, 0.2}, {"standard", 1e-8, 0.5, 0.05}, {"reference", 1e-12, 0.1, 0.01}}};
// A part of the scene: a block may rest on an overlap of a hundred millionth of it.
constexpr double few_bodies_tolerance = 1e-10;

// A half of the bound errs by about 1e-3 of the time on the rocking block, and the error is of first order.
double contact_fraction_for(double tolerance) {
  return std::clamp(0.5 * tolerance / 1e-3, 0.02, 0.9);
}
// Leapfrog at 0.036 of the bound errs by 0.04 after ten orbits of e = 0.6, and is of second order.
double tree_fraction_for(double tolerance) {
  return std::clamp(0.036 * std::sqrt(tolerance / 0.04), 0.002, 0.5);
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string asked_for(const Accuracy& accuracy) {
  if (const double* tolerance = std::get_if<double>(&accuracy)) return "tolerance " + number(*tolerance);
  return levels[static_cast<std::size_t>(std::get<AccuracyLevel>(accuracy))].name;
}

const LevelValues* level_of(const Accuracy& accuracy) {
  const auto* level = std::get_if<AccuracyLevel>(&accuracy);
  return level ? &levels[static_cast<std::size_t>(*level)] : nullptr;
}

bool by_tree(const Model& model) {
  return std::any_of(model.fields.pairs.begin(), model.fields.pairs.end(), uses_tree);
}

ResolvedAccuracy smooth(const Accuracy& accuracy) {
  const LevelValues* level = level_of(accuracy);
  ResolvedAccuracy r;
  r.tolerance = level ? level->smooth_tolerance : std::get<double>(accuracy);
  r.integrator = r.tolerance < many_digits ? "rk8" : "dormand-prince";
  r.explanation = "nothing touches, so the motion is smooth: " + r.integrator +
                  ", whose steps keep the error at " + number(r.tolerance) + " each";
  return r;
}

ResolvedAccuracy tree(const Accuracy& accuracy) {
  const LevelValues* level = level_of(accuracy);
  ResolvedAccuracy r;
  r.integrator = "leapfrog";
  r.step_fraction = level ? level->tree_fraction : tree_fraction_for(std::get<double>(accuracy));
  r.explanation = "forces by a tree jump a little, which error control would chase: leapfrog at " +
                  number(r.step_fraction) + " of the stability bound of now; the tree's own error stays";
  return r;
}

ResolvedAccuracy to_the_impact(const Accuracy& accuracy) {
  ResolvedAccuracy r;
  r.integrator = "dormand-prince";
  r.tolerance = level_of(accuracy) ? few_bodies_tolerance : std::get<double>(accuracy);
  r.explanation =
      "few bodies touch: dormand-prince, whose steps end where contacts open, close or turn back, at " +
      number(r.tolerance) + " each";
  return r;
}

ResolvedAccuracy fixed(const Accuracy& accuracy, std::size_t bodies) {
  const LevelValues* level = level_of(accuracy);
  ResolvedAccuracy r;
  r.integrator = "velocity-verlet";
  r.step_fraction = level ? level->contact_fraction : contact_fraction_for(std::get<double>(accuracy));
  r.explanation = number(static_cast<double>(bodies)) + (bodies == 1 ? " body touches" : " bodies touch") +
                  ", and impacts make any method one of first order: velocity-verlet at " +
                  number(r.step_fraction) + " of the stability bound" +
                  (level ? "" : "; the tolerance is aimed at, not promised");
  return r;
}

}  // namespace

Accuracy accuracy_from(std::string_view text) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (text == levels[i].name) return static_cast<AccuracyLevel>(i);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value >= tightest && value <= loosest)
    return value;
  throw std::invalid_argument("accuracy: expected draft, standard, reference or a tolerance from " +
                              number(tightest) + " to " + number(loosest) + ", found \"" + std::string(text) +
                              "\"");
}

ResolvedAccuracy resolve_accuracy(const Accuracy& accuracy, const Model& model) {
  const LevelValues* level = level_of(accuracy);
  const bool exact = !level || std::get<AccuracyLevel>(accuracy) == AccuracyLevel::reference;
  ResolvedAccuracy r = !model.has_contacts() ? (by_tree(model) ? tree(accuracy) : smooth(accuracy))
                       : exact && model.body_count <= few_bodies ? to_the_impact(accuracy)
                                                                 : fixed(accuracy, model.body_count);
  r.explanation = asked_for(accuracy) + ": " + r.explanation;
  return r;
}

void apply(const ResolvedAccuracy& accuracy, DriveOptions& options) {
  options.integrator = accuracy.integrator;
  options.step_fraction = accuracy.step_fraction;
  options.tolerance = accuracy.tolerance;
}

}  // namespace dougong::engine
