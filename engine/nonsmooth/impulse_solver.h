// Newton's method on the laws of rigid contact, for all points at once.
//
// Every point is open, sticks or slides by what the projection of P - (u + b)/w says (the active set of Alart
// and Curnier's semismooth Newton method). With the set fixed the laws are linear; a proximal term makes them
// solvable where there are more points than the bodies have freedoms:
//     closed     u_N + J_N dv + b_N + dP_N / rho_N = 0,    rho = kappa / w
//     sticks     u_T + J_T dv + b_T + dP_T / rho_T = 0;    slides  P_T = +-mu P_N;    open  P = 0
//     (M + sum rho F' J) dv = right-hand side,             F the direction of a point's impulse
// one sparse system in the bodies' velocities (contact_matrix.h). The proximal term vanishes as dP does, so
// that what the iteration ends at obeys the laws themselves; among the many impulses that a redundant contact
// allows it takes those next to the guess. While the set does not change, one factorisation serves all
// iterations. A few blocks are solved so in one to three iterations. Where many contacts open or slip at once
// the set may go round in circles; then steps of a method that descends take over (cone_descent.h), with
// Newton's method tried again between them.
//
// Alart and Curnier, Comput. Methods Appl. Mech. Engrg. 92 (1991) 353-375; Rockafellar, Math. Oper. Res. 1
// (1976) 97-116, on the proximal method of multipliers.
#pragma once

#include "engine/nonsmooth/cone_descent.h"

namespace dougong::engine {

struct ImpulseSolution {
  double residual = 0.0;       // m/s
  std::size_t iterations = 0;  // of Newton
  std::size_t rounds = 0;      // of descents and of Newton's method between them
  bool converged = true;
};

class ImpulseSolver {
 public:
  /// Improves the impulses of the problem until the residual is at most 1e-7 of `speed` (m/s), or 1e-3 of it
  /// where Newton's method does not get there, and leaves the velocities that belong to them. A guess within
  /// 1e-6 is left as it is. Of a solution that does not converge, the best impulses met are left.
  ImpulseSolution solve(ImpulseProblem& problem, double speed);

 private:
  enum class Status : std::uint8_t { open, sticks, slides_forward, slides_back };
  Status status_of(const ImpulsePoint& point, Vec2 u) const;
  void find_statuses(const ImpulseProblem& problem);
  void prepare(const ImpulseProblem& problem);
  void assemble(const ImpulseProblem& problem);
  void add_to_right_side(const ImpulseProblem& problem, const ImpulsePoint& point, Vec2 impulse);
  Vec2 change_of(std::size_t i, const ImpulsePoint& point, Vec2 u) const;
  bool step(ImpulseProblem& problem);
  double note(const ImpulseProblem& problem);
  void iterate(ImpulseProblem& problem, std::size_t most, ImpulseSolution& solution);
  void set_impulses(ImpulseProblem& problem, std::span<const Vec2> impulses) const;

  std::vector<Status> statuses_, factorised_;
  ContactMatrix matrix_;
  ConeDescent cone_;
  std::vector<PlaneVelocity> change_;          // of the bodies' velocities; of the terrains', zero
  std::vector<Vec2> best_, start_;             // impulses
  double best_residual_ = 0.0, target_ = 0.0;  // m/s
};

}  // namespace dougong::engine
