#include "app/study/ensemble.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/study/metrics.h"
#include "tests/app/study/study_cases.h"

namespace dougong::app::testing {
namespace {

using structures::Building;

EnsembleSheet ensemble_of(const std::vector<std::string>& words, std::size_t jobs) {
  Preparation p = prepared_drum(words);
  const Preparation before = p;
  return run_ensemble(before, execute(p, ""), jobs);
}

std::vector<std::string> hashes_of(const EnsembleSheet& sheet) {
  std::vector<std::string> hashes;
  for (const EnsembleMember& member : sheet.members) hashes.push_back(member.state_hash);
  return hashes;
}

TEST(Ensemble, IsTheSameOnAnyNumberOfThreads) {
  const EnsembleSheet one = ensemble_of({"ensemble.n=4"}, 1), three = ensemble_of({"ensemble.n=4"}, 3);
  EXPECT_EQ(hashes_of(one), hashes_of(three));
  EXPECT_EQ(one.half_step.state_hash, three.half_step.state_hash);
  ASSERT_EQ(one.members.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(one.members[i].done);
    EXPECT_EQ(one.members[i].values.size(), one.metrics.size());
  }
}

TEST(Ensemble, BeginsWithTheRunDescribedAndGoesOnWithOthers) {
  const EnsembleSheet sheet = ensemble_of({"ensemble.n=4"}, 2);
  Preparation p = prepared_drum();
  EXPECT_EQ(sheet.members[0].state_hash, execute(p, "").reproducibility.state_hash);
  const auto hashes = hashes_of(sheet);
  EXPECT_EQ(std::set<std::string>(hashes.begin(), hashes.end()).size(), 4u);
  EXPECT_NE(sheet.half_step.state_hash, sheet.members[0].state_hash);
}

// Of the stability bound it keeps half the part, so that it is half the step whatever the bound becomes; a
// step that was asked for is halved itself.
TEST(Ensemble, HalvesTheStepAsItWasChosen) {
  const auto hash_with = [](const std::string& word) {
    Preparation p = prepared_drum({word});
    return execute(p, "").reproducibility.state_hash;
  };
  const engine::StepPlan plan = prepared_drum({"solve.step_fraction=0.4"}).plan;
  EXPECT_EQ(ensemble_of({"solve.step_fraction=0.4"}, 1).half_step.state_hash,
            hash_with(fmt::format("solve.step_fraction={}", 0.5 * plan.step / plan.bound)));
  EXPECT_EQ(ensemble_of({"solve.step=0.01 ms"}, 1).half_step.state_hash, hash_with("solve.step=0.005 ms"));
}

TEST(Ensemble, KeepsTheRoofDriftOfEveryRunOverTime) {
  const EnsembleSheet sheet = ensemble_of({"ensemble.n=2"}, 1);
  for (const EnsembleMember* member : {&sheet.members[0], &sheet.members[1], &sheet.half_step}) {
    ASSERT_EQ(member->roof_times.size(), 51u) << "50 a second";
    EXPECT_EQ(member->roof_times, sheet.members[0].roof_times);
    EXPECT_EQ(member->roof_drift.size(), 51u);
  }
  EXPECT_NE(sheet.members[0].roof_drift, sheet.members[1].roof_drift);
}

TEST(Ensemble, OfNoChangesIsOneRunRepeated) {
  const EnsembleSheet sheet =
      ensemble_of({"ensemble.n=3", "ensemble.position_change=0 m", "ensemble.friction_change=0",
                   "ensemble.damping_change=0", "ensemble.strength_change=0", "ensemble.amplitude_change=0",
                   "ensemble.half_step=false"},
                  1);
  EXPECT_EQ(sheet.members[1].state_hash, sheet.members[0].state_hash);
  EXPECT_EQ(sheet.members[2].state_hash, sheet.members[0].state_hash);
  EXPECT_FALSE(sheet.half_step.done);
}

TEST(Ensemble, OfAnotherSeedIsAnother) {
  const EnsembleSheet one = ensemble_of({"ensemble.n=2"}, 1),
                      other = ensemble_of({"ensemble.n=2", "ensemble.seed=2"}, 1);
  EXPECT_EQ(one.members[0].state_hash, other.members[0].state_hash);
  EXPECT_NE(one.members[1].state_hash, other.members[1].state_hash);
}

TEST(Ensemble, StopsWhenItIsAskedTo) {
  Preparation p = prepared_drum({"ensemble.n=5"});
  const Preparation before = p;
  const EnsembleSheet sheet = run_ensemble(
      before, execute(p, ""), 1, [](const EnsembleProgress& progress) { return progress.done < 2; });
  EXPECT_EQ(std::ranges::count_if(sheet.members, &EnsembleMember::done), 3);
  EXPECT_FALSE(sheet.half_step.done);
}

// Two blocks tied by a bond, one beside them, one bonded to the ground.
Building four_blocks() {
  Building building;
  building.scene.terrains.emplace_back();
  for (int i = 0; i < 4; ++i) {
    engine::Body body;
    body.shape = engine::make_rectangle(1.0, 1.0);
    body.position = {2.0 * i, 0.5};
    building.scene.bodies.push_back(body);
  }
  engine::Bond between, base;
  between.a = {false, 0}, between.b = {false, 1};
  base.a = {true, 0}, base.b = {false, 3};
  between.tensile_strength = between.cohesion = 1e5;
  building.scene.bonds = {between, base};
  return building;
}

TEST(Perturbation, MovesTiedBlocksTogetherAndHeldOnesNotAtAll) {
  const Building before = four_blocks();
  Building after = before;
  perturb(after, {.position = 1e-3}, 1);
  const auto moved = [&](std::size_t i) {
    return after.scene.bodies[i].position.x - before.scene.bodies[i].position.x;
  };
  EXPECT_NE(moved(0), 0.0);
  EXPECT_NEAR(moved(0), moved(1), 1e-15);
  EXPECT_NEAR(after.scene.bonds[0].start.x - before.scene.bonds[0].start.x, moved(0), 1e-15);
  EXPECT_NE(moved(2), moved(0));
  EXPECT_EQ(moved(3), 0.0);
  EXPECT_EQ(after.scene.bodies[0].position.y, before.scene.bodies[0].position.y);
}

TEST(Perturbation, StaysWithinItsAmounts) {
  const Building before = four_blocks();
  const Perturbation by{.position = 2e-3, .friction = 0.1, .strength = 0.2, .damping = 0.3};
  double farthest = 0.0, frictions = 0.0;
  for (std::size_t member = 1; member <= 200; ++member) {
    Building b = before;
    perturb(b, by, member);
    const double way = std::abs(b.scene.bodies[2].position.x - before.scene.bodies[2].position.x);
    const double friction =
        b.scene.materials[0].friction_coefficient / before.scene.materials[0].friction_coefficient - 1.0;
    const double strength = b.scene.bonds[0].tensile_strength / 1e5 - 1.0;
    EXPECT_LE(way, by.position);
    EXPECT_LE(std::abs(friction), by.friction);
    EXPECT_LE(std::abs(strength), by.strength + 1e-12);
    EXPECT_DOUBLE_EQ(b.scene.bonds[0].cohesion, b.scene.bonds[0].tensile_strength);
    EXPECT_LE(std::abs(b.scene.materials[0].damping_ratio - 1.0), by.damping);
    farthest = std::max(farthest, way), frictions += friction;
  }
  EXPECT_GT(farthest, 0.97 * by.position) << "the whole range is used";
  EXPECT_NEAR(frictions / 200.0, 0.0, 0.015) << "without a side that is preferred";
}

TEST(Perturbation, ScalesTheMotionAndKeepsItsRest) {
  const Preparation p = prepared_drum();
  const auto other = perturbed(p.motion.ground, {.amplitude = 0.1}, 3);
  const double factor = other->at(30.0).acceleration.x / p.motion.ground->at(30.0).acceleration.x;
  EXPECT_NE(factor, 1.0);
  EXPECT_NEAR(factor, 1.0, 0.1);
  for (const double t : {10.0, 33.3, 80.0})
    EXPECT_NEAR(other->at(t).displacement.x, factor * p.motion.ground->at(t).displacement.x, 1e-9) << t;
  EXPECT_EQ(other->duration(), p.motion.ground->duration());
  EXPECT_NEAR(other->at(other->duration() + 5.0).velocity.x, 0.0, 1e-12);
  EXPECT_EQ(perturbed(p.motion.ground, {}, 0), p.motion.ground);
}

TEST(Metrics, AreTheResponsesPeaks) {
  Preparation p = prepared({"layout=four-storey", "duration=12 s", "pga=0.2 g"});
  const auto r = execute(p, "").response;
  const auto metrics = metrics_of(r);
  EXPECT_EQ(metrics.size(), 7u + 3u * r.storeys.size());
  const auto value = [&](const std::string& name) {
    return std::ranges::find(metrics, name, &Metric::name)->value;
  };
  EXPECT_EQ(value("peak drift"), std::abs(structures::storey_of_peak_drift(r)->peak_drift.largest().value));
  EXPECT_EQ(value("S2 peak drift"), std::abs(r.storeys[1].peak_drift.largest().value));
  EXPECT_TRUE(std::isnan(value("first loss of support")));
}

}  // namespace
}  // namespace dougong::app::testing
