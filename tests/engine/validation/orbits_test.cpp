// Validation cases E07, E08 and E09: two bodies, the figure eight, the Pythagorean three bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/oracles/two_bodies.h"
#include "tests/scenes/points.h"

namespace dougong::engine {
namespace {

using scenes::point;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;

DriveOptions adaptive(const std::string& integrator, double tolerance, double end, double output) {
  DriveOptions options = run_for(end, output, integrator);
  options.tolerance = tolerance;
  return options;
}

// Lengths, masses and G of a scene of gravitating points; times follow.
struct Units {
  double length, mass, g;
  double time() const { return std::sqrt(length * length * length / (g * mass)); }
  double speed() const { return length / time(); }
};

struct TwoBodies {
  double m1, m2, a, e, g;
  double mu() const { return g * (m1 + m2); }
  double period() const { return 2.0 * std::numbers::pi * std::sqrt(a * a * a / mu()); }
  Scene scene() const {
    const oracles::PlaneMotion start = oracles::ellipse(mu(), a, e, 0.0);
    return scenes::two_bodies(g, m1, m2, {start.x, start.y}, {start.vx, start.vy});
  }
  double error(const Running& r, double t) const {
    const oracles::PlaneMotion exact = oracles::ellipse(mu(), a, e, std::fmod(t, period()));
    return norm(r.position(1) - r.position(0) - Vec2{exact.x, exact.y});
  }
};

const TwoBodies reference{1.0, 1e-3, 1.0, 0.6, 1.0};

TEST(TwoBodiesOracle, IsTheReferenceTable) {
  EXPECT_NEAR(reference.period(), 6.28004606876, 1e-11);
  const auto at = [](double part) {
    return oracles::ellipse(reference.mu(), 1.0, 0.6, part * reference.period());
  };
  EXPECT_NEAR(at(0.0).x, 0.4, 1e-15);
  EXPECT_NEAR(at(0.0).vy, 2.00099975, 1e-8);
  EXPECT_NEAR(at(0.25).x, -1.097342302, 1e-9);
  EXPECT_NEAR(at(0.25).y, 0.694043519, 1e-9);
  EXPECT_NEAR(at(0.5).x, -1.6, 1e-13);
}

void check_two_bodies(const TwoBodies& c, const DriveOptions& settings, double tolerance) {
  Running r(c.scene());
  const Energies start = r.energies();
  const double spin = scenes::angular_momentum(r, {});
  DriveOptions options = settings;
  options.end_time = 10.25 * c.period(), options.output_interval = 0.25 * c.period();
  double worst = 0.0;
  const RunOutcome run = r.run(options, [&](const Sample& sample) {
    worst = std::max(worst, c.error(r, sample.state.time));
    return Wish::go_on;
  });
  ASSERT_EQ(run.outcome, Outcome::completed) << run.detail;
  expect_absolute("E07", options.integrator + " position to 10.25 T in " + std::to_string(run.evaluations),
                  0.0, worst / c.a, tolerance);
  expect_absolute("E07", options.integrator + " energy", start.balance(), r.energies().balance(),
                  tolerance * std::abs(start.balance()));
  expect_absolute("E07", options.integrator + " angular momentum", spin, scenes::angular_momentum(r, {}),
                  tolerance * std::abs(spin));
}

DriveOptions fixed_step(const TwoBodies& c, const std::string& integrator, int steps) {
  DriveOptions options = run_for(1.0, 1.0, integrator);
  options.step = c.period() / steps;
  return options;
}

TEST(TwoBodies, MoveOnKeplersEllipse) {
  check_two_bodies(reference, fixed_step(reference, "rk4", 2000), 1e-6);
  check_two_bodies(reference, adaptive("dormand-prince", 1e-13, 1, 1), 1e-9);
  check_two_bodies(reference, adaptive("rk8", 1e-13, 1, 1), 1e-10);
}
TEST(TwoBodies, DoSoWithOtherMassesAndShapeToo) {
  const TwoBodies other{2.5, 1.5, 3.0, 0.3, 0.7};
  check_two_bodies(other, fixed_step(other, "rk4", 2000), 1e-6);
  check_two_bodies(other, adaptive("dormand-prince", 1e-13, 1, 1), 1e-9);
  check_two_bodies(other, adaptive("rk8", 1e-13, 1, 1), 1e-10);
}

// Error after ten periods against evaluations: a method's price. Printed for docs/theory/integrators.md.
TEST(TwoBodies, CostWhatEachIntegratorAsks) {
  const auto error_after_ten = [](DriveOptions options) {
    Running r(reference.scene());
    options.end_time = 10.0 * reference.period(), options.output_interval = reference.period();
    const RunOutcome run = r.run(options);
    const double error = reference.error(r, 0.0);
    std::printf("orbit %s evaluations %zu error %.1e\n", options.integrator.c_str(), run.evaluations, error);
    return error;
  };
  double before = 1e9;
  for (const char* name : {"symplectic-euler", "velocity-verlet", "leapfrog", "rk3", "rk4"})
    for (const int steps : {500, 2000, 8000}) error_after_ten(fixed_step(reference, name, steps));
  for (const char* name : {"dormand-prince", "rk8"}) {
    before = 1e9;
    for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
      const double error = error_after_ten(adaptive(name, tolerance, 1, 1));
      EXPECT_LT(error, before) << name;
      before = error;
    }
  }
}

Scene figure_eight(const Units& u) {
  const double x = 0.97000436, y = 0.24308751099, vx = 0.466203677174, vy = 0.432365740513;
  Scene s = scenes::space();
  s.fields.gravitational_constant = u.g;
  s.bodies = {point(u.mass, u.length * Vec2{x, -y}, u.speed() * Vec2{vx, vy}),
              point(u.mass, u.length * Vec2{-x, y}, u.speed() * Vec2{vx, vy}),
              point(u.mass, {}, u.speed() * Vec2{-0.932407354348, -0.864731481026})};
  return s;
}

double largest_distance(const Running& r, const std::vector<Vec2>& places) {
  double largest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
    largest = std::max(largest, norm(r.position(i) - places[i]));
  return largest;
}

void check_figure_eight(const Units& u, const std::string& integrator) {
  const double period = 6.325913965933 * u.time();
  Running r(figure_eight(u));
  EXPECT_NEAR(r.energies().balance() / (u.g * u.mass * u.mass / u.length), -1.287141998, 1e-9);
  std::vector<Vec2> start;
  for (std::size_t i = 0; i < 3; ++i) start.push_back(r.position(i));
  // In a third of the period every body comes to the place of another.
  const std::vector<Vec2> exchanged{start[2], start[0], start[1]}, other_way{start[1], start[2], start[0]};
  double third = 1e9, first = 1e9;
  int output = 0;
  r.run(adaptive(integrator, 1e-13, 10.0 * period, period / 3.0), [&](const Sample&) {
    if (output == 1) third = std::min(largest_distance(r, exchanged), largest_distance(r, other_way));
    if (output == 3) first = largest_distance(r, start);
    ++output;
    return Wish::go_on;
  });
  expect_absolute("E08", integrator + " exchanged at T/3", 0.0, third / u.length, 1e-10);
  expect_absolute("E08", integrator + " back after T", 0.0, first / u.length, 1e-10);
  expect_absolute("E08", integrator + " back after 10 T", 0.0, largest_distance(r, start) / u.length, 1e-4);
}

TEST(FigureEight, Returns) {
  check_figure_eight({1.0, 1.0, 1.0}, "dormand-prince");
  check_figure_eight({1.0, 1.0, 1.0}, "rk8");
}
TEST(FigureEight, DoesSoInOtherUnitsToo) {
  check_figure_eight({2.0, 3.0, 0.5}, "rk8");
}

struct Places {
  double t;
  Vec2 at[3];
};
const Places pythagorean[] = {
    {5, {{2.46916967, -1.22781556}, {-2.2782027, -0.205449539}, {0.341060357, 0.901048969}}},
    {10, {{0.77848041, 0.1413923}, {-2.02509248, 0.0972193841}, {1.15298574, -0.162610887}}},
    {20, {{3.00429264, 0.511925235}, {-1.38862654, -0.47047605}, {-0.691674352, 0.0692256992}}},
    {30, {{0.856340499, 2.28709366}, {-0.877983879, -0.865963828}, {0.188582804, -0.679485136}}},
    {40, {{-0.622003692, 1.85831816}, {0.173544557, -2.36841044}, {0.23436657, 0.77973746}}},
    {50, {{-2.70146141, -3.79722268}, {1.50593819, 0.960813425}, {0.416126292, 1.50968287}}},
};

void check_pythagorean(const Units& u, const std::string& integrator, double tolerance, double until_40,
                       double at_50) {
  Scene s = scenes::space();
  s.fields.gravitational_constant = u.g;
  s.bodies = {point(3 * u.mass, u.length * Vec2{1, 3}), point(4 * u.mass, u.length * Vec2{-2, -1}),
              point(5 * u.mass, u.length * Vec2{1, -1})};
  Running r(s);
  const double energy = r.energies().balance();
  EXPECT_NEAR(energy / (u.g * u.mass * u.mass / u.length), -(12.0 / 5 + 15.0 / 4 + 20.0 / 3), 1e-12);
  std::size_t next = 0;
  const RunOutcome run =
      r.run(adaptive(integrator, tolerance, 70 * u.time(), 5 * u.time()), [&](const Sample& sample) {
        if (next == std::size(pythagorean)) return Wish::go_on;
        const Places& p = pythagorean[next];
        if (std::abs(sample.state.time / u.time() - p.t) > 1e-6) return Wish::go_on;
        ++next;
        double worst = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
          worst = std::max(worst, norm((1.0 / u.length) * r.position(i) - p.at[i]));
        expect_absolute("E09", integrator + " places at " + std::to_string(static_cast<int>(p.t)), 0.0, worst,
                        p.t > 40 ? at_50 : until_40);
        return Wish::go_on;
      });
  ASSERT_EQ(run.outcome, Outcome::completed) << run.detail;
  EXPECT_EQ(next, std::size(pythagorean));
  expect_absolute("E09", integrator + " energy in " + std::to_string(run.evaluations), 1.0,
                  r.energies().balance() / energy, 1e-7);
  // The lightest leaves; the others stay bound to each other.
  const Vec2 d = r.position(2) - r.position(1), v = r.velocity(2) - r.velocity(1);
  const double axis = 1.0 / (2.0 / norm(d) - dot(v, v) / (u.g * 9 * u.mass));
  std::printf("E09 %s binary's semi-major axis %.6f\n", integrator.c_str(), axis / u.length);
  EXPECT_GT(axis, 0.0);
  EXPECT_GT(norm(r.position(0) - r.position(1)), 10.0 * u.length);
}

TEST(PythagoreanBodies, AreWhereTheReferenceSaysUntilOneLeaves) {
  check_pythagorean({1.0, 1.0, 1.0}, "rk8", 1e-14, 1e-5, 1e-2);
  check_pythagorean({1.0, 1.0, 1.0}, "dormand-prince", 1e-14, 1e-3, 1e3);
}
TEST(PythagoreanBodies, AreSoInOtherUnitsToo) {
  check_pythagorean({3.0, 2.0, 0.4}, "rk8", 1e-14, 1e-3, 1e3);
}

}  // namespace
}  // namespace dougong::engine
