#include "seismic/formats/rec_shape.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "seismic/read_record.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::input_error;
using testing::write_file;

const std::string titles = "\xD5\xF0\xBC\xB6\t\xB7\xA2\xC9\xFA\xC4\xEA\xB7\xDD\r\n";

// Times with three significant digits, as one of the files in use has them.
std::string shape(const std::string& facts, int samples = 500) {
  std::string bytes = titles + facts + "\r\n";
  for (int k = 0; k < samples; ++k) bytes += fmt::format("{:.2E}\t{:.6E}\r\n", 0.01 * k, std::cos(0.3 * k));
  return bytes;
}

TEST(RecShape, TakesTheStepFromTheFirstTwoLines) {
  const Record record =
      read_record(write_file("w.rec", shape("8.0\t2010\tWenchuan\t051SFB ua0283", 15000))).horizontal();
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  EXPECT_EQ(record.acceleration.size(), 15000u);
  EXPECT_TRUE(record.dimensionless);
  EXPECT_EQ(record.provenance.station, "051SFB ua0283");
  EXPECT_THAT(record.warnings, Contains(HasSubstr("a target PGA must be chosen")));
  EXPECT_THAT(record.warnings, Contains(HasSubstr("12 May 2008")));
}

TEST(RecShape, WarnsOfTheStepOfTohoku) {
  const Record record = read_record(write_file("t.rec", shape("8.9\t2011\tTohoku \t"))).horizontal();
  EXPECT_THAT(record.warnings, Contains(HasSubstr("0.05 s")));
}

TEST(RecShape, RefusesUnitsAndBadLines) {
  ReadOptions options;
  options.units = "g";
  EXPECT_THAT(input_error([&] { read_record(write_file("t.rec", shape("8\t2\tX\tY")), options); }),
              HasSubstr("no units: the values are normalised"));
  EXPECT_THAT(input_error([] { read_record(write_file("t.rec", shape("8\t2\tX\tY", 3) + "0.03\tnan\r\n")); }),
              HasSubstr("t.rec:6: expected a time and a value, both finite numbers"));
}

TEST(RecShape, RefusesTimesThatDoNotGoOn) {
  std::string bytes = shape("8\t2\tX\tY", 10);
  for (int k = 0; k < 10; ++k) bytes += fmt::format("{:.2E}\t0.1\r\n", 0.01 * k);
  EXPECT_THAT(input_error([&] { read_record(write_file("t.rec", bytes)); }),
              HasSubstr("t.rec:13: expected time 0.1 s"));
  EXPECT_THAT(input_error([] {
                read_record(write_file("t.rec", titles + "8\t2\tX\tY\r\n0.02\t1\r\n0.01\t0.5\r\n0\t0\r\n"));
              }),
              HasSubstr("a positive time step"));
}

}  // namespace
}  // namespace dougong::seismic
