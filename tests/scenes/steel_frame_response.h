// Periods and static sway of the steel frame of comparison C08.
#pragma once

#include <Eigen/SparseCholesky>

#include "engine/modes.h"
#include "tests/scenes/running.h"
#include "tests/scenes/steel_frame.h"

namespace dougong::scenes {

/// s, of the seven modes of sway.
inline std::vector<double> periods_of(const SteelFrame& frame) {
  const Running r(frame.model());
  std::vector<double> periods;
  for (const engine::Mode& mode : engine::horizontal_modes(r.model, r.state, 12))
    if (mode.participation > 1e-5 && periods.size() < SteelFrame::storeys) periods.push_back(mode.period());
  return periods;
}

struct Sway {
  double roof = 0.0, axial = 0.0, moment = 0.0;  // in, kip, kip in; of the left column's foot
};

/// Under the floor loads.
inline Sway sway_of(const SteelFrame& frame) {
  using Frame = SteelFrame;
  const Running r(frame.model());
  const auto n = static_cast<Eigen::Index>(r.bodies());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * n);
  for (std::size_t storey = 0; storey < Frame::storeys; ++storey)
    load[static_cast<Eigen::Index>(frame.node(storey, 1))] = Frame::loads[storey] * Frame::kip;
  const Eigen::VectorXd u =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(engine::tangent_stiffness(r.model, r.state))
          .solve(load);
  const auto roof = static_cast<Eigen::Index>(frame.node(Frame::storeys - 1, 1)),
             foot = static_cast<Eigen::Index>(frame.first_block_of_left_column());
  return {u[roof] / Frame::inch, u[n + foot] * frame.foot_axial_stiffness() / Frame::kip,
          -u[2 * n + foot] * frame.foot_bending_stiffness() / (Frame::kip * Frame::inch)};
}

}  // namespace dougong::scenes
