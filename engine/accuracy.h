// One dial for accuracy: draft, standard, reference or a tolerance, made into an integrator and its step by
// what the model contains.
//
//   nothing touches, direct fields   smooth: an adaptive pair of order 5, or 8 for many digits
//   nothing touches, a tree          leapfrog: the tree's forces jump when a cell opens, which error control
//                                    would chase
//   few bodies touch                 velocity Verlet; for reference steps that end at impacts
//   many bodies touch                velocity Verlet: some contact always closes, so every method is of first
//                                    order and the cheapest evaluation wins
//
// What each choice costs and errs was measured on orbits and a rocking block: docs/theory/integrators.md.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "engine/drive.h"

namespace dougong::engine {

enum class AccuracyLevel { draft, standard, reference };

/// A level, or a relative tolerance.
using Accuracy = std::variant<AccuracyLevel, double>;

/// Reads "draft", "standard", "reference" or a number. Throws std::invalid_argument, saying what was
/// expected and what was found.
Accuracy accuracy_from(std::string_view text);

struct ResolvedAccuracy {
  std::string integrator;
  double step_fraction = 0.5;  // of the stability bound; of no meaning to an adaptive integrator
  double tolerance = 1e-8;     // of no meaning to a fixed step
  std::string explanation;     // one line: what was chosen, and why
};

ResolvedAccuracy resolve_accuracy(const Accuracy& accuracy, const Model& model);

/// Sets integrator, fraction and tolerance.
void apply(const ResolvedAccuracy& accuracy, DriveOptions& options);

}  // namespace dougong::engine
