#include "app/study/paired_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "seismic/synthesis/random.h"

namespace dougong::app {
namespace {

// The airway hyper-responsiveness study of Bentur et al. (2009) as evaluated by Fagerland, Lydersen & Laake,
// Statistics in Medicine 33 (2014) 2850-2875: 21 children, before and after a transplantation.
TEST(PairedShares, RepeatAPublishedExample) {
  const PairedShares s = compare_shares({.both = 1, .first = 1, .second = 7, .neither = 12});
  EXPECT_NEAR(s.difference, 6.0 / 21.0, 1e-12);
  EXPECT_NEAR(s.low, 0.026, 5e-4);
  EXPECT_NEAR(s.high, 0.507, 5e-4);
  EXPECT_NEAR(s.p_value, 0.0703, 5e-5);
}

TEST(PairedShares, OfTheOtherOrderAreTheirMirror) {
  const PairedShares one = compare_shares({5, 9, 2, 4}), other = compare_shares({5, 2, 9, 4});
  EXPECT_DOUBLE_EQ(one.difference, -other.difference);
  EXPECT_NEAR(one.low, -other.high, 1e-15);
  EXPECT_DOUBLE_EQ(one.p_value, other.p_value);
}

// Six pairs that all differ the same way: 2/2^6.
TEST(PairedShares, TestOnlyThePairsThatDiffer) {
  EXPECT_NEAR(compare_shares({0, 6, 0, 0}).p_value, 0.03125, 1e-15);
  EXPECT_NEAR(compare_shares({50, 6, 0, 50}).p_value, 0.03125, 1e-15);
  EXPECT_EQ(compare_shares({8, 0, 0, 8}).p_value, 1.0);
}

TEST(PairedShares, OfNoPairsMayBeAnything) {
  const PairedShares s = compare_shares({});
  EXPECT_TRUE(std::isnan(s.difference));
  EXPECT_EQ(s.low, -1.0);
  EXPECT_EQ(s.high, 1.0);
}

/// Two answers, the second with other chances, both by one number as small changes make them alike.
PairedCounts drawn(std::uint64_t trial, std::size_t pairs) {
  PairedCounts counts;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double shared = seismic::uniform_number(5, trial, 3 * i);
    const bool same = seismic::uniform_number(5, trial, 3 * i + 1) < 0.5;
    const double own = same ? shared : seismic::uniform_number(5, trial, 3 * i + 2);
    const bool one = shared < 0.4, two = own < 0.7;
    ++(one && two ? counts.both : one ? counts.first : two ? counts.second : counts.neither);
  }
  return counts;
}

TEST(PairedShares, CoverTheTruthNineteenTimesOfTwenty) {
  constexpr int trials = 600;  // one standard error is 0.9 %
  int held = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const PairedShares s = compare_shares(drawn(trial, 20));
    held += s.low <= 0.3 && 0.3 <= s.high;
  }
  std::printf("held %.3f of %d\n", held / double(trials), trials);
  EXPECT_NEAR(held / double(trials), 0.955, 0.025);
}

}  // namespace
}  // namespace dougong::app
