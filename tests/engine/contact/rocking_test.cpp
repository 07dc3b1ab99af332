#include "engine/contact/rocking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dougong::engine {
namespace {

// A rectangle of 1 kg on corners of a stiffness and damping ratio 2 of the free corner.
RockingImpact rectangle(double b, double h, double stiffness = 1e6) {
  RockingImpact impact{1.0, (b * b + h * h) / 3.0, b, h, {}};
  const double felt = 1.0 / (1.0 + b * b / impact.inertia);
  impact.law = {stiffness, 0.4 * stiffness, 4.0 * std::sqrt(stiffness * felt),
                4.0 * std::sqrt(0.4 * stiffness * felt), 2.0};
  return impact;
}

TEST(HousnersRatio, IsThatOfARectangle) {
  const double b = 0.25, h = 1.0, sine = b / std::hypot(b, h);
  EXPECT_NEAR(housner_ratio(rectangle(b, h)), 1.0 - 1.5 * sine * sine, 1e-15);
}

TEST(VelocityRatio, IsHousnersWithoutACouple) {
  for (const auto& [b, h] : {std::pair{0.25, 1.0}, {0.06, 1.0}, {0.5, 1.0}})
    EXPECT_NEAR(velocity_ratio(rectangle(b, h), {}), housner_ratio(rectangle(b, h)), 2e-3) << b;
}

TEST(VelocityRatio, FallsWithTheCouple) {
  const RockingImpact impact = rectangle(0.2, 1.0);
  double last = velocity_ratio(impact, {});
  for (double couple = 10.0; couple < 1e4; couple *= 2.0) {
    const double ratio = velocity_ratio(impact, {.couple = couple});
    EXPECT_LT(ratio, last) << couple;
    last = ratio;
  }
}

TEST(VelocityRatio, GrowsAsTheImpactMovesInward) {
  const RockingImpact impact = rectangle(0.2, 1.0);
  double last = velocity_ratio(impact, {});
  for (double inset = 0.02; inset <= 0.2; inset += 0.02) {
    const double ratio = velocity_ratio(impact, {.inset = inset});
    EXPECT_GT(ratio, last) << inset;
    EXPECT_LT(ratio, 1.0) << inset;
    last = ratio;
  }
}

TEST(LawForRatio, GivesTheRatioAskedFor) {
  for (const double ratio : {0.97, 0.95, 0.9, 0.7, 0.6, 0.5})
    EXPECT_NEAR(velocity_ratio(rectangle(0.2, 1.0), law_for_ratio(rectangle(0.2, 1.0), ratio)), ratio, 1e-4);
}

TEST(LawForRatio, HasACoupleThatGrowsWithTheRootOfTheStiffness) {
  const double soft = law_for_ratio(rectangle(0.2, 1.0, 1e6), 0.6).couple;
  EXPECT_NEAR(law_for_ratio(rectangle(0.2, 1.0, 1e10), 0.6).couple / soft, 100.0, 0.1);
}

TEST(LawForRatio, HasAnInsetThatDoesNotDependOnTheStiffness) {
  const double soft = law_for_ratio(rectangle(0.2, 1.0, 1e6), 0.96).inset;
  EXPECT_GT(soft, 0.01);
  EXPECT_NEAR(law_for_ratio(rectangle(0.2, 1.0, 1e10), 0.96).inset / soft, 1.0, 1e-3);
}

TEST(LawForRatio, StopsAtTheMiddleOfTheFace) {
  const RockingLaw law = law_for_ratio(rectangle(0.2, 1.0), 1.0);
  EXPECT_NEAR(law.inset, 0.2, 1e-6);
  EXPECT_EQ(law.couple, 0.0);
}

}  // namespace
}  // namespace dougong::engine
