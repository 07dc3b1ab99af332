// Records of 10 g and 0.001 g, with steps from 1 ms to 0.1 s.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/settle.h"
#include "tests/engine/reference.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/audit.h"
#include "tests/scenes/record_motion.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double g = 9.81;

// SYN(2008, 1) has its peak of 2.6347 m/s2 within the first twelve seconds.
std::shared_ptr<const PrescribedMotion> record(double pga, double dt) {
  return scenes::record_motion(oracles::SyntheticMotion(2008, pga / 2.634698442).samples(dt, 12.0), dt);
}

Running shaken(const Scene& scene, std::shared_ptr<const PrescribedMotion> motion) {
  Running r(scene);
  EXPECT_TRUE(settle(r.model, r.state, {.unbalanced_ratio = 1e-9}).settled);
  r.model.motions[0] = std::move(motion);
  return r;
}

TEST(Record, OfTenGIsRunToItsEndWithItsEnergyKept) {
  for (const auto& [name, scene] : {std::pair{"wall of 3 x 4", scenes::wall(3, 4, 0.9, 1e8)},
                                    std::pair{"column of 6", scenes::column(6, 0.1, 0.2, 0.6, 1e8)}}) {
    Running r = shaken(scene, record(10.0 * g, 0.01));
    const Running start = r;
    const auto audit = scenes::audited(r, run_for(12.0));
    EXPECT_TRUE(audit.completed() && audit.finite) << audit.run.detail;
    std::printf("records 10 g, %s: turned by up to %.3g rad, deepest overlap %.3g of the width\n", name,
                greatest_turn(r, start), audit.deepest);
    EXPECT_GT(greatest_turn(r, start), 0.5) << name << ": nothing fell";
    expect_absolute("records", std::string("10 g, ") + name + ": energy error", 0.0, audit.energy_error,
                    0.02);
  }
}

// Greatest way of the top relative to the ground (m).
double drift_of_top(Running r, double dt) {
  const Running start = r;
  const std::size_t top = r.bodies() - 1;
  double greatest = 0.0;
  const RunOutcome run = r.run(run_for(12.0, dt), [&](const Sample& sample) {
    const double ground = r.model.motions[0]->at(sample.state.time).displacement.x;
    greatest = std::max(greatest, std::abs(r.position(top).x - start.position(top).x - ground));
    return Wish::go_on;
  });
  EXPECT_EQ(run.outcome, Outcome::completed) << run.detail;
  return greatest;
}

/// Every block narrower than the one below it.
Scene pyramid(int count, double b, double h, double young_modulus) {
  Scene s = scenes::column(count, b, h, 0.6, young_modulus);
  for (int i = 0; i < count; ++i)
    s.bodies[static_cast<std::size_t>(i)].shape = make_rectangle(2.0 * (b - 0.01 * i), 2.0 * h);
  return s;
}

// So little neither slides nor lifts anything: the response is that of springs, in proportion.
TEST(Record, OfAThousandthOfGMovesAColumnByATenthOfWhatAHundredthDoes) {
  for (const auto& [count, b, h] : {std::tuple{3, 0.3, 0.2}, std::tuple{5, 0.25, 0.1}}) {
    const Scene s = pyramid(count, b, h, 1e8);
    const double small = drift_of_top(shaken(s, record(0.001 * g, 0.01)), 0.01);
    const double large = drift_of_top(shaken(s, record(0.01 * g, 0.01)), 0.01);
    EXPECT_GT(small, 0.0);
    expect_relative("records", "0.001 g, column of " + std::to_string(count) + ": a tenth of that at 0.01 g",
                    0.1 * large, small, 1e-6);
  }
}

// The same motion, sampled more and more coarsely, under a column of a period of about 0.3 s.
void check_record_steps(const Scene& s) {
  const double fine = drift_of_top(shaken(s, record(0.05 * g, 0.001)), 0.001);
  for (const auto& [dt, tolerance] :
       {std::pair{0.005, 1e-3}, {0.01, 2e-3}, {0.02, 0.01}, {0.05, 0.05}, {0.1, 0.2}})
    expect_relative("records", "step of " + text(dt) + " s: drift over that at 0.001 s", 1.0,
                    drift_of_top(shaken(s, record(0.05 * g, dt)), 0.001) / fine, tolerance);
}

TEST(RecordStep, MayBeAnythingFromAMillisecondToATenthOfASecond) {
  check_record_steps(pyramid(4, 0.3, 0.2, 2e6));
}
TEST(RecordStep, MayBeSoForOtherColumnsToo) {
  check_record_steps(pyramid(3, 0.4, 0.3, 2e6));
}

}  // namespace
}  // namespace dougong::engine
