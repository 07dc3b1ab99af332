// A portal frame of elastic bars on fixed bases, pushed sideways at the left end of its beam: the direct
// stiffness method with Euler and Bernoulli's bars, axial strain included, six unknowns.
#pragma once

#include <Eigen/Dense>
#include <cmath>

namespace dougong::oracles {

struct Bar {
  double area = 0.0, second_moment = 0.0;  // m2, m4
};

struct Portal {
  double height = 3.0, span = 6.0, modulus = 30e9;  // m, m, Pa
  Bar column, beam;

  /// Force over the sideways displacement where it acts (N/m).
  double stiffness() const {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    Matrix k = Matrix::Zero();  // of both upper corners: x, y, angle each
    k.topLeftCorner<3, 3>() += bar(column, 0.0, height).bottomRightCorner<3, 3>();
    k.bottomRightCorner<3, 3>() += bar(column, 0.0, height).bottomRightCorner<3, 3>();
    k += bar(beam, span, 0.0);
    Eigen::Matrix<double, 6, 1> force = Eigen::Matrix<double, 6, 1>::Zero();
    force[0] = 1.0;
    const Eigen::Matrix<double, 6, 1> u = k.ldlt().solve(force);
    return 1.0 / u[0];
  }

 private:
  // From its first end to its second, along (dx, dy).
  Eigen::Matrix<double, 6, 6> bar(const Bar& b, double dx, double dy) const {
    const double l = std::hypot(dx, dy), c = dx / l, s = dy / l, ei = modulus * b.second_moment;
    const double axial = modulus * b.area / l, shear = 12.0 * ei / (l * l * l), mixed = 6.0 * ei / (l * l);
    Eigen::Matrix3d near, across, turn;
    near << axial, 0.0, 0.0, 0.0, shear, mixed, 0.0, mixed, 4.0 * ei / l;
    across << -axial, 0.0, 0.0, 0.0, -shear, mixed, 0.0, -mixed, 2.0 * ei / l;
    Eigen::Matrix3d far = near;
    far(1, 2) = far(2, 1) = -mixed;
    turn << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    Eigen::Matrix<double, 6, 6> k;
    k << turn.transpose() * near * turn, turn.transpose() * across * turn,
        turn.transpose() * across.transpose() * turn, turn.transpose() * far * turn;
    return k;
  }
};

}  // namespace dougong::oracles
