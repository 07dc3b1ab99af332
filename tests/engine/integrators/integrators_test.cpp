// One suite for all integrators: what each says about itself is measured.
#include <gmock/gmock.h>

#include <cmath>

#include "engine/integrators/table.h"
#include "tests/engine/allocations.h"
#include "tests/engine/reference.h"
#include "tests/oracles/oscillator.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using ::testing::HasSubstr;

struct Oscillator {
  double w2, c;
  std::size_t evaluations = 0;
  std::size_t degrees_of_freedom() const { return 1; }
  double last_position = 0.0, last_force = 0.0, last_work = 0.0;
  Powers accelerate(double, std::span<const double> q, std::span<const double> v, std::span<double> a,
                    bool begins_step) {
    if (begins_step) {
      last_work = evaluations > 0 ? 0.5 * (last_force + c * v[0]) * (q[0] - last_position) : 0.0;
      last_position = q[0], last_force = c * v[0];
    }
    ++evaluations;
    a[0] = -w2 * q[0] - c * v[0];
    return {{0.0, c * v[0] * v[0], 0.0}};
  }
  Powers work() const { return {{0.0, last_work, 0.0}}; }
};

template <class I>
oracles::Motion run(double w2, double c, double h, int steps, double* work = nullptr) {
  I integrator;
  Oscillator system{w2, c};
  std::vector<double> q{1.0}, v{0.0};
  for (int i = 0; i < steps; ++i) {
    const Powers done = integrator.step(system, i * h, h, q, v);
    if (work) *work += done.values[1];
  }
  return {q[0], v[0]};
}

// Error in x and v/w at T, by steps of T/n.
template <class I>
double error_after(double w, double c, double end, int n) {
  const oracles::Motion got = run<I>(w * w, c, end / n, n), exact = oracles::damped_oscillator(w, c, end);
  return std::hypot(got.x - exact.x, (got.v - exact.v) / w);
}

template <class I>
double measured_order(double w, double c) {
  // Errors of explicit Euler grow, and are proportional to the step only when it is small.
  const int n = I::traits.stability_limit == 0.0 ? 20000 : 400;
  return std::log2(error_after<I>(w, c, 5.0, n) / error_after<I>(w, c, 5.0, 2 * n));
}

template <class I>
double largest_amplitude(double w2, double c, double h, int steps) {
  I integrator;
  Oscillator system{w2, c};
  std::vector<double> q{1.0}, v{0.0};
  double largest = 0.0;
  for (int i = 0; i < steps && largest < 1e100; ++i) {
    integrator.step(system, i * h, h, q, v);
    largest = std::max({largest, std::abs(q[0]), std::abs(v[0]) / std::sqrt(w2)});
  }
  return largest;
}

template <class I>
class EveryIntegrator : public ::testing::Test {};
using Integrators =
    ::testing::Types<VelocityVerlet, SymplecticEuler, Leapfrog, ExplicitEuler, Rk3, Rk4, MoreauJean>;
TYPED_TEST_SUITE(EveryIntegrator, Integrators);

TYPED_TEST(EveryIntegrator, HasTheOrderItClaims) {
  EXPECT_NEAR(measured_order<TypeParam>(2.0, 0.0), TypeParam::traits.order, 0.1);
  EXPECT_NEAR(measured_order<TypeParam>(3.0, 0.0), TypeParam::traits.order, 0.1);
}

TYPED_TEST(EveryIntegrator, HasTheOrderItClaimsWithDamping) {
  EXPECT_NEAR(measured_order<TypeParam>(2.0, 0.8), TypeParam::traits.order_with_damping, 0.1);
  EXPECT_NEAR(measured_order<TypeParam>(3.0, 0.3), TypeParam::traits.order_with_damping, 0.1);
}

TYPED_TEST(EveryIntegrator, CountsItsEvaluations) {
  TypeParam integrator;
  Oscillator system{4.0, 0.1};
  std::vector<double> q{1.0}, v{0.0};
  integrator.step(system, 0.0, 0.01, q, v);
  const std::size_t first = system.evaluations;
  for (int i = 1; i < 11; ++i) integrator.step(system, 0.01 * i, 0.01, q, v);
  EXPECT_EQ(system.evaluations - first, 10u * static_cast<std::size_t>(TypeParam::traits.evaluations));
}

TYPED_TEST(EveryIntegrator, IsStableJustBelowItsUndampedLimitAndGrowsJustAbove) {
  if (TypeParam::traits.stability_limit == 0.0) {
    EXPECT_EQ(TypeParam::stable_step(4.0, 0.0), 0.0);
    EXPECT_GT(largest_amplitude<TypeParam>(4.0, 0.0, 0.05, 10000), 1e6);
    return;
  }
  for (const double w2 : {4.0, 1e8}) {
    const double limit = TypeParam::stable_step(w2, 0.0);
    EXPECT_NEAR(limit * std::sqrt(w2), TypeParam::traits.stability_limit, 1e-9);
    EXPECT_LT(largest_amplitude<TypeParam>(w2, 0.0, 0.99 * limit, 10000), 20.0);
    EXPECT_GT(largest_amplitude<TypeParam>(w2, 0.0, 1.01 * limit, 10000), 1e6);
  }
}

TYPED_TEST(EveryIntegrator, IsStableBelowItsDampedLimit) {
  for (const double ratio : {0.1, 0.5, 1.0, 2.0, 10.0}) {
    const double w = 1000.0, c = 2.0 * ratio * w, limit = TypeParam::stable_step(w * w, c);
    // Critically damped by explicit Euler, both factors are near -1 and n (-1)^n grows for a while.
    EXPECT_LT(largest_amplitude<TypeParam>(w * w, c, 0.99 * limit, 20000), 50.0) << ratio;
  }
}

// A structure has modes with every smaller frequency and every smaller damping beside the two bounds.
TYPED_TEST(EveryIntegrator, IsStableForEverySlowerAndLessDampedMode) {
  for (const double ratio : {0.1, 0.5, 1.0, 2.0}) {
    const double w2 = 1e6, c = 2.0 * ratio * 1e3, h = 0.99 * TypeParam::stable_step(w2, c);
    for (double w2_part = 1.0; w2_part > 1e-3; w2_part *= 0.6)
      for (double c_part = 1.0; c_part > 1e-3; c_part *= 0.6) {
        // Explicit Euler promises this only for modes damped in proportion to their stiffness.
        if (TypeParam::traits.stability_limit > 0.0 || c_part >= w2_part) {
          EXPECT_LT(largest_amplitude<TypeParam>(w2 * w2_part, c * c_part, h, 1500), 50.0)
              << ratio << " " << w2_part << " " << c_part;
        }
      }
  }
}

TYPED_TEST(EveryIntegrator, CumulatesWorkWithTheOrderOfItsMotion) {
  double coarse = 0.0, fine = 0.0;
  run<TypeParam>(4.0, 0.6, 5.0 / 400, 400, &coarse);
  run<TypeParam>(4.0, 0.6, 5.0 / 800, 800, &fine);
  const oracles::Motion end = oracles::damped_oscillator(2.0, 0.6, 5.0);
  const double lost = 0.5 * 4.0 - 0.5 * end.v * end.v - 0.5 * 4.0 * end.x * end.x;
  const double order = std::log2(std::abs(coarse - lost) / std::abs(fine - lost));
  EXPECT_GT(order, TypeParam::traits.order_with_damping - 0.1);
}

TYPED_TEST(EveryIntegrator, FallsFreely) {
  const auto fall = [](double h, int steps) {
    struct {
      std::size_t degrees_of_freedom() const { return 1; }
      Powers accelerate(double, std::span<const double>, std::span<const double>, std::span<double> a, bool) {
        a[0] = -9.81;
        return {};
      }
      Powers work() const { return {}; }
    } system;
    TypeParam integrator;
    std::vector<double> q{20.0}, v{4.0};
    for (int i = 0; i < steps; ++i) integrator.step(system, i * h, h, q, v);
    return q[0];
  };
  // E01: a kick before the drift falls g t h/2 too far, one after it as much too short.
  const double early = std::is_same_v<TypeParam, ExplicitEuler> ? 1.0 : -1.0;
  const double expected = TypeParam::traits.order == 1 ? 8.38 + early * 9.81 * 2.0 * 0.01 / 2.0 : 8.38;
  EXPECT_NEAR(fall(0.01, 200), expected, 1e-12);
}

// A pendulum over 3000 swings: the energy of a symplectic method sways and does not drift.
TYPED_TEST(EveryIntegrator, KeepsTheEnergyOfAPendulumIfSymplectic) {
  if (!TypeParam::traits.symplectic) return;
  struct {
    std::size_t degrees_of_freedom() const { return 1; }
    Powers accelerate(double, std::span<const double> q, std::span<const double>, std::span<double> a, bool) {
      a[0] = -std::sin(q[0]);
      return {};
    }
    Powers work() const { return {}; }
  } system;
  TypeParam integrator;
  std::vector<double> q{1.5}, v{0.0};
  const double h = 0.1, start = -std::cos(1.5);
  double early = 0.0, late = 0.0;
  for (int i = 0; i < 200000; ++i) {
    integrator.step(system, i * h, h, q, v);
    const double error = std::abs(0.5 * v[0] * v[0] - std::cos(q[0]) - start);
    (i < 20000 ? early : late) = std::max(i < 20000 ? early : late, error);
  }
  EXPECT_LT(late, 1.01 * early);
}

TYPED_TEST(EveryIntegrator, NeedsNothingBeyondTheStateToGoOn) {
  Oscillator system{4.0, 0.3};
  TypeParam first;
  std::vector<double> q{1.0}, v{0.0};
  for (int i = 0; i < 50; ++i) first.step(system, i * 0.01, 0.01, q, v);
  auto q2 = q, v2 = v;
  first.restart();
  TypeParam second;
  for (int i = 50; i < 100; ++i) {
    first.step(system, i * 0.01, 0.01, q, v);
    second.step(system, i * 0.01, 0.01, q2, v2);
  }
  EXPECT_EQ(q, q2);
  EXPECT_EQ(v, v2);
}

TYPED_TEST(EveryIntegrator, AllocatesNothingAfterItsFirstStep) {
  Oscillator system{4.0, 0.3};
  TypeParam integrator;
  std::vector<double> q{1.0}, v{0.0};
  integrator.step(system, 0.0, 0.01, q, v);
  const std::size_t before = testing::allocations();
  for (int i = 1; i < 100; ++i) integrator.step(system, i * 0.01, 0.01, q, v);
  EXPECT_EQ(testing::allocations(), before);
}

// The limits with damping of the single-evaluation methods are exact, not only sufficient.
TEST(DampedLimit, IsExactForTheMethodsOfOneEvaluation) {
  for (const double ratio : {0.1, 0.5, 1.0, 2.0, 10.0}) {
    const double w2 = 1e6, c = 2.0 * ratio * 1e3;
    EXPECT_GT(largest_amplitude<VelocityVerlet>(w2, c, 1.01 * VelocityVerlet::stable_step(w2, c), 20000), 1e6)
        << ratio;
    EXPECT_GT(largest_amplitude<Leapfrog>(w2, c, 1.01 * Leapfrog::stable_step(w2, c), 20000), 1e6) << ratio;
    if (ratio < 0.7) {
      EXPECT_GT(largest_amplitude<ExplicitEuler>(w2, c, 1.01 * ExplicitEuler::stable_step(w2, c), 80000), 1e6)
          << ratio;
    }
    EXPECT_GT(largest_amplitude<SymplecticEuler>(w2, c, 1.01 * SymplecticEuler::stable_step(w2, c), 20000),
              1e6)
        << ratio;
  }
}

struct Row {
  int steps;
  double rk4, euler, verlet, rk4_error, euler_error, verlet_error;
};
const Row table[] = {
    {50, -0.839124470274, -0.773765986846, -0.829846297458, 0.000133278993869, 0.0674273624726,
     0.014490078457},
    {100, -0.839075464413, -0.809384821133, -0.83679492711, 8.33250381035e-06, 0.0299796841523,
     0.00361688341282},
    {200, -0.839071793964, -0.824877589256, -0.8385042256, 5.2082040889e-07, 0.0142323076004,
     0.000903877472093},
    {400, -0.839071546212, -0.832126291749, -0.838929818496, 3.2551881613e-08, 0.00695014083144,
     0.000225948043602},
};

TEST(DiscreteOscillator, IsTheReferenceTable) {
  for (const Row& r : table) {
    const double h = 5.0 / r.steps;
    const std::string n = " N=" + std::to_string(r.steps);
    testing::expect_absolute("E12", "rk4 x" + n, r.rk4, run<Rk4>(4.0, 0.0, h, r.steps).x, 1e-8);
    testing::expect_absolute("E12", "symplectic-euler x" + n, r.euler,
                             run<SymplecticEuler>(4.0, 0.0, h, r.steps).x, 1e-8);
    testing::expect_absolute("E12", "velocity-verlet x" + n, r.verlet,
                             run<VelocityVerlet>(4.0, 0.0, h, r.steps).x, 1e-8);
    EXPECT_NEAR(error_after<Rk4>(2.0, 0.0, 5.0, r.steps), r.rk4_error, 1e-8);
    EXPECT_NEAR(error_after<SymplecticEuler>(2.0, 0.0, 5.0, r.steps), r.euler_error, 1e-8);
    EXPECT_NEAR(error_after<VelocityVerlet>(2.0, 0.0, 5.0, r.steps), r.verlet_error, 1e-8);
  }
}

TEST(DiscreteOscillator, IsEachMethodsOwnMap) {
  for (const double w : {1.3, 5.0})
    for (const int n : {40, 333}) {
      const double h = 3.0 / n;
      EXPECT_NEAR(run<Rk4>(w * w, 0, h, n).x, oracles::after_steps(oracles::rk4_map, w, h, n).x, 1e-12);
      EXPECT_NEAR(run<Rk3>(w * w, 0, h, n).x, oracles::after_steps(oracles::rk3_map, w, h, n).x, 1e-12);
      EXPECT_NEAR(run<Leapfrog>(w * w, 0, h, n).x, oracles::after_steps(oracles::leapfrog_map, w, h, n).x,
                  1e-12);
      EXPECT_NEAR(run<ExplicitEuler>(w * w, 0, h, n).x,
                  oracles::after_steps(oracles::explicit_euler_map, w, h, n).x, 1e-12);
      EXPECT_NEAR(run<SymplecticEuler>(w * w, 0, h, n).x,
                  oracles::after_steps(oracles::symplectic_euler_map, w, h, n).x, 1e-12);
      EXPECT_NEAR(run<VelocityVerlet>(w * w, 0, h, n).x,
                  oracles::after_steps(oracles::velocity_verlet_map, w, h, n).x, 1e-12);
    }
}

TEST(IntegratorTable, NamesTheKnownOnesWhenAskedForAnother) {
  for (const char* name : {"velocity-verlet", "symplectic-euler", "leapfrog", "explicit-euler", "rk3", "rk4",
                           "dormand-prince", "rk8", "moreau-jean"})
    EXPECT_NO_THROW(make_integrator(name));
  try {
    make_integrator("leapfrogs");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    for (const char* part : {"leapfrogs", "velocity-verlet", "symplectic-euler", "rk4", "dormand-prince"})
      EXPECT_THAT(e.what(), HasSubstr(part));
  }
}

}  // namespace
}  // namespace dougong::engine
