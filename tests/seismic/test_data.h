// Where the tests find their data, and the synthetic accelerograms of the validation cases.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "seismic/input_error.h"

namespace dougong::seismic::testing {

inline std::filesystem::path source_directory() {
  return DOUGONG_SOURCE_DIR;
}

/// Recordings are not part of the project (their owners forbid redistribution): tests that need them are
/// skipped where they are absent.
inline std::filesystem::path real_record(const std::string& name) {
  return source_directory() / ".." / "shared" / "real-records" / name;
}

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "recording not available: " << (path).string()

/// A file of the given bytes in a folder of this test's own.
inline std::filesystem::path write_file(const std::string& name, const std::string& bytes) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) /
                      ("dougong-seismic-" + std::to_string(::getpid())) /
                      (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary) << bytes;
  return folder / name;
}

/// SYN(seed, A): 48 cosines of random phase under an envelope, analytic at any t.
class Syn {
 public:
  Syn(std::uint32_t seed, double amplitude) : amplitude_(amplitude) {
    std::uint32_t x = seed;
    double sum = 0.0;
    for (int i = 1; i <= 48; ++i) {
      x = 1664525u * x + 1013904223u;
      const double f = 0.1 * std::pow(200.0, (i - 1) / 47.0), r = f / 2.5;
      const double low = (f / 0.3) * (f / 0.3);
      const double c = std::sqrt(f) *
                       std::sqrt((1 + 1.44 * r * r) / ((1 - r * r) * (1 - r * r) + 1.44 * r * r)) * low /
                       (1 + low);
      frequency_.push_back(f);
      weight_.push_back(c);
      phase_.push_back(2 * std::numbers::pi * (x / 4294967296.0));
      sum += c * c;
    }
    for (double& c : weight_) c /= std::sqrt(sum / 2);
  }

  double at(double t) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < weight_.size(); ++i) {
      sum += weight_[i] * std::cos(2 * std::numbers::pi * frequency_[i] * t + phase_[i]);
    }
    return amplitude_ * std::pow(t / 6 * std::exp(1 - t / 6), 3) * sum;
  }

  std::vector<double> samples(double dt, double duration = 40.0) const {
    std::vector<double> out;
    const auto last = static_cast<std::size_t>(std::llround(duration / dt));
    for (std::size_t k = 0; k <= last; ++k) out.push_back(at(static_cast<double>(k) * dt));
    return out;
  }

 private:
  double amplitude_;
  std::vector<double> frequency_, weight_, phase_;
};

inline std::vector<double> record_a(double dt = 0.01) {
  return Syn(2008, 1.0).samples(dt);
}

/// The text of the InputError that `action` throws; empty when it throws none.
template <typename Action>
std::string input_error(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// value within a relative tolerance of the reference.
#define EXPECT_CLOSE(value, reference, relative) \
  EXPECT_NEAR(value, reference, std::abs(reference) * (relative))

}  // namespace dougong::seismic::testing
