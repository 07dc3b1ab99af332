#include "seismic/formats/columns.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "seismic/read_record.h"
#include "seismic/units.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;
using ::testing::Not;
using testing::write_file;

Record read(const std::string& bytes, const ReadOptions& options) {
  return read_record(write_file("a.csv", bytes), options).components.at(0);
}

ReadOptions in_units(const char* units) {
  ReadOptions options;
  options.units = units;
  return options;
}

std::string time_series(const char* separator, int samples = 50) {
  std::string text;
  for (int k = 0; k < samples; ++k)
    text += fmt::format("{:.4f}{}{:.4f}\n", 0.01 * k, separator, std::sin(0.2 * k));
  return text;
}

TEST(Columns, ReadsTimeAndValueWithAnySeparatorAndHeader) {
  for (const char* separator : {"\t", ",", "  ", " ; "}) {
    const Record record =
        read("Some earthquake\nStation 17\n1994\nTime[s] Accel[g]\n" + time_series(separator), in_units("g"));
    ASSERT_EQ(record.acceleration.size(), 50u);
    EXPECT_DOUBLE_EQ(record.interval, 0.01);
    EXPECT_DOUBLE_EQ(record.acceleration[1], 0.1987 * standard_gravity);
    EXPECT_EQ(record.provenance.units, "g (given by the user)");
    EXPECT_EQ(record.provenance.event, "Some earthquake");
  }
}

TEST(Columns, NeverGuessesUnits) {
  const std::string text = input_error([] { read("Time[s] Accel[g]\n" + time_series("\t"), {}); });
  EXPECT_THAT(text, HasSubstr("expected the units of the values: option units = g, gal, cm/s2"));
  EXPECT_THAT(text, HasSubstr("the header says \"Time[s] Accel[g]\""));
  EXPECT_THAT(input_error([] { read(time_series("\t"), in_units("furlongs")); }),
              HasSubstr("found \"furlongs\""));
}

TEST(Columns, OneColumnNeedsItsStep) {
  EXPECT_THAT(input_error([] { read("1.0\n2.0\n3.0\n", in_units("m/s2")); }),
              HasSubstr("(option dt, in s), found none"));
  ReadOptions options = in_units("gal");
  options.interval = 0.02;
  const Record record = read("1.0\n2.0\n3.0\n", options);
  EXPECT_EQ(record.acceleration, (std::vector<double>{0.01, 0.02, 0.03}));
  EXPECT_EQ(record.interval, 0.02);
}

TEST(Columns, CountsInRowsNeedAScale) {
  std::string bytes;
  for (int row = 0; row < 20; ++row) bytes += "-31000,-31035,-31068,-31054,-31038,-31062,-31053,-30998\n";
  bytes += "-30997,-31038\n";
  ReadOptions options = in_units("counts");
  options.interval = 0.01;
  EXPECT_THAT(input_error([&] { read(bytes, options); }), HasSubstr("the scale of the counts"));
  options.count_scale = parse_count_scale("3920/6182761");
  const Record record = read(bytes, options);
  EXPECT_EQ(record.acceleration.size(), 162u);
  EXPECT_NEAR(record.acceleration[1] - record.acceleration[0], -35 * 39.20 / 6182761, 1e-12);
  EXPECT_NEAR(record.acceleration[0] + record.acceleration[1],
              2 * record.acceleration[0] - 35 * 39.20 / 6182761, 1e-12);
  options.interval.reset();
  EXPECT_THAT(input_error([&] { read(bytes, options); }), HasSubstr("found 8 columns"));
}

TEST(Columns, ReadsFieldsThatTouch) {
  ReadOptions options = in_units("m/s2");
  options.interval = 0.01;
  const Record record = read("-1.9150000E-06-1.7847000E-06 1.5057E+0-2.2223E+0\n1 2 3 4\n", options);
  ASSERT_EQ(record.acceleration.size(), 8u);
  EXPECT_DOUBLE_EQ(record.acceleration[1], -1.7847e-06);
  EXPECT_DOUBLE_EQ(record.acceleration[3], -2.2223);
}

TEST(Columns, RefusesTimesThatAreNotUniform) {
  std::string bytes = "Time,Acc\n" + time_series(",", 30);
  bytes += fmt::format("{:.4f},0.1\n", 0.31) + fmt::format("{:.4f},0.1\n", 0.32);
  EXPECT_THAT(
      input_error([&] { read(bytes, in_units("g")); }),
      HasSubstr(
          "a.csv:32: expected equal time steps (0.0103226 s on average; option dt resamples to equal ones), "
          "found a step of 0.02 s to 0.31 s"));
}

TEST(Columns, ResamplesALostSampleOnlyWhenTheStepIsGiven) {
  std::string bytes = "Time,Acc\n" + time_series(",", 30);
  bytes += fmt::format("{:.4f},0.1\n", 0.31) + fmt::format("{:.4f},0.1\n", 0.32);
  ReadOptions options = in_units("g");
  options.interval = 0.01;
  const Record record = read(bytes, options);
  EXPECT_EQ(record.acceleration.size(), 33u);
  EXPECT_THAT(record.processing,
              ::testing::Contains(HasSubstr("32 samples 0.01 to 0.02 s apart resampled to 33")));
}

TEST(Columns, ResamplesUnevenTimesAndSaysSo) {
  const Record record = read("0.00 0\n0.01 1\n0.03 3\n0.07 7\n0.08 8\n0.10 10\n", in_units("m/s2"));
  ASSERT_EQ(record.acceleration.size(), 11u);
  for (std::size_t k = 0; k < 11; ++k) EXPECT_NEAR(record.acceleration[k], static_cast<double>(k), 1e-9);
  EXPECT_THAT(record.processing, ::testing::Contains(HasSubstr("resampled to 11 every 0.01 s")));
}

TEST(Columns, TakesAShorterFirstStepAndATimeThatBeginsLate) {
  const Record shorter = read("0 1\n0.005 2\n0.015 3\n0.025 4\n0.035 5\n", in_units("m/s2"));
  EXPECT_DOUBLE_EQ(shorter.interval, 0.01);
  EXPECT_THAT(shorter.warnings, ::testing::Contains(HasSubstr("the first step is 0.005 s")));
  const Record late = read("0.01 1\n0.02 2\n0.03 3\n0.04 4\n", in_units("m/s2"));
  EXPECT_DOUBLE_EQ(late.interval, 0.01);
  EXPECT_EQ(late.acceleration, (std::vector<double>{1, 2, 3, 4}));
}

TEST(Columns, ReadsSeveralComponentsBehindTheTime) {
  std::string bytes = "time;EW;NS;UD\n";
  for (int k = 0; k < 20; ++k) bytes += fmt::format("{:.2f};{};{};{}\n", 0.02 * k, k % 5, k % 3, k % 7);
  const RecordSet set = read_record(write_file("a.csv", bytes), in_units("gal"));
  ASSERT_EQ(set.components.size(), 3u);
  EXPECT_EQ(set.components[1].component, "NS");
  EXPECT_EQ(set.vertical()->component, "UD");
  EXPECT_DOUBLE_EQ(set.components[1].acceleration[2], 0.02);
  EXPECT_DOUBLE_EQ(set.horizontal().interval, 0.02);
}

TEST(Columns, RefusesTimesThatGoBack) {
  EXPECT_THAT(input_error([] { read("0.03 1\n0.02 2\n0.01 3\n0.0 4\n", in_units("g")); }),
              HasSubstr("times that increase"));
}

TEST(Columns, RefusesNanOneSampleAndLostFields) {
  EXPECT_THAT(input_error([] { read("0.00 1\n0.01 nan\n0.02 3\n", in_units("g")); }),
              HasSubstr("a.csv:2: expected finite numbers, found \"nan\""));
  EXPECT_THAT(input_error([] { read("0.00 1\n0.01 2\n0.02 oops\n", in_units("g")); }), HasSubstr("a.csv:3"));
  EXPECT_THAT(input_error([] { read("0.00 1\n", in_units("g")); }),
              HasSubstr("at least 2 samples, found one sample"));
  EXPECT_THAT(input_error([] { read("0.00 1\n0.01 2\n0.02\n0.03 1\n", in_units("g")); }),
              HasSubstr("a.csv:3: expected 2 numbers, as on the rows above, found 1"));
}

TEST(Columns, TellsEverythingThatIsMissingAtOnce) {
  const std::string text = input_error([] { read("1.0\n2.0\n3.0\n", {}); });
  EXPECT_THAT(text, HasSubstr("option units"));
  EXPECT_THAT(text, HasSubstr("option dt"));
}

TEST(Units, AreThoseOfTheField) {
  EXPECT_DOUBLE_EQ(*acceleration_unit("g"), 9.80665);
  EXPECT_DOUBLE_EQ(*acceleration_unit("G", 9.81), 9.81);
  EXPECT_DOUBLE_EQ(*acceleration_unit("CM/SEC/SEC"), 0.01);
  EXPECT_DOUBLE_EQ(*acceleration_unit("cm/s^2"), 0.01);
  EXPECT_DOUBLE_EQ(*acceleration_unit("mm/s2"), 0.001);
  EXPECT_DOUBLE_EQ(*acceleration_unit("g/10"), 0.980665);
  EXPECT_DOUBLE_EQ(*acceleration_unit(" m/s2 "), 1.0);
  EXPECT_FALSE(acceleration_unit("counts").has_value());
  EXPECT_FALSE(acceleration_unit("").has_value());
  EXPECT_DOUBLE_EQ(*parse_count_scale("3920(gal)/6182761"), 39.20 / 6182761);
  EXPECT_FALSE(parse_count_scale("gal").has_value());
  EXPECT_FALSE(parse_count_scale("3920/0").has_value());
}

}  // namespace
}  // namespace dougong::seismic
