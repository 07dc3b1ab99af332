// A displacement given by a table at equal intervals, followed by a cubic spline: twice continuously
// differentiable, so that displacement, velocity and acceleration are one motion.
//
// With M[k] the acceleration at knot k, h the interval and s = t - k h:
//   a(t) = M[k] (1 - s/h) + M[k+1] s/h
//   M[k-1] + 4 M[k] + M[k+1] = 6 (d[k-1] - 2 d[k] + d[k+1]) / h^2     inside
//   2 M[0] + M[1] = 6 (d[1] - d[0]) / h^2                             at rest at both ends
// Behind the last knot the ground rests where it is (de Boor, A Practical Guide to Splines, 1978, ch. IV).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/motion.h"

namespace dougong::seismic {

class TableMotion final : public engine::PrescribedMotion {
 public:
  /// Displacements in m, interval in s. Throws std::invalid_argument for fewer than two or an interval that
  /// is not positive.
  TableMotion(std::vector<engine::Vec2> displacements, double interval);
  engine::MotionSample at(double t) const override;
  double knot_interval() const override { return interval_; }
  double duration() const { return interval_ * static_cast<double>(displacements_.size() - 1); }

 private:
  std::vector<engine::Vec2> displacements_, accelerations_;
  double interval_;
};

struct MotionTable {
  std::vector<engine::Vec2> displacements;  // m
  double interval = 0.0;                    // s
  std::string sha256;
};

/// A CSV file: time (s), displacement x (m) and, if any, y (m), at equal intervals from 0; a head line and
/// lines that start with # are skipped. Throws InputError.
MotionTable read_motion_table(const std::filesystem::path& path);

}  // namespace dougong::seismic
