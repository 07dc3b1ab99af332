#include "structures/units.h"

#include <gtest/gtest.h>

#include <charconv>
#include <limits>
#include <numbers>

#include "structures/nearest_name.h"

namespace dougong::structures {
namespace {

TEST(PrintValue, ChoosesTheUnitThatReadsBest) {
  EXPECT_EQ(print_value(0.3, Dimension::length), "0.3 m");
  EXPECT_EQ(print_value(0.001, Dimension::length), "1 mm");
  EXPECT_EQ(print_value(30e9, Dimension::pressure), "30 GPa");
  EXPECT_EQ(print_value(2400.0, Dimension::density), "2400 kg/m3");
  EXPECT_EQ(print_value(0.4 * 9.80665, Dimension::acceleration), "0.4 g");
  EXPECT_EQ(print_value(3.0, Dimension::acceleration), "3 m/s2");
  EXPECT_EQ(print_value(15.0 * std::numbers::pi / 180.0, Dimension::angle), "15 deg");
  EXPECT_EQ(print_value(0.0, Dimension::length), "0 m");
  EXPECT_EQ(print_value(-0.25, Dimension::length), "-0.25 m");
}

TEST(PrintValue, LeavesCountsAndRatiosBare) {
  EXPECT_EQ(print_value(4.0, Dimension::count), "4");
  EXPECT_EQ(print_value(0.05, Dimension::ratio), "0.05");
}

TEST(PrintNumber, IsTheShortestThatReadsBackExactly) {
  for (const double value :
       {0.1, 1.0 / 3.0, 1e-9, 6.02e23, 20000.0, -2.5, std::numeric_limits<double>::denorm_min()}) {
    const std::string text = print_number(value);
    double back = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, value) << text;
  }
  EXPECT_EQ(print_number(20000.0), "20000");
  EXPECT_EQ(print_number(0.1), "0.1");
}

TEST(Units, GiveEveryDimensionAnSiUnit) {
  for (const Unit& unit : units()) {
    if (!has_unit(unit.dimension)) continue;
    bool si = false;
    for (const Unit& other : units())
      si = si || (other.dimension == unit.dimension && other.multiply == 1.0 && other.divide == 1.0);
    EXPECT_TRUE(si) << name_of(unit.dimension);
  }
}

TEST(Units, AreListedForMessages) {
  EXPECT_EQ(possible_units(Dimension::length), "m, mm, cm, km");
  EXPECT_EQ(possible_units(Dimension::count), "");
}

TEST(EditDistance, CountsLettersAndSwaps) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("storeys", "storeys"), 0u);
  EXPECT_EQ(edit_distance("storey", "storeys"), 1u);
  EXPECT_EQ(edit_distance("stroeys", "storeys"), 1u);  // a swap is one slip
}

TEST(NearestName, OffersOnlyWhatIsNear) {
  const std::vector<std::string> names{"four-storey", "ten-storey", "brick-wall"};
  EXPECT_EQ(nearest_name("brikwall", names), "brick-wall");
  EXPECT_EQ(nearest_name("fuor-storey", names), "four-storey");
  EXPECT_EQ(nearest_name("cathedral", names), "");
}

}  // namespace
}  // namespace dougong::structures
