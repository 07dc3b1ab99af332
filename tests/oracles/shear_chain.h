// Masses one above the other, each tied to the one below by a spring and a dashpot, on a ground that shakes:
//   m_i (u_i'' + a) + alpha m_i u_i' + c_i d_i' - c_(i+1) d_(i+1)' + f_i(d_i) - f_(i+1)(d_(i+1)) = 0
// u relative to the ground, d_i = u_i - u_(i-1). Springs may yield: bilinear with kinematic hardening.
// Integrated by RK4 with steps of 0.1 ms or less, an interval of the record (linear between samples) at a
// time; the error is below 1e-6 of the response.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace dougong::oracles {

struct ChainLevel {
  double mass = 0.0, stiffness = 0.0, damping = 0.0;       // kg, N/m, N s/m
  double yield = std::numeric_limits<double>::infinity();  // m, drift at which the spring yields
  double hardening = 0.0;                                  // stiffness after yielding over that before
  double drag = 0.0;                                       // N s/m, against the motion over the ground
};

struct ChainPeaks {
  std::vector<double> drift, acceleration;  // m, m/s2 (absolute), of each level
  double roof = 0.0, roof_time = 0.0;       // m, s
  double base_shear = 0.0;                  // N, of the lowest spring
  double plastic = 0.0, last = 0.0;         // m, of the lowest spring; its drift at the end
  double plastic_work = 0.0;                // J, of the lowest spring
};

class ShearChain {
 public:
  explicit ShearChain(std::vector<ChainLevel> levels) : levels_(std::move(levels)) {
    u_.resize(levels_.size()), v_.resize(levels_.size()), plastic_.resize(levels_.size());
  }

  ChainPeaks run(const std::vector<double>& acceleration, double dt, int parts = 100) {
    ChainPeaks peaks;
    peaks.drift.resize(levels_.size()), peaks.acceleration.resize(levels_.size());
    const double h = dt / parts;
    for (std::size_t k = 0; k + 1 < acceleration.size(); ++k)
      for (int i = 0; i < parts; ++i) {
        const auto ground = [&](double part) {
          return acceleration[k] + (i + part) / parts * (acceleration[k + 1] - acceleration[k]);
        };
        step(h, ground(0.0), ground(0.5), ground(1.0), peaks);
        note((static_cast<double>(k) + (i + 1.0) / parts) * dt, peaks);
      }
    peaks.plastic = plastic_[0], peaks.last = u_[0];
    return peaks;
  }

 private:
  using Values = std::vector<double>;

  double drift(const Values& u, std::size_t i) const { return u[i] - (i == 0 ? 0.0 : u[i - 1]); }
  // The elastoplastic part of the spring beside its elastic one.
  double flow(std::size_t i, double d) const {
    const double slip = d - plastic_[i];
    return std::abs(slip) > levels_[i].yield ? slip - std::copysign(levels_[i].yield, slip) : 0.0;
  }
  double spring(std::size_t i, double d) const {
    const ChainLevel& l = levels_[i];
    return l.stiffness * (d - (1.0 - l.hardening) * (plastic_[i] + flow(i, d)));
  }
  double link(const Values& u, const Values& v, std::size_t i) const {
    return i < levels_.size() ? spring(i, drift(u, i)) + levels_[i].damping * drift(v, i) : 0.0;
  }
  Values rate(const Values& u, const Values& v, double ground) const {
    Values a(u.size());
    for (std::size_t i = 0; i < u.size(); ++i)
      a[i] = -ground - (levels_[i].drag * v[i] + link(u, v, i) - link(u, v, i + 1)) / levels_[i].mass;
    return a;
  }
  static Values moved(const Values& x, const Values& rate, double h) {
    Values y = x;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * rate[i];
    return y;
  }
  void step(double h, double before, double middle, double after, ChainPeaks& peaks) {
    const Values a1 = rate(u_, v_, before), v2 = moved(v_, a1, 0.5 * h);
    const Values a2 = rate(moved(u_, v_, 0.5 * h), v2, middle), v3 = moved(v_, a2, 0.5 * h);
    const Values a3 = rate(moved(u_, v2, 0.5 * h), v3, middle), v4 = moved(v_, a3, h);
    const Values a4 = rate(moved(u_, v3, h), v4, after);
    for (std::size_t i = 0; i < u_.size(); ++i) {
      u_[i] += h / 6.0 * (v_[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
      v_[i] += h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
    }
    for (std::size_t i = 0; i < u_.size(); ++i) {
      const double slip = flow(i, drift(u_, i));
      plastic_[i] += slip;
      const ChainLevel& l = levels_[i];
      if (i == 0 && slip != 0.0)
        peaks.plastic_work += std::abs(slip) * (1.0 - l.hardening) * l.stiffness * l.yield;
    }
    last_ = rate(u_, v_, after);
    for (double& a : last_) a += after;
  }
  void note(double time, ChainPeaks& peaks) const {
    const auto larger = [](double& most, double value) { most = std::max(most, std::abs(value)); };
    for (std::size_t i = 0; i < u_.size(); ++i) {
      larger(peaks.drift[i], drift(u_, i));
      larger(peaks.acceleration[i], last_[i]);
    }
    larger(peaks.base_shear, spring(0, u_[0]));
    if (std::abs(u_.back()) > peaks.roof) peaks.roof = std::abs(u_.back()), peaks.roof_time = time;
  }

  std::vector<ChainLevel> levels_;
  Values u_, v_, plastic_, last_;
};

}  // namespace dougong::oracles
