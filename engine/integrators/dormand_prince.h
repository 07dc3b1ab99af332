// Dormand and Prince's Runge-Kutta pair of orders 5 and 4, with step control and events (adaptive.h).
//
// Advances with the fifth order; the fourth estimates the error. Seven stages, the last of which is the
// first of the next step: six evaluations a step, seven where friction has to be told of the accepted state.
// Dormand and Prince, J. Comp. Appl. Math. 6 (1980) 19-26, table 2 (RK5(4)7M).
#pragma once

#include "engine/integrators/adaptive.h"

namespace dougong::engine {

class DormandPrincePair {
 public:
  static constexpr IntegratorTraits traits{"dormand-prince", 5, 5, 6, false, 0.0, true};
  static constexpr unsigned alpha = 11, beta = 2;  // sixty-fourths: 1/5 - 3/4 beta, 1/32

  void resize(std::size_t n) {
    for (auto* set : {&a_, &v_})
      for (auto& x : *set) x.resize(n);
    for (auto* x : {&q_, &error_q_, &error_v_}) x->resize(n);
  }

  template <SecondOrderSystem S>
  void begin(S& system, double t, std::span<const double> q, std::span<const double> v) {
    p_[0] = system.accelerate(t, q, v, a_[0], true);
    std::copy(v.begin(), v.end(), v_[0].begin());
  }

  template <SecondOrderSystem S>
  Powers attempt(S& system, double t, double h, std::span<const double> q, std::span<const double> v) {
    for (std::size_t s = 1; s < stages; ++s) {
      for (std::size_t i = 0; i < q.size(); ++i) {
        double dq = 0.0, dv = 0.0;
        for (std::size_t j = 0; j < s; ++j) dq += rows[s][j] * v_[j][i], dv += rows[s][j] * a_[j][i];
        q_[i] = q[i] + h * dq;
        v_[s][i] = v[i] + h * dv;
      }
      p_[s] = system.accelerate(t + nodes[s] * h, q_, v_[s], a_[s], false);
    }
    return estimate(h);
  }

  /// The last stage was there.
  template <SecondOrderSystem S>
  void evaluate_end(S&, double) {}
  bool continues() {
    std::swap(a_[0], a_[6]), std::swap(v_[0], v_[6]);
    p_[0] = p_[6];
    return true;
  }

  std::span<const double> end_q() const { return q_; }
  std::span<const double> end_v() const { return v_[6]; }
  std::span<const double> first_a() const { return a_[0]; }
  std::span<const double> error_q() const { return error_q_; }
  std::span<const double> error_v() const { return error_v_; }

 private:
  static constexpr std::size_t stages = 7;
  using Row = std::array<double, stages>;
  static constexpr Row nodes{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  // The last row holds the weights of order 5.
  static constexpr std::array<Row, stages> rows{
      {{},
       {1.0 / 5},
       {3.0 / 40, 9.0 / 40},
       {44.0 / 45, -56.0 / 15, 32.0 / 9},
       {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
       {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
       {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
  // Weights of order 5 less those of order 4.
  static constexpr Row difference{71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                  -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

  Powers estimate(double h) {
    Powers work{};
    for (std::size_t s = 0; s < 6; ++s) work = work + (h * rows[6][s]) * p_[s];
    for (std::size_t i = 0; i < q_.size(); ++i) {
      double dq = 0.0, dv = 0.0;
      for (std::size_t s = 0; s < stages; ++s) dq += difference[s] * v_[s][i], dv += difference[s] * a_[s][i];
      error_q_[i] = h * dq, error_v_[i] = h * dv;
    }
    return work;
  }

  std::array<std::vector<double>, stages> a_, v_;
  std::array<Powers, stages> p_;
  std::vector<double> q_, error_q_, error_v_;
};

using DormandPrince = Adaptive<DormandPrincePair>;

}  // namespace dougong::engine
