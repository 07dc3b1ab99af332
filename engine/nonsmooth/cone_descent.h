// A step of the method of multipliers on rigid contact with Coulomb's cone: slow near the end, but it
// descends a convex function, so that it cannot go round in circles.
//
// With s = mu |u_T + b_T| held, Coulomb's law is a projection on the cone K = {|P_T| <= mu P_N},
//     P = proj_K(P - rho (u + b + (s, 0)))                              (De Saxce's bipotential)
// and with the P on the right held too, v minimises
//     1/2 |v - v_free|^2_M + sum |proj_K(P - rho (u + b + (s, 0)))|^2 / (2 rho),    rho = kappa / w,
// which Newton's method with a line search does. The minimum's projections are the next P; the next s is
// halfway to that of its u, as s itself can go to and fro. De Saxce and Feng, Math. Comput. Modelling 28
// (1998) 225-245; Acary, Cadoux, Lemarechal and Malick, ZAMM 91 (2011) 155-175.
#pragma once

#include "engine/nonsmooth/contact_matrix.h"

namespace dougong::engine {

class ConeDescent {
 public:
  /// Another problem begins.
  void restart() { fresh_ = true; }
  /// One step of the multipliers at the problem's impulses and the velocities that belong to them, to within
  /// `tolerance` (m/s) of the minimum. Returns the iterations of Newton's method that it took.
  std::size_t step(ImpulseProblem& problem, ContactMatrix& matrix, double kappa, double tolerance);

 private:
  enum class Side : std::uint8_t { inside, forward, back, outside };
  struct Point {
    Vec2 target;          // N s, P - rho (b + (s, 0))
    double rho = 0.0;     // kg
    double slides = 0.0;  // m/s, s
    Vec2 velocity, turn;  // m/s, u and its change along the direction of search
    Side side = Side::outside;
    Vec2 impulse;  // N s, projected
  };
  void hold(const ImpulseProblem& problem, double kappa);
  void project(const ImpulseProblem& problem);
  double find_gradient(const ImpulseProblem& problem);
  bool find_direction(const ImpulseProblem& problem, ContactMatrix& matrix);
  double slope_at(const ImpulseProblem& problem, double way) const;
  double search(const ImpulseProblem& problem) const;

  bool fresh_ = true;  // no s yet
  std::vector<Point> points_;
  std::vector<PlaneVelocity> direction_;
};

}  // namespace dougong::engine
