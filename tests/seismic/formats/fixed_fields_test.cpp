#include "seismic/formats/fixed_fields.h"

#include <gmock/gmock.h>

namespace dougong::seismic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Read {
  std::vector<double> values;
  std::vector<InputProblem> problems;
  std::size_t line = 0;
};

Read read(const std::string& bytes, std::size_t count, FieldFormat format) {
  FileText text;
  set_bytes("a.V2", bytes, text);
  Read out;
  out.values = read_block(text, out.line, count, format, out.problems);
  return out;
}

TEST(FixedFields, FindsTheFormatInEverySpelling) {
  for (const char* text :
       {"(8f10.6)", "  7500 points of accel data equally spaced at .010 sec, in cm/sec2. (8f10.6)",
        "#Data: 8F10.3 ", "Format = (8F10.6)", "Format=(8E10.3)", "8I10"}) {
    const auto format = field_format_in(text);
    ASSERT_TRUE(format) << text;
    EXPECT_EQ(format->per_line, 8u) << text;
    EXPECT_EQ(format->width, 10u) << text;
  }
  EXPECT_EQ(field_format_in("Format=(E15.6)")->per_line, 1u);
  for (const char* text : {"", "units: CM/SEC/SEC", "(8x)", "record of 1994", "(999999999999999999999F10)",
                           "(8F0.0)", "(8F99.0)", "E"})
    EXPECT_FALSE(field_format_in(text)) << text;
}

TEST(FixedFields, PartsFieldsThatTouch) {
  EXPECT_THAT(read("30.000000-999.00000\n", 2, {2, 9}).problems, SizeIs(1));  // not their width
  const Read reals = read(" 30.000000-999.00000\n", 2, {8, 10});
  EXPECT_THAT(reals.values, ElementsAre(30.0, -999.0));
  EXPECT_THAT(read("    3110015000   39\n", 4, {16, 5}).values, ElementsAre(3, 11001, 5000, 39));
  EXPECT_THAT(read("100.001   .002100.006  -.003\n", 4, {10, 7}).values,
              ElementsAre(100.001, 0.002, 100.006, -0.003));
}

TEST(FixedFields, TakesTheWidthFromALine) {
  const auto touching = field_format_of_line("-1.9150000E-06-1.7847000E-06");
  ASSERT_TRUE(touching);
  EXPECT_EQ(touching->per_line, 2u);
  EXPECT_EQ(touching->width, 14u);
  const auto indented = field_format_of_line("    .000  -.006   .005   .007");
  ASSERT_TRUE(indented);
  EXPECT_EQ(indented->indent, 1u);
  EXPECT_EQ(indented->width, 7u);
  EXPECT_FALSE(field_format_of_line("1 22 333"));
  EXPECT_FALSE(field_format_of_line("no numbers"));
}

TEST(FixedFields, NamesTheLineAndWhatIsWrongWithIt) {
  const auto problem = [](const std::string& bytes, std::size_t count) {
    const Read read_back = read(bytes, count, {2, 5});
    return read_back.problems.empty() ? std::string{} : read_back.problems.front().text();
  };
  EXPECT_THAT(problem("  1.0  2.0\n  x.0  4.0\n", 4),
              HasSubstr("a.V2:2: expected 2 finite numbers in fields 5 wide, "
                        "found \"x.0\""));
  EXPECT_THAT(problem("  1.0  2.0\n  3.0     \n", 4),
              HasSubstr("a.V2:2: expected 2 finite numbers in fields 5 wide, "
                        "found 1 fields"));
  EXPECT_THAT(problem("  1.0  2.0  3.0\n", 2), HasSubstr("found \"3.0\" behind them"));
  EXPECT_THAT(problem("  1.0  2.0\n", 4), HasSubstr("expected 4 values, as the header states, found 2"));
  EXPECT_THAT(problem("  1.0  nan\n", 2), HasSubstr("found \"nan\""));
}

TEST(FixedFields, AHugeCountAllocatesNoMoreThanTheFileCanHold) {
  const Read cut = read("  1.0  2.0\n", static_cast<std::size_t>(-1), {2, 5});
  EXPECT_THAT(cut.values, SizeIs(2));
  EXPECT_LE(cut.values.capacity(), 4u);
  EXPECT_THAT(cut.problems, SizeIs(1));
}

TEST(FixedFields, MovesBehindTheBlock) {
  EXPECT_EQ(read("  1.0  2.0\n  3.0\n  4.0\n", 3, {2, 5}).line, 2u);
  EXPECT_EQ(read("  1.0\n", 0, {2, 5}).line, 0u);
}

}  // namespace
}  // namespace dougong::seismic
