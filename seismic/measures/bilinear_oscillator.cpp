#include "seismic/measures/bilinear_oscillator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "seismic/constants.h"

namespace dougong::seismic {
namespace {

constexpr int terms = 16;             // 0.5^16/16! < 1e-18
constexpr double longest_part = 0.5;  // rad of the elastic oscillator

struct Motion {
  double u = 0.0, v = 0.0;
};

// A linear oscillator u'' = -(a0 + a1 t) - force - c u' - k u as a power series about t = 0.
class Series {
 public:
  Series(Motion from, double a0, double a1, double force, double damping, double stiffness) {
    c_[0] = from.u;
    c_[1] = from.v;
    c_[2] = -0.5 * (a0 + force + damping * from.v + stiffness * from.u);
    c_[3] = -(a1 + 2.0 * damping * c_[2] + stiffness * from.v) / 6.0;
    for (int n = 4; n < terms; ++n) {
      const auto i = static_cast<std::size_t>(n);
      c_[i] = -(damping * (n - 1) * c_[i - 1] + stiffness * c_[i - 2]) / (n * (n - 1));
    }
  }
  Motion at(double t) const {
    Motion m;
    for (std::size_t i = terms; i-- > 0;) {
      m.v = m.v * t + m.u;
      m.u = m.u * t + c_[i];
    }
    return m;
  }

 private:
  std::array<double, terms> c_{};
};

// The root of a continuous function between points of unlike sign, by bisection to the last bits.
template <typename Function>
double root_between(Function f, double low, double high) {
  const bool rising = f(low) < 0.0;
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    ((f(middle) < 0.0) == rising ? low : high) = middle;
  }
  return high;
}

class Yielding {
 public:
  /// For parts of length h.
  Yielding(const BilinearOscillator& o, double h)
      : h_(h),
        elastic_step_(oscillator_step(o.elastic, h)),
        w2_(std::pow(two_pi / o.elastic.period, 2)),
        damping_(2.0 * o.elastic.damping_ratio * two_pi / o.elastic.period),
        yield_(o.yield_displacement),
        hardening_(o.hardening_ratio) {}

  /// A part whose ground acceleration goes from a0 by the slope a1.
  void advance(double a0, double a1) {
    if (direction_ == 0.0 && stays_elastic(a0, a1)) return;
    double done = 0.0;
    while (done < h_) {
      const double left = h_ - done;
      const Series series = branch(a0 + a1 * done, a1);
      const double used = direction_ == 0 ? elastic(series, left) : plastic(series, left);
      done = used < left ? done + used : h_;
    }
  }

  BilinearResponse result() const {
    BilinearResponse out = out_;
    out.last_displacement = now_.u;
    out.plastic_displacement = plastic_;
    return out;
  }

 private:
  double offset_force() const {
    const double offset = direction_ == 0.0 ? -plastic_ : direction_ * yield_;
    return offset == 0.0 ? 0.0 : (1.0 - hardening_) * w2_ * offset;
  }

  // Most parts do not yield, and reach no peak if they turn: the coefficients of one elastic step do for
  // them.
  bool stays_elastic(double a0, double a1) {
    const OscillatorStep& c = elastic_step_;
    const double b0 = a0 + offset_force(), b1 = b0 + a1 * h_;
    const Motion end{(c.uu * now_.u + c.uv * now_.v) + (c.ua * b0 + c.ub * b1),
                     (c.vu * now_.u + c.vv * now_.v) + (c.va * b0 + c.vb * b1)};
    // How far u may go beyond both ends of a part in which it turns; twice, for a speed that is not straight.
    const double beyond = now_.v * end.v < 0.0 ? 2.0 * h_ * std::max(std::abs(now_.v), std::abs(end.v)) : 0.0;
    const double stretch = std::max(std::abs(now_.u - plastic_), std::abs(end.u - plastic_)) + beyond;
    const double size = std::max(std::abs(now_.u), std::abs(end.u)) + beyond;
    const double force = w2_ * (hardening_ * size + (1.0 - hardening_) * stretch);
    if (stretch > yield_) return false;
    if (beyond > 0.0 && (size > out_.peak_displacement || force > out_.peak_force)) return false;
    move(end);
    return true;
  }

  Series branch(double a0, double a1) const {
    return {now_, a0, a1, offset_force(), damping_, direction_ == 0.0 ? w2_ : hardening_ * w2_};
  }

  // Time used: all that is left, or up to the first yielding.
  double elastic(const Series& series, double left) {
    const auto speed = [&](double t) { return series.at(t).v; };
    const Motion end = series.at(left);
    if (now_.v * end.v < 0.0) {  // it turns on the way
      const double turn = root_between(speed, 0.0, left);
      const double used = reach(series, 0.0, turn);
      return direction_ == 0.0 ? reach(series, turn, left) : used;
    }
    return reach(series, 0.0, left);
  }

  // Moves on from `from` to `to`, between which the speed keeps its sign, or to the yielding on the way.
  double reach(const Series& series, double from, double to) {
    const double stretch = series.at(to).u - plastic_;
    if (std::abs(stretch) <= yield_) {
      move(series.at(to));
      return to;
    }
    const double side = stretch > 0.0 ? 1.0 : -1.0;
    const double at =
        root_between([&](double t) { return side * (series.at(t).u - plastic_) - yield_; }, from, to);
    move(series.at(at));
    direction_ = side;
    ++out_.branch_changes;
    return at;
  }

  // Time used: all that is left, or up to where the speed turns.
  double plastic(const Series& series, double left) {
    const auto forward = [&](double t) { return direction_ * series.at(t).v; };
    const bool turns = forward(left) < 0.0;
    const double at = forward(0.0) < 0.0 ? 0.0 : turns ? root_between(forward, 0.0, left) : left;
    const double before = plastic_;
    move(series.at(at));
    plastic_ = now_.u - direction_ * yield_;
    out_.plastic_work += (1.0 - hardening_) * w2_ * yield_ * std::abs(plastic_ - before);
    if (at == left) return left;
    direction_ = 0.0;
    ++out_.branch_changes;
    return at;
  }

  void move(Motion to) {
    now_ = to;
    note(to.u, to.v);
  }

  void note(double u, double v) {
    const double stretch = direction_ == 0.0 ? u - plastic_ : direction_ * yield_;
    const double force = w2_ * (hardening_ * u + (1.0 - hardening_) * stretch);
    out_.peak_displacement = std::max(out_.peak_displacement, std::abs(u));
    out_.peak_force = std::max(out_.peak_force, std::abs(force));
    out_.peak_acceleration = std::max(out_.peak_acceleration, std::abs(force + damping_ * v));
  }

  double h_;
  OscillatorStep elastic_step_;
  double w2_, damping_, yield_, hardening_;
  Motion now_;
  double plastic_ = 0.0;
  double direction_ = 0.0;  // of yielding, +1 or -1; 0 while elastic
  BilinearResponse out_;
};

}  // namespace

BilinearResponse bilinear_response(std::span<const double> a, double interval,
                                   const BilinearOscillator& oscillator) {
  const double angle = two_pi / oscillator.elastic.period * interval;
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / longest_part)));
  const double h = interval / parts;
  Yielding motion(oscillator, h);
  for (std::size_t k = 1; k < a.size(); ++k) {
    const double slope = (a[k] - a[k - 1]) / interval;
    for (int i = 0; i < parts; ++i) motion.advance(a[k - 1] + slope * h * i, slope);
  }
  return motion.result();
}

DuctilityPoint constant_ductility(std::span<const double> a, double interval, const Oscillator& elastic,
                                  double ductility, double hardening_ratio) {
  constexpr double next = 1.05;     // the search's ratio of strengths
  constexpr double weakest = 1e-4;  // of the elastic strength
  constexpr int halvings = 30;      // of 5 %
  const double limit = bilinear_response(a, interval, {elastic}).peak_displacement;
  const auto peak_of = [&](double yield) {
    return bilinear_response(a, interval, {elastic, yield, hardening_ratio}).peak_displacement;
  };
  DuctilityPoint out{elastic.period, limit > 0.0 ? 1.0 : 0.0, limit, 0.0, 1.0, 1.0};
  if (limit > 0.0 && ductility > 1.0) {
    double strong = limit, weak = limit / next;
    while (peak_of(weak) / weak < ductility && weak > weakest * limit)
      strong = std::exchange(weak, weak / next);
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (strong + weak);
      (peak_of(middle) / middle < ductility ? strong : weak) = middle;
    }
    out.yield_displacement = weak;
    const double peak = peak_of(weak);
    out.ductility = peak / weak, out.strength_reduction = limit / weak, out.inelastic_ratio = peak / limit;
  }
  out.yield_acceleration = std::pow(two_pi / elastic.period, 2) * out.yield_displacement;
  return out;
}

std::vector<DuctilityPoint> constant_ductility_spectrum(std::span<const double> a, double interval,
                                                        std::span<const double> periods, double ductility,
                                                        double damping_ratio, double hardening_ratio) {
  std::vector<DuctilityPoint> spectrum;
  for (const double period : periods)
    spectrum.push_back(constant_ductility(a, interval, {period, damping_ratio}, ductility, hardening_ratio));
  return spectrum;
}

}  // namespace dougong::seismic
