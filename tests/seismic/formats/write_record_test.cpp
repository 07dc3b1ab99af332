#include "seismic/formats/write_record.h"

#include <gmock/gmock.h>

#include "seismic/formats/miniseed.h"
#include "seismic/measures/peaks.h"
#include "seismic/read_record.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;

std::vector<Record> station(double interval = 0.005) {
  std::vector<Record> components;
  for (const auto& [name, azimuth] : {std::pair{"N-S", 0.0}, {"E-W", 90.0}, {"U-D", -1.0}}) {
    Record record;
    record.acceleration = testing::Syn(7, 3.0).samples(interval, 20.0);
    // Shapes that differ between components and hold an offset.
    for (double& a : record.acceleration) a = a * (1.0 + azimuth / 500.0) + 0.01;
    record.interval = interval;
    record.component = name;
    record.axis = axis_of(name);
    if (azimuth >= 0.0) record.azimuth = azimuth;
    record.provenance.event = "Made, M 7";
    record.provenance.station = "TK.3116";
    record.provenance.start_time = "2023-02-06T01:17:30.250Z";
    record.provenance.station_place = Place{36.6, -71.2, 33.0};
    components.push_back(record);
  }
  return components;
}

struct RoundTrip {
  const char* format;
  double relative, of_peak;  // tolerance: of the sample, and of the record's peak
  bool without_mean = false;
  const char* units = nullptr;
};

void PrintTo(const RoundTrip& trip, std::ostream* out) {
  *out << trip.format;
}

// A reader may order the components of a file.
const Record& same_direction(const std::vector<Record>& components, const Record& record) {
  for (const Record& own : components)
    if (own.axis == record.axis && own.azimuth == record.azimuth) return own;
  ADD_FAILURE() << record.component << " was not written";
  return components.front();
}

class Written : public ::testing::TestWithParam<RoundTrip> {};

TEST_P(Written, FilesReadBackWithinTheirPrecision) {
  const RoundTrip trip = GetParam();
  const auto components = station();
  ReadOptions options;
  if (trip.units) options.units = trip.units;
  std::size_t at = 0;
  for (const WrittenFile& file : write_records(components, *written_format(trip.format))) {
    for (const Record& record : read_bytes_as_record("a" + file.suffix, file.bytes, options)) {
      const Record& own = same_direction(components, record);
      ++at;
      ASSERT_EQ(record.acceleration.size(), own.acceleration.size());
      EXPECT_NEAR(record.interval, own.interval, 1e-12);
      EXPECT_EQ(record.axis, own.axis);
      const double offset = trip.without_mean ? mean(own.acceleration) : 0.0;
      const double top = peak(own.acceleration, own.interval).value;
      for (std::size_t k = 0; k < own.acceleration.size(); ++k)
        ASSERT_NEAR(record.acceleration[k], own.acceleration[k] - offset,
                    trip.relative * std::abs(own.acceleration[k]) + trip.of_peak * top);
    }
  }
  EXPECT_EQ(at, components.size());
}

// As write_record.h states them.
INSTANTIATE_TEST_SUITE_P(Formats, Written,
                         ::testing::Values(RoundTrip{"at2", 5.1e-8, 0.0},
                                           RoundTrip{"knet", 0.0, 1.3e-7, true},
                                           RoundTrip{"csmnc", 5.1e-7, 0.0}, RoundTrip{"csv", 0.0, 0.0},
                                           RoundTrip{"miniseed", 0.0, 0.0, false, "m/s2"}),
                         [](const auto& info) { return std::string(info.param.format); });

TEST(WrittenFile, KeepsTimeAndPlaceWhereTheFormatCan) {
  for (const char* format : {"knet", "csv", "miniseed"}) {
    ReadOptions options;
    if (std::string(format) == "miniseed") options.units = "m/s2";
    const auto file = write_records(station(), *written_format(format)).front();
    const Record record = read_bytes_as_record("a", file.bytes, options).front();
    // K-NET keeps whole seconds.
    EXPECT_THAT(record.provenance.start_time,
                HasSubstr(std::string(format) == "knet" ? "10:17:30" : "01:17:30.250"))
        << format;
  }
  const auto knet = write_records(station(), WrittenFormat::knet).front();
  EXPECT_NEAR(read_bytes_as_record("a", knet.bytes).front().provenance.station_place->longitude, -71.2, 1e-4);
}

TEST(WrittenFile, KeepsAnUncommonStepInAt2) {
  const auto file = write_records(station(1.0 / 256.0), WrittenFormat::at2).front();
  EXPECT_EQ(read_bytes_as_record("a", file.bytes).front().interval, 1.0 / 256.0);
}

TEST(WrittenFile, NamesFilesByComponent) {
  std::vector<std::string> suffixes;
  for (const char* format : {"at2", "knet", "csmnc", "csv", "miniseed"})
    for (const WrittenFile& file : write_records(station(), *written_format(format)))
      suffixes.push_back(file.suffix);
  EXPECT_THAT(suffixes, ::testing::ElementsAre("-N_S.AT2", "-E_W.AT2", "-U_D.AT2", ".NS", ".EW", ".UD",
                                               "-N_S.dat", "-E_W.dat", "-U_D.dat", ".csv", ".mseed"));
}

TEST(WrittenFile, HasNoNegativeZeroInCsv) {
  auto components = station();
  components[0].acceleration[0] = -0.0;
  const std::string bytes = write_records(components, WrittenFormat::csv).front().bytes;
  EXPECT_EQ(bytes.find(",-0,"), std::string::npos);
  EXPECT_EQ(bytes.find(",-0\n"), std::string::npos);
  EXPECT_NE(bytes.find("\n0,0,"), std::string::npos);
}

TEST(WrittenFile, RefusesWhatAFormatCannotHold) {
  auto components = station();
  components[0].azimuth = 30.0;
  EXPECT_THAT(input_error([&] { write_records(components, WrittenFormat::knet); }),
              HasSubstr("north, east and up"));
  EXPECT_THAT(input_error([] { write_records(station(1.0 / 33.3), WrittenFormat::knet); }),
              HasSubstr("33.3 Hz"));
  components[1].dimensionless = true;
  for (const char* format : {"at2", "knet", "csmnc", "csv", "miniseed"})
    EXPECT_THAT(input_error([&] { write_records(components, *written_format(format)); }),
                HasSubstr("option pga"));
  EXPECT_FALSE(written_format("sac"));
}

}  // namespace
}  // namespace dougong::seismic
