#include "app/study/quantity.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using enum structures::Dimension;

std::string refusal(const std::string& text, Dimension dimension) {
  try {
    const double value = parse_quantity(text, dimension);
    return "accepted as " + std::to_string(value);
  } catch (const QuantityError& error) {
    return error.what();
  }
}

TEST(Quantity, IsReadToSi) {
  EXPECT_DOUBLE_EQ(parse_quantity("0.4 g", acceleration), 3.92266);
  EXPECT_DOUBLE_EQ(parse_quantity("300 gal", acceleration), 3.0);
  EXPECT_DOUBLE_EQ(parse_quantity("2.9 m", length), 2.9);
  EXPECT_DOUBLE_EQ(parse_quantity("1 mm", length), 0.001);
  EXPECT_DOUBLE_EQ(parse_quantity("25 GPa", pressure), 25e9);
  EXPECT_DOUBLE_EQ(parse_quantity("5 %", ratio), 0.05);
  EXPECT_DOUBLE_EQ(parse_quantity("15 deg", angle), std::numbers::pi / 12.0);
  EXPECT_DOUBLE_EQ(parse_quantity("30 s", time), 30.0);
  EXPECT_DOUBLE_EQ(parse_quantity("2400 kg/m3", density), 2400.0);
  EXPECT_DOUBLE_EQ(parse_quantity("2.4 t/m3", density), 2400.0);
  EXPECT_DOUBLE_EQ(parse_quantity("25 Hz", frequency), 25.0);
  EXPECT_DOUBLE_EQ(parse_quantity("2 t", mass), 2000.0);
}

TEST(Quantity, NeedsNoBlankAndMindsNoBlanks) {
  EXPECT_DOUBLE_EQ(parse_quantity("0.4g", acceleration), 0.4 * 9.80665);
  EXPECT_DOUBLE_EQ(parse_quantity("  +2.5e-1   m ", length), 0.25);
  EXPECT_DOUBLE_EQ(parse_quantity("-3 m/s²", acceleration), -3.0);
}

TEST(Quantity, IsBareForCountsAndRatios) {
  EXPECT_EQ(parse_quantity("4", count), 4.0);
  EXPECT_EQ(parse_quantity("0.05", ratio), 0.05);
}

TEST(Quantity, RefusesABareNumberAndSaysWhichUnits) {
  EXPECT_THAT(refusal("0.4", acceleration),
              AllOf(HasSubstr("an acceleration with its unit (g, m/s2"), HasSubstr("the bare number 0.4")));
}

TEST(Quantity, RefusesAUnitOfAnotherDimension) {
  EXPECT_THAT(refusal("2 s", length), AllOf(HasSubstr("s is a unit of time"), HasSubstr("m, mm, cm, km")));
  EXPECT_THAT(refusal("4 m", count),
              HasSubstr("expected a whole number, found \"4 m\": m is a unit of length"));
}

TEST(Quantity, OffersTheNearestUnit) {
  EXPECT_THAT(refusal("25 Gpa", pressure), HasSubstr("unknown unit \"Gpa\"; did you mean \"GPa\"?"));
}

TEST(Quantity, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "m", "four m", "nan m", "inf m", "--3 m", "+-3 m", "1,5 m", "0x10 m",
                           "1e999 m", "1e308 km", "3 m m"})
    EXPECT_THROW(parse_quantity(text, length), QuantityError) << text;
  EXPECT_THROW(parse_quantity("2.5", count), QuantityError);
}

TEST(Quantity, ComesBackFromItsTextBitForBit) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-9.0, 12.0), sign(-1.0, 1.0);
  for (const Dimension dimension : {count, ratio, length, time, frequency, speed, acceleration, angle, mass,
                                    density, pressure, force, stiffness}) {
    for (int i = 0; i < 500; ++i) {
      double value = std::copysign(std::pow(10.0, exponent(random)), sign(random));
      if (dimension == count) value = std::round(value);
      const std::string text = print_quantity(value, dimension);
      EXPECT_EQ(parse_quantity(text, dimension), value) << text;
    }
  }
}

}  // namespace
}  // namespace dougong::app
