// Validation cases X01, X02, X05 and X12: what stands still stays, whatever its stiffnesses and masses, and
// however long. Contacts are springs.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/statics.h"
#include "tests/scenes/burst.h"
#include "tests/scenes/leaning.h"
#include "tests/scenes/rest.h"

namespace dougong::engine {
namespace {

using scenes::greatest_drift;
using scenes::greatest_turn;
using scenes::run_for;
using scenes::Running;
using scenes::TwoPlates;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

// What settling leaves unbalanced dies away in two seconds.
Running settled(const Scene& scene) {
  Running r(scene);
  const SettleReport report = settle(r.model, r.state, {.unbalanced_ratio = 3e-8});
  EXPECT_TRUE(report.settled) << report.unbalanced_ratio << " " << report.detail;
  r.run(run_for(2.0));
  return r;
}

/// What the points between two heights carry together (N); side by side, blocks carry nothing.
double normal_force(const Running& r, double from, double to) {
  double force = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) {
    const double y = f.place.y + r.model.origin.y;
    if (y > from && y < to) force += f.normal;
  }
  return force;
}

void check_plates(const std::string& name, const TwoPlates& c, const std::string& what, double duration) {
  Running r = settled(c.scene());
  const Running start = r;
  const double gap = r.position(1).y - r.position(0).y - 2.0 * c.h;
  const double between = c.upper_mass * c.g, below = (c.lower_mass + c.upper_mass) * c.g;
  expect_relative(name, what + " overlap between", between / oracles::in_series(c.lower, c.upper), -gap,
                  1e-6);
  expect_relative(name, what + " reaction between", between, normal_force(r, c.h, 3.0 * c.h), 1e-6);
  expect_relative(name, what + " reaction of the ground", below, normal_force(r, -c.h, c.h), 1e-6);
  double fastest = 0.0;
  const RunOutcome run = r.run(run_for(duration, 0.1), [&](const Sample&) {
    fastest = std::max(fastest, r.energies().kinetic);
    return Wish::go_on;
  });
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  expect_absolute(name, what + " drift in " + text(duration) + " s", 0.0, greatest_drift(r, start), 1e-9);
  expect_absolute(name, what + " kinetic energy over weight x overlap", 0.0, fastest / (below * -gap), 1e-12);
}

TEST(PlatesInSeries, RestWhateverTheirStiffnesses) {
  check_plates("X01", {1e6, 1e12, 100.0, 100.0}, "1e12 on 1e6 N/m", 60.0);
  check_plates("X01", {1e12, 1e6, 100.0, 100.0}, "1e6 on 1e12 N/m", 60.0);
}
TEST(PlatesInSeries, DoSoWithOtherStiffnessesToo) {
  check_plates("X01", {3e5, 2e11, 40.0, 300.0}, "2e11 on 3e5 N/m", 60.0);
  check_plates("X01", {5e10, 2e5, 250.0, 30.0}, "2e5 on 5e10 N/m", 60.0);
}

TEST(HeavyAndLightBlock, RestOnEachOther) {
  for (const double ratio : {1e5, 1e6}) {
    check_plates("X02", {1e10, 1e10, 1.0, ratio}, text(ratio) + " kg on 1 kg", 10.0);
    check_plates("X02", {1e10, 1e10, ratio, 1.0}, "1 kg on " + text(ratio) + " kg", 10.0);
  }
}

// Half of the course above and half of the one below a bed joint.
double row_force(const Running& r, int row, double h) {
  return normal_force(r, (row - 0.5) * h, (row + 0.5) * h);
}

void check_wall(int bricks, int courses, double young_modulus) {
  const double h = 0.2, brick = 2400.0 * 0.4 * h * 9.81;
  const std::string name = "wall " + std::to_string(bricks) + " x " + std::to_string(courses);
  Running r = settled(scenes::wall(bricks, courses, 0.6, young_modulus));
  for (const int row : {0, courses / 2, courses - 1})
    expect_relative("X05", name + " force under row " + std::to_string(row), bricks * (courses - row) * brick,
                    row_force(r, row, h), 1e-4);
  const Running start = r;
  EXPECT_EQ(r.run(run_for(10.0)).outcome, Outcome::completed);
  expect_absolute("X05", name + " drift in 10 s over h", 0.0, greatest_drift(r, start) / h, 1e-6);
}

TEST(DryWall, CarriesTheWeightOfItsRowsAndDoesNotDrift) {
  check_wall(10, 10, 1e8);
}
TEST(DryWall, DoesSoWithOtherProportionsToo) {
  check_wall(4, 15, 1e9);
}

// Laid without its compression it drops into it: what it swings with is only lost.
TEST(DryWall, OnlyLosesEnergyWhenItIsLaid) {
  Running r(scenes::wall(10, 10, 0.6, 1e8));
  const auto mechanical = [](const Energies& e) { return e.kinetic + e.gravity + e.elastic; };
  double least = mechanical(r.energies()), regained = 0.0, fastest = 0.0;
  r.run(run_for(10.0), [&](const Sample&) {
    const Energies e = r.energies();
    regained = std::max(regained, mechanical(e) - least), least = std::min(least, mechanical(e));
    fastest = std::max(fastest, e.kinetic);
    return Wish::go_on;
  });
  expect_absolute("X05", "laid wall: energy regained over the greatest kinetic", 0.0, regained / fastest,
                  1e-3);
  expect_absolute("X05", "laid wall: kinetic energy at the end over the greatest", 0.0,
                  r.energies().kinetic / fastest, 1e-12);
}

void check_column(const oracles::Stack& c) {
  const double threshold = c.toppling_acceleration(1.0);
  for (const double part : {0.5, 1.5}) {
    Running r = settled(scenes::column(c.count, c.b, c.h, 0.7, 1e10));
    const bool toppled = scenes::topples_under(r, part * threshold, true, 6.0, 0.5 * c.toppling_tilt(), 0.25);
    EXPECT_EQ(toppled, part > 1.0) << c.count << " blocks, " << part;
  }
  std::printf("X05 column of %d stands at 0.5, falls at 1.5 of %g g\n", c.count, threshold);
}

TEST(TallColumn, StandsAtHalfOfItsThresholdAndFallsAtOneAndAHalf) {
  EXPECT_NEAR(oracles::Stack({0.2, 0.1, 100}).toppling_acceleration(1.0), 0.02, 1e-15);
  check_column({0.2, 0.1, 100});
}
TEST(TallColumn, DoesSoWithOtherProportionsToo) {
  check_column({0.3, 0.15, 60});
}

double greatest_change(const std::vector<scenes::PointForce>& a, const std::vector<scenes::PointForce>& b) {
  double change = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    change =
        std::max({change, std::abs(a[i].tangential - b[i].tangential), std::abs(a[i].normal - b[i].normal)});
  return change;
}

void rest_for_an_hour(const std::string& name, Running& r) {
  const Running start = r;
  const double weight = r.model.total_mass() * 9.81;
  const auto before = scenes::point_forces(r.model, r.state);
  EXPECT_EQ(r.run(run_for(3600.0, 1.0)).outcome, Outcome::completed);
  expect_absolute("X12", name + " drift (m)", 0.0, greatest_drift(r, start), 1e-9);
  expect_absolute("X12", name + " turn (rad)", 0.0, greatest_turn(r, start), 1e-9);
  expect_absolute("X12", name + " change of a contact force over the weight", 0.0,
                  greatest_change(before, scenes::point_forces(r.model, r.state)) / weight, 1e-9);
}

// Shaken so that the blocks slide on each other, given half a minute, left alone.
void check_hour(const std::string& name, Scene s) {
  Running r = settled(s);
  rest_for_an_hour(name + " at rest, an hour:", r);
  r.model.motions[0] = std::make_shared<scenes::Burst>(8.0, 2.0, 4.0);
  const Running before = r;
  r.run(run_for(34.0));
  EXPECT_GT(greatest_drift(r, before), 1e-4) << "not shaken enough to slide";
  r.model.motions[0] = nullptr;
  rest_for_an_hour(name + " after a shaking, an hour:", r);
}

TEST(StackOfBlocks, IsAfterAnHourWhereItWas) {
  check_hour("three blocks", scenes::column(3, 0.25, 0.25, 0.4, 1e7));
}
TEST(StackOfBlocks, IsSoWithOtherBlocksToo) {
  check_hour("two blocks", scenes::column(2, 0.5, 0.2, 0.3, 3e7));
}

}  // namespace
}  // namespace dougong::engine
