// Sub-steps of an embedded method within one step of drive(), as long as the tolerated error allows, ending
// at the system's events.
//
// A Method advances one sub-step from its first stage and estimates the error:
//     resize(n), begin(system, t, q, v), attempt(system, t, h, q, v) -> Powers, end_q/end_v, error_q/error_v,
//     evaluate_end(system, t), continues() (the end's stage becomes the first), alpha, beta
// Estimated errors are compared, in the largest norm, with tolerance x (length of the scene | greatest speed,
// at least that of a free fall over it). The friction history is committed by the first stage of every
// accepted sub-step and by no other. Nothing is allocated once the sizes are known.
#pragma once

#include <limits>

#include "engine/integrators/error_control.h"
#include "engine/integrators/events.h"
#include "engine/integrators/integrator.h"

namespace dougong::engine {

template <class S>
concept HasEvents = requires(S s, std::span<double> values, bool at_start) {
  { s.event_count() } -> std::convertible_to<std::size_t>;
  s.events(values, at_start);
};

template <class Method>
class Adaptive {
 public:
  static constexpr IntegratorTraits traits = Method::traits;

  /// Stability is seen as error: no bound is needed.
  static double stable_step(double, double) { return std::numeric_limits<double>::infinity(); }
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }
  /// Empty, or why the integration cannot go on. Nothing moves any more then.
  std::string_view trouble() const { return trouble_; }
  void restart() {
    fresh_ = false, proposal_ = 0.0;
    controller_.restart();
  }

  template <SecondOrderSystem S>
  Powers step(S& system, double t, double h, std::span<double> q, std::span<double> v) {
    method_.resize(q.size());
    read_scales(system);
    Powers work{};
    double done = 0.0;
    while (done < h && trouble_.empty()) {
      const double rest = h - done;
      double taken = rest;
      work = work + advance(system, t + done, q, v, taken);
      done = taken == rest ? h : done + taken;
    }
    return work;
  }

 private:
  // Times below which a step no longer changes the time.
  static constexpr double resolution = 16.0 * std::numeric_limits<double>::epsilon();

  // One accepted sub-step of at most `taken`; returns its work and its length in `taken`.
  template <SecondOrderSystem S>
  Powers advance(S& system, double t, std::span<double> q, std::span<double> v, double& taken) {
    if (!fresh_) method_.begin(system, t, q, v);
    fresh_ = false;
    note_start(system);
    if (proposal_ == 0.0) proposal_ = first_step(v, taken);
    const double least = resolution * std::max(std::abs(t), taken);
    double h = proposal_ < 0.99 * taken ? proposal_ : taken;
    Powers work;
    for (;; h = proposal_ = controller_.after_rejection(h, error_)) {
      if (h < least) return trouble_ = "the error asks for a step below the resolution of time", Powers{};
      work = method_.attempt(system, t, h, q, v);
      error_ = scaled_error(v, h);
      if (error_ <= 1.0) break;
    }
    const double next = controller_.after_acceptance(h, error_);
    proposal_ = h < proposal_ ? std::max(next, proposal_) : next;
    if constexpr (HasEvents<S>) locate_event(system, t, h, q, v, work);
    accept(system, q, v);
    taken = h;
    return work;
  }

  template <SecondOrderSystem S>
  void note_start(S& system) {
    if constexpr (HasEvents<S>) {
      events_.resize(system.event_count());
      tried_.resize(system.event_count());
      system.events(events_.start(), true);
    }
  }

  // Shortens the step that ended at t + h to the first event in it.
  template <HasEvents S>
  void locate_event(S& system, double t, double& h, std::span<const double> q, std::span<const double> v,
                    Powers& work) {
    if (tried_.empty()) return;
    method_.evaluate_end(system, t + h);
    system.events(events_.now(), false);
    if (!events_.begins(h)) return;
    const double dt = std::max(tolerance_ * h, resolution * std::abs(t));
    bool at_end = true;
    while (!events_.found(dt)) {
      const double time = events_.next_time(dt);
      work = try_until(system, t, time, q, v);
      at_end = events_.note(time, tried_);
    }
    if (!at_end) work = try_until(system, t, events_.high_time(), q, v);
    h = events_.high_time();
  }

  template <HasEvents S>
  Powers try_until(S& system, double t, double h, std::span<const double> q, std::span<const double> v) {
    const Powers work = method_.attempt(system, t, h, q, v);
    method_.evaluate_end(system, t + h);
    system.events(tried_, false);
    return work;
  }

  // A system that remembers must be told of the accepted state by a first stage of its own.
  template <SecondOrderSystem S>
  void accept(S& system, std::span<double> q, std::span<double> v) {
    std::copy(method_.end_q().begin(), method_.end_q().end(), q.begin());
    std::copy(method_.end_v().begin(), method_.end_v().end(), v.begin());
    bool remembers = false;
    if constexpr (requires { system.has_memory(); }) remembers = system.has_memory();
    fresh_ = !remembers && method_.continues();
  }

  template <SecondOrderSystem S>
  void read_scales(S& system) {
    if constexpr (requires { system.scales(); }) scales_ = system.scales();
  }
  double lever(std::size_t i) const { return scales_.lever.empty() ? 1.0 : scales_.lever[i]; }
  double largest(std::span<const double> x) const {
    double result = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) result = std::max(result, lever(i) * std::abs(x[i]));
    return result;
  }

  // std::max would lose a value that is not a number.
  double scaled_error(std::span<const double> v, double h) const {
    const double speed =
        std::max({scales_.speed, largest(v), largest(method_.end_v()), h * largest(method_.first_a())});
    const double in_q = 1.0 / (tolerance_ * scales_.length);
    const double in_v = speed > 0.0 ? 1.0 / (tolerance_ * speed) : 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double e =
          lever(i) * std::max(in_q * std::abs(method_.error_q()[i]), in_v * std::abs(method_.error_v()[i]));
      if (!(e <= error)) error = e;
    }
    return std::isnan(largest_or_nan(method_.end_q())) ? std::numeric_limits<double>::infinity() : error;
  }
  static double largest_or_nan(std::span<const double> x) {
    double sum = 0.0;
    for (const double value : x) sum += 0.0 * value;
    return sum;
  }

  // In which neither the speed nor the acceleration carries a body further than a part of the scene's length.
  double first_step(std::span<const double> v, double most) const {
    const double part = power_64th(tolerance_, Method::alpha);
    const double speed = largest(v), acceleration = largest(method_.first_a());
    double h = most;
    if (speed > 0.0) h = std::min(h, part * scales_.length / speed);
    if (acceleration > 0.0) h = std::min(h, part * std::sqrt(scales_.length / acceleration));
    return h;
  }

  Method method_;
  StepController controller_{Method::alpha, Method::beta};
  EventBracket events_;
  std::vector<double> tried_;
  Scales scales_;
  double tolerance_ = 1e-8, proposal_ = 0.0, error_ = 0.0;
  bool fresh_ = false;  // the method holds the first stage of the present state
  std::string_view trouble_;
};

}  // namespace dougong::engine
