#include "seismic/motions/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dougong::seismic {
namespace {

// Appends knots whose acceleration falls from its last value to zero along a half cosine, plus a full cosine
// bell of the size that makes the velocity zero as well.
void close(std::vector<double>& a, double velocity, double interval, double closing_time) {
  const std::size_t knots =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(closing_time / interval)));
  const double last = a.back();
  double from_fall = 0.5 * interval * last, from_bell = 0.0;  // m/s; the bell of height 1
  std::vector<double> fall(knots), bell(knots);
  for (std::size_t k = 1; k <= knots; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(knots);
    fall[k - 1] = k == knots ? 0.0 : 0.5 * last * (1.0 + std::cos(std::numbers::pi * share));
    bell[k - 1] = k == knots ? 0.0 : 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
    from_fall += interval * fall[k - 1];
    from_bell += interval * bell[k - 1];
  }
  const double height = -(velocity + from_fall) / from_bell;
  for (std::size_t k = 0; k < knots; ++k) a.push_back(fall[k] + height * bell[k]);
}

struct Kinematics {
  double a, v, d;
};

Kinematics between_knots(const GroundHistory& h, std::size_t k, double s) {
  const double a = h.acceleration[k], j = (h.acceleration[k + 1] - a) / h.interval;
  return {a + j * s, h.velocity[k] + s * (a + 0.5 * j * s),
          h.displacement[k] + s * (h.velocity[k] + s * (0.5 * a + s * j / 6.0))};
}

Kinematics after_end(const GroundHistory& h, double s) {
  const double v = h.velocity.back();
  return {0.0, v, h.displacement.back() + v * s};
}

void check(std::span<const double> acceleration, double interval) {
  if (!(interval > 0.0) || !std::isfinite(interval))
    throw std::invalid_argument("ground motion: interval not positive");
  if (acceleration.size() < 2) throw std::invalid_argument("ground motion: fewer than two samples");
  for (const double a : acceleration) {
    if (!std::isfinite(a)) throw std::invalid_argument("ground motion: a sample is not finite");
  }
}

}  // namespace

GroundMotion::GroundMotion(std::span<const double> horizontal,
                           std::optional<std::span<const double>> vertical, double interval,
                           const EndOptions& end)
    : interval_(interval) {
  check(horizontal, interval);
  if (vertical) check(*vertical, interval);
  const std::size_t samples = std::max(horizontal.size(), vertical ? vertical->size() : 0);
  horizontal_ = history(horizontal, samples, end);
  if (vertical) vertical_ = history(*vertical, samples, end);
  velocity_left_ = integrate(horizontal, interval).velocity.back();
}

GroundHistory GroundMotion::history(std::span<const double> acceleration, std::size_t samples,
                                    const EndOptions& end) {
  std::vector<double> a(acceleration.begin(), acceleration.end());
  a.resize(samples, 0.0);
  if (end.after == AfterEnd::coast) return integrate(a, interval_);
  close(a, integrate(a, interval_).velocity.back(), interval_, end.closing_time);
  for (std::size_t k = samples; k < a.size(); ++k) {
    closing_acceleration_ = std::max(closing_acceleration_, std::abs(a[k]));
  }
  GroundHistory out = integrate(a, interval_);
  out.velocity.back() = 0.0;  // zero by construction but for rounding, which would carry the ground away
  return out;
}

engine::MotionSample GroundMotion::at(double t) const {
  if (!(t >= 0.0)) return {};
  const std::size_t last = horizontal_.acceleration.size() - 1;
  const double steps = t / interval_;
  const bool over = steps >= static_cast<double>(last);
  const std::size_t k = over ? last : static_cast<std::size_t>(steps);
  const double s = t - interval_ * static_cast<double>(k);
  const auto kinematics = [&](const GroundHistory& h) {
    return over ? after_end(h, s) : between_knots(h, k, s);
  };
  const Kinematics x = kinematics(horizontal_);
  const Kinematics y = vertical_ ? kinematics(*vertical_) : Kinematics{0.0, 0.0, 0.0};
  return {{x.d, y.d}, {x.v, y.v}, {x.a, y.a}};
}

std::vector<double> GroundMotion::times() const {
  std::vector<double> out(horizontal_.acceleration.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = interval_ * static_cast<double>(k);
  return out;
}

}  // namespace dougong::seismic
