// The ways that a tradeoff compares: integrators x steps x contact stiffnesses, coarse before fine.
//
// A method of fixed step takes parts of its stability bound; where nothing bounds it, parts of the longest
// step that it takes by itself (moreau-jean), or of the output interval. An adaptive one takes tolerances.
#pragma once

#include "app/study/scene_run.h"
#include "app/study/tradeoff/way.h"

namespace dougong::app {

struct LadderChoice {
  std::vector<std::string> integrators;  // empty: all that apply
  std::vector<double> steps;             // parts of the bound; empty: by whether anything touches
  std::vector<double> tolerances;        // empty: the usual ones
  std::vector<double> stiffnesses;       // factors; empty: 0.1, 1, 10 where only contacts are elastic, else 1
};

/// What of the choice was left open, filled in by what the scene contains.
LadderChoice completed(LadderChoice choice, const PreparedScene& scene);
/// Why an integrator has no place in this scene; empty if it has.
std::string does_not_apply(const std::string& integrator, const engine::Model& model);

/// The rungs of one stiffness. `scene` has that stiffness.
std::vector<Way> ladder_of(const LadderChoice& completed, double stiffness, const PreparedScene& scene);

/// A part of the bound as this integrator is told it in this scene.
Way fixed_way(const std::string& integrator, double part, double stiffness, const PreparedScene& scene);
Way adaptive_way(const std::string& integrator, double tolerance, double stiffness);
/// The way that the scene itself asks for.
Way own_way(const PreparedScene& scene);

}  // namespace dougong::app
