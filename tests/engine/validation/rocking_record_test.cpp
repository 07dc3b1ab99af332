// Validation cases R03 and R04: rocking under records, as an ensemble and under one that leaves few impacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/reference.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

using oracles::RockingBlock;
using oracles::RockingHistory;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double record_step = 0.01, rest = 5.0;

RockingHistory exact(const RockingBlock& c, const std::vector<double>& samples) {
  const double duration = record_step * static_cast<double>(samples.size() - 1);
  return oracles::DrivenRocking(
             c, [&](double t) { return oracles::interpolated(samples, record_step, t); }, record_step / 5.0)
      .run(duration + rest);
}

RockingHistory measured(const RockingBlock& c, const std::vector<double>& samples, double young_modulus,
                        double output_interval) {
  const double duration = record_step * static_cast<double>(samples.size() - 1);
  auto run = scenes::rocking_run(c, young_modulus, 1.0, scenes::record_motion(samples, record_step), duration,
                                 duration + rest);
  run.output_interval = output_interval;
  return scenes::measured_rocking(run);
}

struct Ensemble {
  int overturned = 0;
  double median_peak = 0.0, median_angle = 0.0;  // over g tan(alpha); over alpha, 2 when overturned
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return 0.5 * (values[half - (values.size() % 2 == 0 ? 1 : 0)] + values[half]);
}

template <class Model>
Ensemble ensemble(const RockingBlock& c, double amplitude, std::uint32_t first, Model model) {
  Ensemble sum;
  std::vector<double> peaks, angles;
  for (std::uint32_t seed = first; seed < first + 40; ++seed) {
    const auto samples = oracles::SyntheticMotion(seed, amplitude).samples(record_step, 30.0);
    double peak = 0.0;
    for (const double a : samples) peak = std::max(peak, std::abs(a));
    const RockingHistory h = model(c, samples);
    sum.overturned += h.overturned ? 1 : 0;
    peaks.push_back(peak / (c.g * c.b / c.h));
    angles.push_back(h.overturned ? 2.0 : h.greatest_angle / c.alpha());
  }
  sum.median_peak = median(peaks), sum.median_angle = median(angles);
  return sum;
}

TEST(EnsembleOracle, IsTheReferenceTable) {
  const RockingBlock c{0.25, 1.5, 9.81};
  const auto check = [&](double amplitude, double peak, int overturned, double angle) {
    const Ensemble e = ensemble(c, amplitude, 1, exact);
    EXPECT_NEAR(e.median_peak, peak, 1e-3);
    EXPECT_EQ(e.overturned, overturned) << amplitude;
    EXPECT_NEAR(e.median_angle / angle, 1.0, 0.05) << amplitude;
  };
  check(1.0, 1.695, 1, 0.3031);
  check(1.6, 2.712, 16, 0.7453);
  check(2.4, 4.068, 28, 2.0);
  check(3.2, 5.423, 36, 2.0);
}

void check_ensemble(const RockingBlock& c, double amplitude, std::uint32_t first, int exact_overturned) {
  const auto engine = [](const RockingBlock& block, const std::vector<double>& samples) {
    return measured(block, samples, 3e9, 0.01);
  };
  const Ensemble e = ensemble(c, amplitude, first, engine);
  const std::string label = "b=" + text(c.b) + " h=" + text(c.h) + " A=" + text(amplitude) + " seeds " +
                            std::to_string(first) + "-" + std::to_string(first + 39);
  expect_absolute("R03", label + " overturned of 40", exact_overturned, e.overturned, 6);
  std::printf("R03 %s median angle/alpha %.4g\n", label.c_str(), e.median_angle);
}

TEST(RockingUnderFortyRecords, OverturnsAsOftenAsTheRigidBlock) {
  const RockingBlock c{0.25, 1.5, 9.81};
  check_ensemble(c, 1.0, 1, 1);
  check_ensemble(c, 1.6, 1, 16);
  check_ensemble(c, 2.4, 1, 28);
  check_ensemble(c, 3.2, 1, 36);
}
TEST(RockingUnderFortyRecords, DoesSoWithAnotherBlockAndOtherRecordsToo) {
  const RockingBlock c{0.4, 1.6, 9.81};
  check_ensemble(c, 2.8, 101, ensemble(c, 2.8, 101, exact).overturned);
}

void check_record(const RockingBlock& c, std::uint32_t seed, double amplitude) {
  const auto samples = oracles::SyntheticMotion(seed, amplitude).samples(record_step, 40.0);
  const RockingHistory e = exact(c, samples), m = measured(c, samples, 30e9, 1e-3);
  const std::string label =
      "b=" + text(c.b) + " h=" + text(c.h) + " SYN(" + std::to_string(seed) + ", " + text(amplitude) + ")";
  expect_relative("R04", label + " first uplift", e.uplift_time, m.uplift_time, 0.005);
  EXPECT_EQ(m.overturned, e.overturned);
  expect_relative("R04", label + " overturned at", e.overturning_time, m.overturning_time, 0.03);
  EXPECT_EQ(m.impacts, e.impacts);
}

TEST(RockingUnderOneRecord, UpliftsAndOverturnsWhenTheRigidBlockDoes) {
  const RockingBlock c{0.25, 1.5, 9.81};
  const RockingHistory e = exact(c, oracles::SyntheticMotion(2008, 4.0).samples(record_step));
  EXPECT_NEAR(e.uplift_time, 1.790256, 1e-6);
  EXPECT_NEAR(e.overturning_time, 6.8125, 1e-3);
  EXPECT_EQ(e.impacts, 6);
  check_record(c, 2008, 4.0);
  check_record({0.3, 1.2, 9.81}, 7, 6.0);
}

}  // namespace
}  // namespace dougong::engine
