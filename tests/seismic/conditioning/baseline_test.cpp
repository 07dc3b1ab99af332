#include "seismic/conditioning/baseline.h"

#include "seismic/measures/integrate.h"
#include "seismic/measures/peaks.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

// Validation case P06: record A with 0.05 - 0.002 t m/s2 added.
std::vector<double> drifting_a() {
  auto a = testing::record_a();
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += 0.05 - 0.002 * 0.01 * static_cast<double>(k);
  return a;
}

TEST(Baseline, UncorrectedDriftsAsP06Says) {
  EXPECT_CLOSE(integrate(drifting_a(), 0.01).displacement.back(), 18.343029, 1e-7);
}

TEST(Baseline, LineOfAccelerationMeetsP06) {
  auto a = drifting_a();
  const Baseline line = remove_acceleration_polynomial(a, 0.01, 1);
  EXPECT_CLOSE(line.at(0), 0.0491777109, 1e-8);
  EXPECT_CLOSE(line.at(1), -0.00196865393, 1e-8);
  const auto history = integrate(a, 0.01);
  EXPECT_CLOSE(peak(history.velocity, 0.01).value, 0.22239445, 3e-8);
  EXPECT_CLOSE(peak(history.displacement, 0.01).value, 0.088207964, 3e-8);
}

TEST(Baseline, ParabolaOfVelocityMeetsP06) {
  auto a = drifting_a();
  const Baseline line = remove_velocity_polynomial(a, 0.01, 2);
  EXPECT_CLOSE(line.at(0), 0.0491593502, 1e-8);
  EXPECT_CLOSE(line.at(1), -0.00196379191, 1e-8);
  const auto history = integrate(a, 0.01);
  EXPECT_CLOSE(peak(history.velocity, 0.01).value, 0.22237213, 3e-8);
  EXPECT_CLOSE(peak(history.displacement, 0.01).value, 0.088038137, 3e-8);
  EXPECT_CLOSE(history.displacement.back(), -0.037337482, 3e-8);
}

// A polynomial added to a motion is taken off with it: what is left does not know of it.
TEST(Baseline, TakesOffWhateverPolynomialWasAdded) {
  for (const int degree : {0, 1, 2, 3, 5, 6}) {
    auto a = testing::record_a(), with = a;
    for (std::size_t k = 0; k < a.size(); ++k)
      with[k] += 0.2 * std::pow(static_cast<double>(k) / 2000.0 - 0.7, degree);
    remove_acceleration_polynomial(a, 0.01, degree);
    remove_acceleration_polynomial(with, 0.01, degree);
    for (std::size_t k = 0; k < a.size(); k += 100) EXPECT_NEAR(with[k], a[k], 1e-11) << degree;
  }
}

TEST(Baseline, OfVelocityTakesOffThePolynomialsOfLowerDegree) {
  auto a = testing::record_a(), with = a;
  for (std::size_t k = 0; k < a.size(); ++k) with[k] += 0.05 - 0.002 * 0.01 * static_cast<double>(k);
  remove_velocity_polynomial(a, 0.01, 4);
  remove_velocity_polynomial(with, 0.01, 4);
  for (std::size_t k = 0; k < a.size(); k += 100) EXPECT_NEAR(with[k], a[k], 1e-11);
}

TEST(Baseline, LeavesARecordThatIsTooShortAlone) {
  std::vector<double> a = {1.0, 2.0, 3.0};
  EXPECT_TRUE(remove_acceleration_polynomial(a, 0.01, 3).empty());
  EXPECT_EQ(a[2], 3.0);
}

TEST(EndAtRest, LeavesNeitherVelocityNorDisplacement) {
  auto a = drifting_a();
  const RestCorrection c = end_at_rest(a, 0.01);
  EXPECT_CLOSE(c.displacement, 18.343029, 1e-7);
  const auto history = integrate(a, 0.01);
  EXPECT_NEAR(history.velocity.back(), 0.0, 1e-13);
  EXPECT_NEAR(history.displacement.back(), 0.0, 1e-12);
  EXPECT_EQ(a.front(), drifting_a().front());
  EXPECT_EQ(a.back(), drifting_a().back());
  EXPECT_LT(c.greatest_change, 0.2);
}

}  // namespace
}  // namespace dougong::seismic
