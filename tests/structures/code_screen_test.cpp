#include "structures/code_screen.h"

#include <gmock/gmock.h>

#include "structures/layouts/layout.h"

namespace dougong::structures {
namespace {

using ::testing::IsEmpty;

Response drifted(double peak, double residual) {
  Response response;
  StoreyResponse storey;
  storey.name = "S1";
  storey.peak_drift.negative = {-peak, 3.0};
  storey.residual_drift = -residual;
  response.storeys = {storey};
  return response;
}

const CodeScreen code{"x",
                      "X 1",
                      "",
                      "",
                      {{"frames", "1.1", "2", {"rc frame"}, {{"IO", 0.01, {}}, {"LS", 0.02, 0.005}}},
                       {"all", "1.2", "d", {"any"}, {{"limit", 0.015, {}}}},
                       {"walls", "1.3", "1", {"rc wall"}, {{"limit", 0.001, {}}}}}};

TEST(CodeScreen, ComparesTheSizeOfTheGreatestDriftWithItsLimits) {
  const auto checks = screen(code, "rc frame", drifted(0.018, 0.006));
  ASSERT_EQ(checks.size(), 4u);
  EXPECT_TRUE(checks[0].exceeded);   // 1.8 % over 1 %
  EXPECT_FALSE(checks[1].exceeded);  // 1.8 % under 2 %
  EXPECT_EQ(checks[2].measure, "residual drift");
  EXPECT_TRUE(checks[2].exceeded);  // 0.6 % over 0.5 %
  EXPECT_EQ(checks[2].found, 0.006);
  EXPECT_TRUE(checks[3].exceeded);  // a row for any structure
  EXPECT_EQ(checks[3].clause, "1.2");
}

TEST(CodeScreen, ADriftAtItsLimitIsWithin) {
  EXPECT_FALSE(screen(code, "rc frame", drifted(0.01, 0.0))[0].exceeded);
}

TEST(CodeScreen, KeepsNoLimitOfABuildingThatLostAStorey) {
  Response response = drifted(0.001, 0.0);
  response.storeys[0].lost_at = 4.0;
  for (const CodeCheck& check : screen(code, "rc frame", response)) EXPECT_TRUE(check.exceeded);
}

TEST(CodeScreen, HasNothingForAnAssemblyWithoutAType) {
  EXPECT_THAT(screen(code, "", drifted(0.1, 0.1)), IsEmpty());
}

TEST(StructuralType, IsThatOfTheLayoutAndNoneOfWhatIsLaidDry) {
  EXPECT_EQ(structural_type_of(build_layout("concrete-frame")), "rc frame");
  EXPECT_EQ(structural_type_of(build_layout("masonry-house")), "masonry");
  EXPECT_EQ(structural_type_of(build_layout("brick-wall")), "");  // dry by default
  EXPECT_EQ(structural_type_of(build_layout("four-storey")), "");
  EXPECT_EQ(structural_type_of(Building{}), "");
}

}  // namespace
}  // namespace dougong::structures
