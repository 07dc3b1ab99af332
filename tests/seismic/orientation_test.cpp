#include "seismic/orientation.h"

#include <gtest/gtest.h>

namespace dougong::seismic {
namespace {

Record named(const char* component) {
  Record record;
  record.component = component;
  record.axis = axis_of(component);
  record.azimuth = azimuth_of(component);
  return record;
}

TEST(Orientation, ReadsBearingsDegreesAndCompassPoints) {
  const std::pair<const char*, double> known[] = {
      {"N08W", 352}, {"S16W", 196},  {"S74E", 106}, {"N90E", 90}, {"N00E", 0},   {"90", 90}, {"360", 0},
      {"067", 67},   {"90 DEG", 90}, {"EW", 90},    {"E-W", 90},  {"EW2", 90},   {"NS1", 0}, {"HNE", 90},
      {"BNN", 0},    {"N", 0},       {"W", 270},    {"North", 0}, {"22.5", 22.5}};
  for (const auto& [name, azimuth] : known) {
    ASSERT_TRUE(azimuth_of(name)) << name;
    EXPECT_DOUBLE_EQ(*azimuth_of(name), azimuth) << name;
  }
}

TEST(Orientation, KnowsNothingOfNamesThatDoNotSay) {
  for (const char* name : {"", "H1", "L", "T3", "HN1", "400", "N95E", "NXXE", "UP", "HNZ", "-1", "1e400"})
    EXPECT_FALSE(azimuth_of(name)) << name;
}

TEST(Orientation, FindsAComponentByNameOrDirection) {
  EXPECT_TRUE(is_component(named("E-W"), "ew"));
  EXPECT_TRUE(is_component(named("EW2"), "EW"));
  EXPECT_TRUE(is_component(named("HNE"), "90"));
  EXPECT_TRUE(is_component(named("90"), "E-W"));
  EXPECT_TRUE(is_component(named("360"), "NS"));
  EXPECT_TRUE(is_component(named("N08W"), "352"));
  EXPECT_FALSE(is_component(named("HNE"), "0"));
  EXPECT_FALSE(is_component(named("HNZ"), "0"));
  EXPECT_FALSE(is_component(named("H1"), "90"));
}

}  // namespace
}  // namespace dougong::seismic
