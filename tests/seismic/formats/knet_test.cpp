#include "seismic/formats/knet.h"

#include <gmock/gmock.h>

#include "seismic/measures/peaks.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::input_error;
using ::testing::IsEmpty;
using testing::write_file;

KnetSheet sheet(const std::string& direction, std::size_t seconds = 2) {
  KnetSheet s;
  s.origin_time = s.record_time = "2011/03/11 14:46:00";
  s.latitude = "38.1";
  s.longitude = "142.9";
  s.depth = "24";
  s.magnitude = "9.0";
  s.station_code = "SYN001";
  s.station_latitude = s.station_longitude = "38.0";
  s.station_height = "1";
  s.direction = direction;
  s.scale_gal = 3920;
  s.scale_counts = 6182761;
  for (std::size_t k = 0; k < 100 * seconds; ++k) {
    s.counts.push_back(10190 + std::lround(3000 * std::sin(0.1 * static_cast<double>(k))));
  }
  return s;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(Knet, ScalesCountsAndRemovesTheMean) {
  const auto s = sheet("E-W");
  const Record record = read_record(write_file("A.EW", write_knet(s))).components.at(0);
  ASSERT_EQ(record.acceleration.size(), 200u);
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  EXPECT_EQ(record.component, "EW");
  EXPECT_NEAR(mean(record.acceleration), 0.0, 1e-12);
  const double count = 39.20 / 6182761;
  EXPECT_NEAR(record.acceleration[5] - record.acceleration[0],
              count * static_cast<double>(s.counts[5] - s.counts[0]), 1e-12);
  ASSERT_EQ(record.processing.size(), 1u);
  EXPECT_THAT(record.processing[0], HasSubstr("whole-record mean of"));
  EXPECT_THAT(record.warnings, IsEmpty());  // the header's Max. Acc. is met
}

TEST(Knet, KeepsTheOffsetWhenToldTo) {
  ReadOptions options;
  options.remove_mean = false;
  const Record record = read_record(write_file("A.EW", write_knet(sheet("E-W"))), options).components.at(0);
  EXPECT_CLOSE(record.acceleration[0], 10190 * 39.20 / 6182761, 1e-12);
}

TEST(Knet, FindsTheOtherComponentsBesideTheFile) {
  write_file("A.NS2", write_knet(sheet("4")));
  write_file("A.UD2", write_knet(sheet("6")));
  write_file("A.NS1", write_knet(sheet("1")));  // the borehole is another sensor
  const auto path = write_file("A.EW2", write_knet(sheet("5")));
  const RecordSet set = read_record(path);
  ASSERT_EQ(set.components.size(), 3u);
  EXPECT_EQ(set.horizontal().component, "EW2");
  ASSERT_NE(set.vertical(), nullptr);
  EXPECT_EQ(set.vertical()->component, "UD2");
  ReadOptions options;
  options.component = "NS";
  EXPECT_EQ(read_record(path, options).horizontal().component, "NS2");
  options.siblings = false;
  EXPECT_THAT(input_error([&] { read_record(path, options); }),
              HasSubstr("expected component NS, found EW2"));
}

TEST(Knet, AVerticalFileBringsAHorizontalSister) {
  write_file("A.NS", write_knet(sheet("N-S")));
  const RecordSet set = read_record(write_file("A.UD", write_knet(sheet("U-D"))));
  EXPECT_EQ(set.horizontal().component, "NS");
  EXPECT_EQ(set.vertical()->component, "UD");
  EXPECT_THAT(set.warnings, Contains(HasSubstr("NS drives the horizontal axis")));
}

TEST(Knet, TruncationNamesBothCounts) {
  auto s = sheet("E-W");
  const std::string bytes = replaced(write_knet(s), "Duration Time(s)  2", "Duration Time(s)  3");
  EXPECT_THAT(input_error([&] { read_record(write_file("A.EW", bytes)); }),
              HasSubstr("A.EW:12: expected 300 values, as the header states, found 200"));
}

TEST(Knet, HeaderPeakThatIsNotMetIsAWarning) {
  auto bytes = write_knet(sheet("E-W"));
  const auto at = bytes.find("Max. Acc. (gal)   ");
  bytes[at + 18] = '9';
  EXPECT_THAT(read_record(write_file("A.EW", bytes)).components[0].warnings,
              Contains(HasSubstr("the header states a peak of 0.09")));
}

TEST(Knet, CollectsTheFaultsOfTheHeader) {
  auto bytes = replaced(write_knet(sheet("E-W")), "3920(gal)/6182761", "unknown");
  bytes = replaced(bytes, "100Hz", "fast");
  const std::string text = input_error([&] { read_record(write_file("A.EW", bytes)); });
  EXPECT_THAT(text, HasSubstr("A.EW:11: expected a positive number for \"Sampling Freq\", found \"fast\""));
  EXPECT_THAT(text, HasSubstr("A.EW:14: expected a scale factor such as 3920(gal)/6182761"));
}

TEST(Knet, IsKnownByContentNotByName) {
  const RecordSet set = read_record(write_file("something.at2", write_knet(sheet("N-S"))));
  EXPECT_EQ(set.horizontal().provenance.format, "K-NET/KiK-net ASCII");
  EXPECT_EQ(set.horizontal().provenance.station, "SYN001");
}

TEST(Knet, ComponentsOfUnequalStepsAreRefused) {
  auto other = sheet("N-S");
  other.sampling_frequency = 200;
  write_file("A.NS", write_knet(other));
  const auto path = write_file("A.EW", write_knet(sheet("E-W")));
  EXPECT_THAT(input_error([&] { read_record(path); }), HasSubstr("the time step of its station"));
}

}  // namespace
}  // namespace dougong::seismic
