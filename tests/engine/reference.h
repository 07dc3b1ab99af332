// One line for every value that is measured against a reference, so that docs/validation.md can be
// checked against what the tests print: "case quantity reference measured error tol".
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace dougong::testing {

inline void report(const std::string& name, const std::string& quantity, double reference, double measured,
                   double error, double tolerance) {
  std::printf("%s %s %.9g %.9g %.3g %.3g\n", name.c_str(), quantity.c_str(), reference, measured, error,
              tolerance);
  EXPECT_LE(error, tolerance) << name << " " << quantity << ": " << measured << " against " << reference;
}
inline void expect_relative(const std::string& name, const std::string& quantity, double reference,
                            double measured, double tolerance) {
  report(name, quantity, reference, measured, std::abs(measured / reference - 1.0), tolerance);
}
inline void expect_absolute(const std::string& name, const std::string& quantity, double reference,
                            double measured, double tolerance) {
  report(name, quantity, reference, measured, std::abs(measured - reference), tolerance);
}

/// A number as a part of a name, without trailing zeros.
inline std::string text(double value) {
  std::string s = std::to_string(value);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s;
}
/// The same where it may be very small or large: 1e-06.
inline std::string scientific(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value);
  return digits;
}

}  // namespace dougong::testing
