// A chain of storeys by its modes: frequencies and shapes of M and K, the damping matrix that gives every
// mode a ratio of its own, and dashpots that make it.
//
//   K phi = w^2 M phi, phi' M phi = 1;   C = M (sum 2 xi w phi phi') M
// Chopra, Dynamics of Structures, 11.4 (superposition of modal damping matrices). C couples every two floors
// by a dashpot of -C_ij and every floor to the ground by one of its row sum. They are not negative where xi w
// grows with w no faster than w itself.
#pragma once

#include <Eigen/Dense>
#include <stdexcept>

#include "tests/scenes/shear_building.h"

namespace dougong::scenes {

struct ModalChain {
  Eigen::VectorXd frequency;  // rad/s
  Eigen::MatrixXd shape;      // by columns
  Eigen::VectorXd mass;       // kg
};

inline ModalChain modal_chain(const std::vector<oracles::ChainLevel>& levels) {
  const auto n = static_cast<Eigen::Index>(levels.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  ModalChain chain{{}, {}, Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const oracles::ChainLevel& level = levels[static_cast<std::size_t>(i)];
    chain.mass[i] = level.mass;
    k(i, i) += level.stiffness;
    if (i == 0) continue;
    k(i - 1, i - 1) += level.stiffness;
    k(i, i - 1) -= level.stiffness, k(i - 1, i) -= level.stiffness;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(
      k, Eigen::MatrixXd(chain.mass.asDiagonal()));
  chain.frequency = solved.eigenvalues().cwiseSqrt();
  chain.shape = solved.eigenvectors();
  return chain;
}

/// N s/m.
inline Eigen::MatrixXd modal_damping(const ModalChain& chain, const std::vector<double>& ratios) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(chain.mass.size(), chain.mass.size());
  for (Eigen::Index j = 0; j < chain.mass.size(); ++j) {
    const Eigen::VectorXd m = chain.mass.cwiseProduct(chain.shape.col(j));
    c += 2.0 * ratios[static_cast<std::size_t>(j)] * chain.frequency[j] * m * m.transpose();
  }
  return c;
}

/// Dashpots between every two floors of a shear building and to the ground.
inline void add_modal_damping(engine::Scene& s, const Eigen::MatrixXd& c) {
  using shear_building::dashpot, shear_building::thickness;
  const auto add = [&](engine::Owner below, Eigen::Index floor, double level, double damping) {
    if (damping < -1e-9 * c.norm()) throw std::invalid_argument("modal damping: a dashpot would be negative");
    if (damping > 1e-9 * c.norm())
      s.joints.push_back(dashpot(below, static_cast<std::size_t>(floor), level, damping));
  };
  for (Eigen::Index i = 0; i < c.rows(); ++i) {
    add({true, 0}, i, (static_cast<double>(i) + 0.5) * thickness + 1.0, c.row(i).sum());
    for (Eigen::Index j = 0; j < i; ++j)
      add({false, static_cast<std::size_t>(j)}, i, static_cast<double>(i - j) * thickness, -c(i, j));
  }
}

}  // namespace dougong::scenes
