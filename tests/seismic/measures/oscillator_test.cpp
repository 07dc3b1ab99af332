#include "seismic/measures/oscillator.h"

#include <array>
#include <utility>

#include "seismic/constants.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

constexpr Oscillator oscillator{0.5, 0.05};

double displacement_at(const OscillatorHistory& history, double t, double dt) {
  return history.displacement.at(static_cast<std::size_t>(std::llround(t / dt)));
}

// Validation case P10: T 0.5 s, 5 %, closed forms.
TEST(Oscillator, MeetsTheClosedFormUnderAHalfSineP10) {
  const double dt = 1e-5;
  std::vector<double> a;
  for (int k = 0; k <= 150000; ++k)
    a.push_back(k <= 40000 ? 3.0 * std::sin(std::numbers::pi * k * dt / 0.4) : 0.0);
  const auto history = oscillator_response(a, dt, oscillator);
  for (const auto& [t, u] : {std::pair{0.1, -0.00340751551},
                             {0.2, -0.0186301631},
                             {0.4, -0.0181022585},
                             {0.7, 0.00186152344},
                             {1.5, 0.00714648368}}) {
    EXPECT_CLOSE(displacement_at(history, t, dt), u, 1e-8) << t;
  }
}

TEST(Oscillator, IsExactUnderARampAtAnyStepP10) {
  for (const double dt : {0.1, 0.01, 0.001}) {
    std::vector<double> a;
    for (int k = 0; k <= std::lround(1.5 / dt); ++k) a.push_back(3.0 * k * dt);
    const auto history = oscillator_response(a, dt, oscillator);
    for (const auto& [t, u] : {std::pair{0.1, -0.000448196105},
                               {0.2, -0.00275664271},
                               {0.4, -0.00859986983},
                               {0.7, -0.0124902275},
                               {1.5, -0.0284181313}}) {
      EXPECT_CLOSE(displacement_at(history, t, dt), u, 2e-9) << t << " s, step " << dt;
    }
  }
}

TEST(Oscillator, KeepsItsDigitsForPeriodsOfManySteps) {
  // Constant acceleration of a soft oscillator: u = -a/w^2 (1 - decaying cosine).
  const Oscillator soft{100.0, 0.05};
  const double dt = 1e-3, w = two_pi / soft.period, wd = w * std::sqrt(1 - 0.0025);
  const auto history = oscillator_response(std::vector<double>(10001, 1.0), dt, soft);
  const double t = 10.0, decay = std::exp(-0.05 * w * t);
  const double exact = -(1 - decay * (std::cos(wd * t) + 0.05 * w / wd * std::sin(wd * t))) / (w * w);
  EXPECT_CLOSE(history.displacement.back(), exact, 1e-10);
}

TEST(Oscillator, StepsOfTwoHalvesAreOneStep) {
  const auto whole = oscillator_step(oscillator, 0.4), half = oscillator_step(oscillator, 0.2);
  EXPECT_NEAR(half.uu * half.uu + half.uv * half.vu, whole.uu, 1e-13);
  EXPECT_NEAR(half.vu * half.uv + half.vv * half.vv, whole.vv, 1e-13);
}

}  // namespace
}  // namespace dougong::seismic
