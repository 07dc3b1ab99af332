#include "structures/model_check.h"

#include <gmock/gmock.h>

#include <chrono>

#include "structures/layouts/layout.h"
#include "structures/separation.h"

namespace dougong::structures {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A ground of 20 m and boxes by centre, size and tilt.
struct Site {
  Building building;

  Site() {
    engine::Terrain ground;
    ground.name = "ground";
    ground.shape = engine::make_rectangle(20.0, 1.0);
    ground.position = {0.0, -0.5};
    building.scene.terrains.push_back(ground);
  }
  Site& box(const std::string& name, double x, double y, double width, double height, double angle = 0.0) {
    engine::Body body;
    body.name = name;
    body.shape = engine::make_rectangle(width, height);
    body.position = {x, y};
    body.angle = angle;
    building.scene.bodies.push_back(body);
    return *this;
  }
  std::vector<Finding> check() const { return check_model(building); }
};

auto error_saying(const std::string& text) {
  return AllOf(Field(&Finding::severity, Severity::error), Field(&Finding::message, HasSubstr(text)));
}
auto warning_saying(const std::string& text) {
  return AllOf(Field(&Finding::severity, Severity::warning), Field(&Finding::message, HasSubstr(text)));
}

TEST(ModelCheck, LocatesAnOverlap) {
  const auto findings = Site().box("a", 0, 0.5, 1, 1).box("b", 0, 1.4969, 1, 1).check();
  ASSERT_THAT(findings, ElementsAre(error_saying("block a overlaps b by 3.1 mm at (0.00, 1.00) m")));
  EXPECT_NEAR(findings[0].place.y, 0.99845, 1e-9);
}

TEST(ModelCheck, LocatesABlockThatSinksIntoTheGround) {
  EXPECT_THAT(Site().box("a", 2, 0.48, 1, 1).check(),
              ElementsAre(error_saying("block a overlaps terrain ground by 20 mm at (2.00, -0.01) m")));
}

TEST(ModelCheck, FindsOverlapsOfTiltedBlocks) {
  // Two squares on the ground, the second turned by 45 deg: its corner reaches 0.1 m into the first.
  const double half_diagonal = 0.5 * std::sqrt(2.0);
  EXPECT_THAT(
      Site().box("a", 0, 0.5, 1, 1).box("b", 0.4 + half_diagonal, half_diagonal, 1, 1, M_PI / 4).check(),
      ElementsAre(error_saying("block a overlaps b by 100 mm at (0.45, 0.71) m")));
}

TEST(ModelCheck, AcceptsTouchingBlocksFarFromTheOrigin) {
  Site site;
  site.building.scene.terrains[0].position.x = 1e5;
  EXPECT_THAT(site.box("a", 1e5 + 0.1, 0.15, 0.7, 0.3).box("b", 1e5 + 0.1, 0.45, 0.7, 0.3).check(),
              IsEmpty());
}

TEST(ModelCheck, WarnsOfAHairlineGapBelowABlock) {
  EXPECT_THAT(Site().box("a", 0, 0.5, 1, 1).box("b", 0, 1.5004, 1, 1).check(),
              ElementsAre(warning_saying("a and b are 0.4 mm apart at (0.00, 1.00) m")));
}

TEST(ModelCheck, DoesNotMindOpenHeadJoints) {
  EXPECT_THAT(Site().box("a", 0, 0.5, 1, 1).box("b", 1.0005, 0.5, 1, 1).check(), IsEmpty());
}

TEST(ModelCheck, FindsBlocksThatHangInTheAir) {
  // b floats and c stands on b: neither leads to the ground.
  EXPECT_THAT(
      Site().box("a", 0, 0.5, 1, 1).box("b", 0, 2.5, 1, 1).box("c", 0, 3.5, 1, 1).check(),
      ElementsAre(error_saying("block b hangs in the air"), error_saying("block c hangs in the air")));
}

TEST(ModelCheck, DoesNotTakeASideFaceForASupport) {
  EXPECT_THAT(Site().box("a", 0, 1, 1, 2).box("b", 1, 1.5, 1, 1).check(),
              ElementsAre(error_saying("block b hangs in the air")));
}

TEST(ModelCheck, DoesNotTakeTwoSideFacesForASupport) {
  EXPECT_THAT(Site().box("a", 0, 1, 1, 2).box("b", 1, 1.5, 1, 1).box("c", 2, 1, 1, 2).check(),
              ElementsAre(error_saying("block b hangs in the air")));
}

TEST(ModelCheck, KnowsThatVoussoirsHoldEachOther) {
  for (const double voussoirs : {9.0, 24.0, 99.0})
    EXPECT_THAT(check_model(build_layout("arch", {{"voussoirs", voussoirs}})), IsEmpty()) << voussoirs;
}

TEST(ModelCheck, MissesTheVoussoirThatTheCrownLeansOn) {
  Building arch = build_layout("arch", {{"voussoirs", 24}});
  arch.scene.bodies.erase(arch.scene.bodies.begin() + 13);
  arch.storeys.clear();
  const auto findings = check_model(arch);
  ASSERT_FALSE(findings.empty());
  EXPECT_THAT(findings[0], error_saying("hangs in the air"));
}

TEST(ModelCheck, WarnsOfACentreOfMassBesideItsSupport) {
  EXPECT_THAT(Site().box("a", 0, 0.5, 1, 1).box("b", 0.6, 1.25, 1, 0.5).check(),
              ElementsAre(warning_saying("block b has its centre of mass 100 mm beside its support")));
}

TEST(ModelCheck, AcceptsABlockBridgingTwoSupports) {
  EXPECT_THAT(Site().box("a", -2, 0.5, 1, 1).box("b", 2, 0.5, 1, 1).box("c", 0, 1.25, 5, 0.5).check(),
              IsEmpty());
}

TEST(ModelCheck, WarnsOfDoubtfulAndRefusesAbsurdMasses) {
  EXPECT_THAT(Site().box("a", 0, 5, 10, 10).box("pebble", 6, 0.02, 0.04, 0.04).check(),
              ElementsAre(warning_saying("the mass of block a")));
  EXPECT_THAT(Site().box("a", 0, 5, 10, 10).box("grain", 6, 0.0005, 0.001, 0.001).check(),
              ElementsAre(error_saying("the mass of block a")));
}

TEST(ModelCheck, WarnsOfDoubtfulStiffnesses) {
  Site site;
  engine::Material rubber;
  rubber.young_modulus = 1e6;
  site.building.scene.materials.push_back(rubber);
  site.box("a", 0, 0.5, 1, 1).box("pad", 3, 0.5, 1, 1);
  site.building.scene.bodies[1].material = 1;
  EXPECT_THAT(site.check(), ElementsAre(warning_saying("Young's modulus of block a")));
}

TEST(ModelCheck, WarnsOfSlivers) {
  EXPECT_THAT(Site().box("plate", 0, 0.01, 4, 0.02).check(),
              ElementsAre(warning_saying("block plate is a sliver, 200 times as long as wide")));
}

TEST(ModelCheck, RefusesABuildingWithoutGroundOrBlocks) {
  EXPECT_THAT(check_model(Building{}),
              ElementsAre(error_saying("no terrain"), error_saying("there are no blocks")));
}

TEST(ModelCheck, RefusesStoreysWithoutLevel) {
  Site site;
  site.box("a", 0, 0.5, 1, 1);
  site.building.storeys = {{"S1", 0.0, 0.0, {}, {7}}};
  EXPECT_THAT(site.check(), ElementsAre(error_saying("no block that marks its level"),
                                        error_saying("height of 0 m"), error_saying("names block 7 of 1")));
}

TEST(ModelCheck, PutsErrorsBeforeWarnings) {
  const auto findings = Site().box("b", 0, 0.5004, 1, 1).box("c", 5, 4, 1, 1).check();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].severity, Severity::error);
  EXPECT_EQ(findings[1].severity, Severity::warning);
}

TEST(ModelCheck, KnowsCircles) {
  Site site;
  site.box("a", 0, 0.5, 1, 1);
  engine::Body ball;
  ball.name = "ball";
  ball.shape = engine::make_circle(0.5);
  ball.position = {0.0, 1.5};
  site.building.scene.bodies.push_back(ball);
  EXPECT_THAT(site.check(), IsEmpty());
  site.building.scene.bodies[1].position.y = 1.49;
  EXPECT_THAT(site.check(), ElementsAre(error_saying("block a overlaps ball by 10 mm")));
}

TEST(ModelCheck, IsInstantForThousandsOfBricks) {
  const Building wall = build_layout(
      "brick-wall", {{"courses", 100}, {"bricks_per_course", 40}, {"levels", 10}, {"ground_width", 30.0}});
  ASSERT_GT(wall.scene.bodies.size(), 4000u);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(check_model(wall), IsEmpty());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 5.0);  // a hundred times what it takes
}

TEST(Separation, MeasuresGapsAndDepthsOfParallelFaces) {
  const PlacedShape a = place(engine::make_rectangle(1, 1), {0, 0}, 0);
  for (const double gap : {-0.2, 0.0, 0.3}) {
    const Separation s = separation(place(engine::make_rectangle(1, 1), {0.25, 1.0 + gap}, 0), a, 1e-6);
    EXPECT_NEAR(s.gap, gap, 1e-12);
    EXPECT_NEAR(s.normal.y, 1.0, 1e-12);
    EXPECT_TRUE(s.facing);
    EXPECT_NEAR(std::min(s.from.x, s.to.x), -0.25, 1e-12);
    EXPECT_NEAR(std::max(s.from.x, s.to.x), 0.5, 1e-12);
  }
}

TEST(Separation, PartsACircleFromACorner) {
  const Separation s = separation(place(engine::make_circle(1.0), {3, 4}, 0),
                                  place(engine::make_rectangle(2, 2), {-1, -1}, 0), 1e-6);
  EXPECT_NEAR(s.gap, 4.0, 1e-12);  // the corner is at the origin, 5 m from the centre
  EXPECT_NEAR(s.normal.x, 0.6, 1e-12);
}

}  // namespace
}  // namespace dougong::structures
