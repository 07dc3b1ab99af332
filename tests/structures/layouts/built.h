// A layout, compiled: what its tests ask of it.
#pragma once

#include <gmock/gmock.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/modes.h"
#include "engine/settle.h"
#include "structures/layouts/layout.h"
#include "structures/layouts/parts.h"
#include "structures/model_check.h"

namespace dougong::structures {

/// With the place of a word for a choice.
inline double word(const std::string& layout, const std::string& parameter, const std::string& chosen) {
  return value_of_word(*find_layout(layout).parameter(parameter), chosen);
}

inline std::size_t index_of(const Building& building, const std::string& name) {
  const auto it = std::ranges::find(building.scene.bodies, name, &engine::Body::name);
  if (it == building.scene.bodies.end()) throw std::out_of_range("no block " + name);
  return static_cast<std::size_t>(it - building.scene.bodies.begin());
}

struct Built {
  Building building;
  engine::Model model;
  engine::State state;

  explicit Built(Building made)
      : building(std::move(made)),
        model(engine::compile(building.scene)),
        state(engine::initial_state(model, building.scene)) {}
  Built(const std::string& layout, const ParameterMap& parameters)
      : Built(build_layout(layout, parameters)) {}

  engine::SettleReport settle() { return engine::settle(model, state); }
  std::vector<engine::Mode> modes() const { return engine::horizontal_modes(model, state); }
  double first_period() const { return modes().front().period(); }

  /// Horizontal displacement of the first of these blocks under a horizontal force shared among all of them,
  /// over that force (m/N).
  double flexibility(const std::vector<std::size_t>& pushed) const {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> k(engine::tangent_stiffness(model, state));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(model.body_count));
    for (const std::size_t i : pushed)
      load[static_cast<Eigen::Index>(i)] += 1.0 / static_cast<double>(pushed.size());
    return k.solve(load)[static_cast<Eigen::Index>(pushed.front())];
  }
};

/// Without gravity, as where closed forms leave out its softening.
inline Built weightless(Building building) {
  building.scene.gravity = {};
  return Built(std::move(building));
}

inline void expect_no_findings(const Building& building) {
  for (const Finding& finding : check_model(building)) ADD_FAILURE() << finding.message;
}

/// Comes to rest, within that movement (m), without breaking a bond but those of infill, which takes part in
/// carrying the weight although it is built last.
inline void expect_settles(Built& built, double movement) {
  const engine::SettleReport report = built.settle();
  EXPECT_TRUE(report.settled) << report.detail << ", unbalanced " << report.unbalanced_ratio << ", "
                              << report.moved_most << " moved " << report.greatest_movement;
  EXPECT_LT(report.greatest_movement, movement) << report.moved_most;
  for (std::size_t i = 0; i < built.state.bonds.history.size(); ++i)
    EXPECT_FALSE(built.state.bonds.history[i].broken &&
                 built.building.scene.bonds[i / 2].name.find("infill") == std::string::npos)
        << built.building.scene.bonds[i / 2].name;
}

/// What the layout says when it refuses these values; "accepted" if it does not.
inline std::string refusal(const std::string& layout, const ParameterMap& parameters) {
  try {
    build_layout(layout, parameters);
  } catch (const LayoutError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace dougong::structures
