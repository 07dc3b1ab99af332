#include "seismic/rotate.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;

// A motion of amplitude 2 towards 30 degrees from north.
constexpr double amplitude = 2.0, direction = 30.0;

std::vector<double> along(double azimuth) {
  std::vector<double> out;
  for (int k = 0; k < 50; ++k)
    out.push_back(amplitude * std::sin(0.3 * k) * std::cos((azimuth - direction) * std::numbers::pi / 180.0));
  return out;
}

Record component(double azimuth) {
  Record record;
  record.acceleration = along(azimuth);
  record.interval = 0.01;
  record.component = std::to_string(static_cast<int>(azimuth));
  record.azimuth = azimuth;
  record.provenance.file = "a.V2";
  return record;
}

TEST(Rotate, ProjectsOnAnyDirection) {
  const auto north = along(0.0), east = along(90.0);
  for (const double azimuth : {0.0, 17.0, 30.0, 90.0, 120.0, 210.0, -45.0, 400.0}) {
    const auto turned = rotate(north, east, azimuth);
    for (std::size_t k = 0; k < turned.size(); ++k)
      EXPECT_NEAR(turned[k], along(azimuth)[k], 1e-14) << azimuth;
  }
}

TEST(Rotate, ByQuartersOfATurnChangesNoBit) {
  const auto north = along(0.0), east = along(90.0);
  EXPECT_EQ(rotate(north, east, 0.0), north);
  EXPECT_EQ(rotate(north, east, 90.0), east);
  EXPECT_EQ(rotate(north, east, 450.0), east);
}

TEST(Rotate, SolvesForNorthAndEastWhateverTheAxes) {
  for (const auto& [first, second] : {std::pair{0.0, 90.0}, {352.0, 82.0}, {10.0, 55.0}, {196.0, 106.0}}) {
    const NorthEast motion = north_east(along(first), first, along(second), second);
    for (std::size_t k = 0; k < motion.north.size(); ++k) {
      EXPECT_NEAR(motion.north[k], along(0.0)[k], 1e-13);
      EXPECT_NEAR(motion.east[k], along(90.0)[k], 1e-13);
    }
  }
  EXPECT_THROW(north_east(along(10), 10, along(190), 190), std::invalid_argument);
}

TEST(Rotate, TurnsASetAndKeepsItsVerticalComponent) {
  RecordSet set;
  set.components = {component(196.0), component(106.0), component(0.0)};
  set.components[2].axis = Axis::vertical;
  set.components[2].azimuth.reset();
  const RecordSet turned = rotated(set, direction);
  ASSERT_EQ(turned.components.size(), 3u);
  EXPECT_EQ(turned.horizontal().component, "30");
  EXPECT_EQ(turned.components[1].component, "120");
  for (const double a : turned.components[1].acceleration) EXPECT_NEAR(a, 0.0, 1e-13);
  EXPECT_THAT(turned.horizontal().processing.back(), HasSubstr("rotated: 196 (196) and 106 (106) to 30"));
  EXPECT_NE(turned.vertical(), nullptr);
}

TEST(Rotate, NeedsTwoKnownDirections) {
  RecordSet set;
  set.components = {component(10.0), component(190.0)};
  EXPECT_THAT(input_error([&] { rotated(set, 0.0); }), HasSubstr("in different directions"));
  set.components[1].azimuth.reset();
  EXPECT_THAT(input_error([&] { rotated(set, 0.0); }),
              HasSubstr("two horizontal components of known direction, found 1"));
}

}  // namespace
}  // namespace dougong::seismic
