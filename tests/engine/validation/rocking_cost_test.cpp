// R01 as a laboratory of integrators: error of the impact times against evaluations of the forces. The
// reference is the same block, with the same contacts, to a far tighter tolerance; so only the integrator
// errs.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/rocking.h"

namespace dougong::engine {
namespace {

struct Cost {
  std::vector<double> impacts;  // s
  std::size_t evaluations = 0;
};

// Zero of the cubic through the ends of an interval, with its slopes there.
double crossing(double t0, double t1, double a0, double a1, double w0, double w1) {
  const double h = t1 - t0;
  double s = a0 / (a0 - a1);
  for (int i = 0; i < 20; ++i) {
    const double u = 1.0 - s;
    const double value =
        a0 * u * u * (1 + 2 * s) + a1 * s * s * (1 + 2 * u) + h * (w0 * s * u * u - w1 * s * s * u);
    const double slope = 6 * s * u * (a1 - a0) + h * (w0 * u * (1 - 3 * s) + w1 * s * (3 * s - 2));
    s -= value / slope;
  }
  return t0 + s * h;
}

Cost rock(const std::string& integrator, double fraction, double tolerance) {
  const oracles::RockingBlock c{0.25, 1.0, 9.81};
  scenes::Running r(scenes::tilted_block(c, 0.5 * c.alpha(), 3e9, 1.0));
  DriveOptions options = scenes::run_for(2.8, 5e-4, integrator);
  options.step_fraction = fraction, options.tolerance = tolerance;
  Cost cost;
  double angle = r.angle(), spin = 0.0, time = 0.0;
  const RunOutcome run = r.run(options, [&](const Sample& sample) {
    if (angle * r.angle() < 0.0)
      cost.impacts.push_back(crossing(time, sample.state.time, angle, r.angle(), spin, r.spin()));
    angle = r.angle(), spin = r.spin(), time = sample.state.time;
    return Wish::go_on;
  });
  EXPECT_EQ(run.outcome, Outcome::completed) << integrator << " " << run.detail;
  cost.evaluations = run.evaluations;
  return cost;
}

double worst_error(const Cost& got, const Cost& exact) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    worst = std::max(worst, std::abs(got.impacts.at(i) - exact.impacts.at(i)));
  return worst;
}

TEST(RockingCost, IsMeasuredForVerletAndForAdaptiveSteps) {
  const Cost exact = rock("dormand-prince", 0.5, 1e-11), other = rock("rk8", 0.5, 1e-10);
  ASSERT_GE(exact.impacts.size(), 4u);
  const double agreement = worst_error(other, exact);
  std::printf("rocking reference: two methods agree to %.1e s\n", agreement);
  EXPECT_LT(agreement, 1e-5);
  for (const double fraction : {0.9, 0.5, 0.25, 0.1, 0.03}) {
    for (const char* integrator : {"velocity-verlet", "rk4"}) {
      const Cost cost = rock(integrator, fraction, 1e-8);
      std::printf("rocking %s fraction %.2g evaluations %zu error %.1e s\n", integrator, fraction,
                  cost.evaluations, worst_error(cost, exact));
    }
  }
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const Cost cost = rock("dormand-prince", 0.5, tolerance);
    const double error = worst_error(cost, exact);
    std::printf("rocking dormand-prince tolerance %.0e evaluations %zu error %.1e s\n", tolerance,
                cost.evaluations, error);
    if (tolerance <= 1e-7) {
      EXPECT_LT(error, 1e-4);
    }
  }
}

}  // namespace
}  // namespace dougong::engine
