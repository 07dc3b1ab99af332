// Prince and Dormand's Runge-Kutta pair of orders 8 and 7, by GSL, with step control and events
// (adaptive.h): for smooth motion to many digits.
//
// Thirteen stages on [q | v | work]; GSL is asked for single steps only (gsl_odeiv2_step_rk8pd), so that the
// friction history is committed at accepted sub-steps.
// Prince and Dormand, J. Comp. Appl. Math. 7 (1981) 67-75; GSL Reference Manual 2.7, ch. 28.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <tuple>

#include "engine/integrators/adaptive.h"

namespace dougong::engine {

class PrinceDormandPair {
 public:
  static constexpr IntegratorTraits traits{"rk8", 8, 8, 13, false, 0.0, true};
  static constexpr unsigned alpha = 7, beta = 1;  // sixty-fourths: about 1/8

  void resize(std::size_t n) {
    if (stepper_ && n == n_) return;
    n_ = n;
    const std::size_t size = 2 * n + works;
    stepper_.reset(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size));
    for (auto* x : {&first_, &y_, &error_}) x->assign(size, 0.0);
    end_rate_.assign(n, 0.0);
  }

  template <SecondOrderSystem S>
  void begin(S& system, double t, std::span<const double> q, std::span<const double> v) {
    const Powers p = system.accelerate(t, q, v, part(first_, n_), true);
    std::copy(v.begin(), v.end(), first_.begin());
    std::copy(p.values.begin(), p.values.end(), first_.end() - works);
  }

  template <SecondOrderSystem S>
  Powers attempt(S& system, double t, double h, std::span<const double> q, std::span<const double> v) {
    std::copy(q.begin(), q.end(), y_.begin());
    std::copy(v.begin(), v.end(), y_.begin() + static_cast<std::ptrdiff_t>(n_));
    std::fill(y_.end() - works, y_.end(), 0.0);
    Call<S> call{&system, n_};
    const gsl_odeiv2_system equations{&rates<S>, nullptr, y_.size(), &call};
    gsl_odeiv2_step_apply(stepper_.get(), t, h, y_.data(), error_.data(), first_.data(), nullptr, &equations);
    Powers work;
    std::copy(y_.end() - works, y_.end(), work.values.begin());
    return work;
  }

  template <SecondOrderSystem S>
  void evaluate_end(S& system, double t) {
    system.accelerate(t, end_q(), end_v(), end_rate_, false);
  }
  bool continues() { return false; }

  std::span<const double> end_q() const { return {y_.data(), n_}; }
  std::span<const double> end_v() const { return {y_.data() + n_, n_}; }
  std::span<const double> first_a() const { return {first_.data() + n_, n_}; }
  std::span<const double> error_q() const { return {error_.data(), n_}; }
  std::span<const double> error_v() const { return {error_.data() + n_, n_}; }

 private:
  static constexpr std::ptrdiff_t works = std::tuple_size_v<decltype(Powers::values)>;

  template <class S>
  struct Call {
    S* system;
    std::size_t n;
  };
  template <class S>
  static int rates(double t, const double* y, double* rate, void* params) {
    const auto& call = *static_cast<Call<S>*>(params);
    const std::size_t n = call.n;
    const Powers p = call.system->accelerate(t, {y, n}, {y + n, n}, {rate + n, n}, false);
    std::copy(y + n, y + 2 * n, rate);
    std::copy(p.values.begin(), p.values.end(), rate + 2 * n);
    return GSL_SUCCESS;
  }
  static std::span<double> part(std::vector<double>& y, std::size_t n) { return {y.data() + n, n}; }

  struct Free {
    void operator()(gsl_odeiv2_step* stepper) const { gsl_odeiv2_step_free(stepper); }
  };
  std::unique_ptr<gsl_odeiv2_step, Free> stepper_;
  std::size_t n_ = 0;
  std::vector<double> first_, y_, error_, end_rate_;
};

using Rk8 = Adaptive<PrinceDormandPair>;

}  // namespace dougong::engine
