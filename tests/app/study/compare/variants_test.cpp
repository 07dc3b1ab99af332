#include "app/study/compare/variants.h"

#include <gmock/gmock.h>

namespace dougong::app {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> values_of(const std::string& text) {
  std::vector<std::string> values;
  for (const Variant& variant : variants_of_key(text)) values.push_back(variant.overrides.at(0).value);
  return values;
}

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  for (const Variant& variant : variants) names.push_back(variant.name);
  return names;
}

TEST(Variants, ShareTheUnitOfTheLastValue) {
  EXPECT_THAT(values_of("width = 0.3, 0.6 m"), ElementsAre("0.3 m", "0.6 m"));
  EXPECT_THAT(values_of("width=30 cm,0.6 m"), ElementsAre("30 cm", "0.6 m"));
  EXPECT_THAT(values_of("friction=2, 3e-1, 5 %"), ElementsAre("2 %", "3e-1 %", "5 %"));
  EXPECT_THAT(values_of("drums=2, 3"), ElementsAre("2", "3"));
  EXPECT_THAT(values_of("isolation = none, friction-pendulum"), ElementsAre("none", "friction-pendulum"));
}

TEST(Variants, KeepTheCommasOfBracketsAndQuotes) {
  EXPECT_THAT(values_of("points = [[1, 2], [3, 4]], [[5, 6]]"), ElementsAre("[[1, 2], [3, 4]]", "[[5, 6]]"));
  EXPECT_THAT(values_of("name = \"a, b\", c"), ElementsAre("\"a, b\"", "c"));
}

TEST(Variants, AreCrossedEachWithEach) {
  const auto all = crossed(variants_of_key("a=1,2"), variants_of_key("b=x,y"));
  EXPECT_THAT(names_of(all), ElementsAre("a = 1, b = x", "a = 1, b = y", "a = 2, b = x", "a = 2, b = y"));
  ASSERT_EQ(all[2].overrides.size(), 2u);
  EXPECT_EQ(all[2].overrides[0].value, "2");
  EXPECT_EQ(all[2].overrides[1].value, "x");
  EXPECT_EQ(crossed({}, variants_of_key("b=x,y")).size(), 2u);
}

TEST(Variants, RefuseWhatNamesNoValue) {
  EXPECT_THROW(variants_of_key("width"), ScenarioError);
  EXPECT_THROW(variants_of_key("width = 1 m,"), ScenarioError);
  EXPECT_THROW(variants_of_key("= 1 m"), ScenarioError);
}

TEST(Variants, HaveFoldersThatEveryFileSystemTakes) {
  EXPECT_EQ(folder_name("left_column_width = 0.6 m, isolation = none"),
            "left_column_width-0.6-m-isolation-none");
  EXPECT_EQ(folder_name("../.."), "..-..");
  EXPECT_EQ(folder_name(".."), "_..");
  EXPECT_EQ(folder_name("/"), "_");
  EXPECT_THAT(told_apart({"a", "a", "b", "a-2"}), ElementsAre("a", "a-2", "b", "a-2-2"));
}

}  // namespace
}  // namespace dougong::app
