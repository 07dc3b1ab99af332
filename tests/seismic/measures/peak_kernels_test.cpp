#include "seismic/measures/peak_kernels.h"

#include "seismic/measures/response_spectrum.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

std::vector<PeakOscillator> oscillators(std::size_t count) {
  std::vector<PeakOscillator> out;
  for (const double period : log_spaced_periods(0.01, 10.0, count))
    out.push_back({scaled_oscillator_step({period, 0.05}, 0.01), 0.1});
  return out;
}

// Counts that fill no vector, one, and some with a rest.
TEST(PeakKernels, GiveTheSameBitsOnEveryInstructionSet) {
  const auto a = testing::record_a();
  for (const std::size_t count : {std::size_t{2}, std::size_t{8}, std::size_t{77}}) {
    const auto asked = oscillators(count);
    std::vector<OscillatorPeaks> plain(count), other(count);
    supported_peak_kernels().front().all({a.data(), a.size(), asked.data(), count, plain.data()});
    for (const PeakKernel& kernel : supported_peak_kernels()) {
      kernel.all({a.data(), a.size(), asked.data(), count, other.data()});
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(other[i].displacement, plain[i].displacement) << kernel.name << " " << i;
        EXPECT_EQ(other[i].velocity, plain[i].velocity) << kernel.name << " " << i;
        EXPECT_EQ(other[i].acceleration, plain[i].acceleration) << kernel.name << " " << i;
      }
      kernel.displacement({a.data(), a.size(), asked.data(), count, other.data()});
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(other[i].displacement, plain[i].displacement);
    }
  }
}

TEST(PeakKernels, AgreeWithTheHistoryOfOneOscillator) {
  const auto a = testing::record_a();
  const PeakOscillator one{scaled_oscillator_step({0.7, 0.02}, 0.01), 0.04};
  OscillatorPeaks peaks;
  best_peak_kernel().all({a.data(), a.size(), &one, 1, &peaks});
  double most = 0.0;
  for (const double value : oscillator_response(a, 0.01, {0.7, 0.02}).absolute_acceleration)
    most = std::max(most, std::abs(value));
  EXPECT_CLOSE(peaks.acceleration, most, 1e-13);
}

TEST(PeakKernels, OfOneSampleAreZero) {
  const double sample = 3.0;
  const PeakOscillator one{scaled_oscillator_step({0.7, 0.02}, 0.01), 0.04};
  OscillatorPeaks peaks{1.0, 1.0, 1.0};
  best_peak_kernel().all({&sample, 1, &one, 1, &peaks});
  EXPECT_EQ(peaks.displacement, 0.0);
}

}  // namespace
}  // namespace dougong::seismic
