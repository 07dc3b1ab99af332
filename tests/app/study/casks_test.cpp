// M05: casks at 0.3 g stand; with the friction of steel on concrete they hardly slide, with very little they
// do.
#include "tests/scenes/casks.h"

#include <gtest/gtest.h>

namespace dougong {
namespace {

scenes::CaskMotion cask(const std::string& record, double friction) {
  return scenes::shaken_cask(record, "0.3 g", friction, DOUGONG_RECORDS_DIRECTORY);
}

TEST(Casks, StandAndHardlySlideWithTheFrictionOfTheirPad) {
  for (const char* record : {"kobe", "elcentro"})
    for (const double friction : {0.3, 0.5}) {
      const scenes::CaskMotion motion = cask(record, friction);
      EXPECT_EQ(motion.verdict, structures::VerdictKind::survived) << record << " " << friction;
      EXPECT_LT(motion.farthest, 1e-3) << record << " " << friction;
    }
}

// Pure sliding takes far less friction than a pad has to give the 25 to 115 mm that were seen.
TEST(Casks, SlideFartherTheLessFrictionTheyHave) {
  const double little = cask("elcentro", 0.05).farthest, more = cask("elcentro", 0.2).farthest;
  EXPECT_GT(little, 0.025);
  EXPECT_LT(more, 0.01);
}

}  // namespace
}  // namespace dougong
