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
  const auto line = remove_acceleration_line(a, 0.01);
  EXPECT_CLOSE(line.offset, 0.0491777109, 1e-8);
  EXPECT_CLOSE(line.slope, -0.00196865393, 1e-8);
  const auto history = integrate(a, 0.01);
  EXPECT_CLOSE(peak(history.velocity, 0.01).value, 0.22239445, 3e-8);
  EXPECT_CLOSE(peak(history.displacement, 0.01).value, 0.088207964, 3e-8);
}

TEST(Baseline, ParabolaOfVelocityMeetsP06) {
  auto a = drifting_a();
  const auto line = remove_velocity_parabola(a, 0.01);
  EXPECT_CLOSE(line.offset, 0.0491593502, 1e-8);
  EXPECT_CLOSE(line.slope, -0.00196379191, 1e-8);
  const auto history = integrate(a, 0.01);
  EXPECT_CLOSE(peak(history.velocity, 0.01).value, 0.22237213, 3e-8);
  EXPECT_CLOSE(peak(history.displacement, 0.01).value, 0.088038137, 3e-8);
  EXPECT_CLOSE(history.displacement.back(), -0.037337482, 3e-8);
}

}  // namespace
}  // namespace dougong::seismic
