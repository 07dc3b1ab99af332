#include "seismic/formats/peer_at2.h"

#include <gmock/gmock.h>

#include "seismic/formats/format.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;
using ::testing::IsEmpty;
using testing::write_file;

std::string at2(const std::string& npts_line, const std::string& data) {
  return "PEER NGA STRONG MOTION DATABASE RECORD\nLoma Prieta, 10/18/1989, Gilroy - Gavilan Coll., 67\n"
         "ACCELERATION TIME SERIES IN UNITS OF G\n" +
         npts_line + "\n" + data;
}

const std::string six_values = "   .1000000E+00  -.2000000E+00   .3000000E-02   0.0   -.0\n  1.0\n";

Record read(const std::string& bytes, const ReadOptions& options = {}) {
  return read_record(write_file("a.at2", bytes), options).components.at(0);
}

TEST(PeerAt2, ReadsAllNptsSpellings) {
  for (const char* line :
       {"NPTS=  6, DT= .01000 SEC", "NPTS=  6, dt=  .01000", "NPTS=   6, DT=   .0100 SEC,      ",
        "NPTS=   6, DT=   .0100 SEC   ", "npts=6,dt=0.01",
        "NPTS=   6, DT=   .0100 SEC,  -5 POLE @      .06000 HZ,   0 POLE @      .00000",
        "6    0.0100    NPTS, DT", "DT= 0.01 SEC, NPTS= 6"}) {
    const Record record = read(at2(line, six_values));
    ASSERT_EQ(record.acceleration.size(), 6u) << line;
    EXPECT_DOUBLE_EQ(record.interval, 0.01) << line;
    EXPECT_DOUBLE_EQ(record.acceleration[1], -0.2 * standard_gravity) << line;
    EXPECT_DOUBLE_EQ(record.acceleration[2], 0.003 * standard_gravity) << line;
  }
}

TEST(PeerAt2, ReadsTheProseHeader) {
  const std::string bytes =
      "Data for El Centro 1940\n6 points at equal spacing of 0.02 sec\nThe units are (g)\n*** Begin data "
      "***\n" +
      six_values + "*** End Data ***\n";
  const Record record = read(bytes);
  EXPECT_EQ(record.acceleration.size(), 6u);
  EXPECT_DOUBLE_EQ(record.interval, 0.02);
  EXPECT_EQ(record.component, "a");  // nothing but the file's name says it
}

TEST(PeerAt2, ReadsEveryLineEndAndNoLastOne) {
  const std::string plain = at2("NPTS= 6, DT= .01 SEC", six_values);
  for (const std::string end : {"\r\n", "\r\r\n"}) {
    std::string bytes;
    for (const char c : plain) bytes += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(read(bytes).acceleration, read(plain).acceleration);
  }
  EXPECT_EQ(read(plain.substr(0, plain.size() - 1)).acceleration, read(plain).acceleration);
  EXPECT_EQ(read(plain + "\n  \n").acceleration, read(plain).acceleration);
}

TEST(PeerAt2, KnowsWhereItComesFrom) {
  const Record record = read(at2("NPTS= 6, DT= .01 SEC", six_values));
  EXPECT_EQ(record.provenance.event, "Loma Prieta 10/18/1989");
  EXPECT_EQ(record.provenance.station, "Gilroy - Gavilan Coll.");
  EXPECT_EQ(record.component, "67");
  EXPECT_EQ(record.axis, Axis::horizontal);
  EXPECT_EQ(record.provenance.units, "g");
  EXPECT_EQ(record.provenance.format, "PEER AT2");
  EXPECT_EQ(record.provenance.sha256.size(), 64u);
  EXPECT_THAT(record.warnings, IsEmpty());
}

TEST(PeerAt2, TellsADateFromAStation) {
  const auto titled = [](const std::string& title) {
    return read("PEER\n" + title + "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 6, DT= .01 SEC\n" +
                six_values)
        .provenance;
  };
  EXPECT_EQ(titled("AQABA 11/22/95 0616, EILAT, EW").event, "AQABA 11/22/95 0616");
  EXPECT_EQ(titled("AQABA 11/22/95 0616, EILAT, EW").station, "EILAT");
  EXPECT_EQ(titled("Made, undated, SYN001, EW").event, "Made");
  EXPECT_EQ(titled("Made, undated, SYN001, EW").station, "SYN001");
  EXPECT_EQ(titled("Duzce, 1999-11-12, Lamont 362, Yard, N").event, "Duzce 1999-11-12");
  EXPECT_EQ(titled("Duzce, 1999-11-12, Lamont 362, Yard, N").station, "Lamont 362, Yard");
  EXPECT_EQ(titled("Kobe, KJMA 12-A, 90").station, "KJMA 12-A");
}

TEST(PeerAt2, ChecksThePeakThatSomeFilesState) {
  const std::string stated = "ACCELERATION TIME HISTORY IN UNITS OF G. PGA= ";
  const auto with = [&](const std::string& peak) {
    return read("PEER\nE, d, s, 67\n" + stated + peak + " G, PGV= 3.1\nNPTS= 6, DT= .01 SEC\n" + six_values);
  };
  EXPECT_THAT(with("1.0").warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(*with("1.0").provenance.stated_peak, standard_gravity);
  EXPECT_THAT(with(".48431").warnings, ::testing::Contains(HasSubstr("the header states a peak of 4.7494")));
}

TEST(PeerAt2, TooFewValuesIsAnErrorThatNamesBothCounts) {
  const std::string text = input_error([] { read(at2("NPTS= 8, DT= .01 SEC", six_values)); });
  EXPECT_THAT(text, HasSubstr("a.at2:4: expected 8 values, as the header states, found 6"));
}

TEST(PeerAt2, TooManyValuesIsAWarning) {
  const Record record = read(at2("NPTS= 4, DT= .01 SEC", six_values));
  EXPECT_EQ(record.acceleration.size(), 4u);
  ASSERT_EQ(record.warnings.size(), 1u);
  EXPECT_THAT(record.warnings[0], HasSubstr("states 4 values, the file holds 6"));
}

TEST(PeerAt2, RefusesVelocityAndDisplacementWithTheReason) {
  for (const char* line :
       {"VELOCITY TIME SERIES IN UNITS OF CM/S", "DISPLACEMENT TIME SERIES IN UNITS OF CM"}) {
    const std::string bytes =
        std::string("PEER\nE, d, s, 67\n") + line + "\nNPTS= 6, DT= .01 SEC\n" + six_values;
    const std::string text = input_error([&] { read(bytes); });
    EXPECT_THAT(text, HasSubstr(":3: expected an acceleration in g"));
    EXPECT_THAT(text, HasSubstr(".VT2 or .DT2"));
  }
}

TEST(PeerAt2, CollectsEveryBadFieldWithItsLine) {
  const std::string text =
      input_error([] { read(at2("NPTS= 6, DT= .01 SEC", "0.1 nan 0.2\n0.3 x.5 0.4\n")); });
  EXPECT_THAT(text, HasSubstr("a.at2:5: expected finite numbers, found \"nan\""));
  EXPECT_THAT(text, HasSubstr("a.at2:6: expected finite numbers, found \"x.5\""));
}

TEST(PeerAt2, RefusesOneSampleAndBadSteps) {
  EXPECT_THAT(input_error([] { read(at2("NPTS= 1, DT= .01 SEC", "0.5\n")); }),
              HasSubstr("at least 2 samples, found one"));
  EXPECT_THAT(input_error([] { read(at2("NPTS= 0, DT= .01 SEC", "")); }),
              HasSubstr("at least 2 samples, found none"));
  EXPECT_THAT(input_error([] { read(at2("NPTS= 6, DT= 0.0 SEC", six_values)); }),
              HasSubstr("a positive time step"));
  EXPECT_THAT(input_error([] { read(at2("NPTS= 6, DT= -.01 SEC", six_values)); }),
              HasSubstr("a positive time step"));
}

TEST(PeerAt2, SurvivesADamagedHeader) {
  EXPECT_THAT(input_error([] { read(at2("NPTS= 99999999999999999999999, DT= .01 SEC", six_values)); }),
              HasSubstr("found 6 (the file is truncated)"));
  EXPECT_THAT(input_error([] { read(at2("NPTS= 6, DT= 1.0E-9 SEC", six_values)); }),
              HasSubstr("a time step from 1e-05 s to 10 s, found 1e-09 s"));
  const std::string long_line(1000000, 'u');
  EXPECT_THAT(
      input_error([&] { read("PEER\nE, d, s, 1\n" + long_line + "\nNPTS= 6, DT= .01\n" + six_values); }),
      HasSubstr("IN UNITS OF G"));
}

TEST(PeerAt2, RefusesUnitsAndStepsThatContradictTheFile) {
  ReadOptions options;
  options.units = "gal";
  options.interval = 0.02;
  const std::string text = input_error([&] { read(at2("NPTS= 6, DT= .01 SEC", six_values), options); });
  EXPECT_THAT(text, HasSubstr("the file's own units, g"));
  EXPECT_THAT(text, HasSubstr("expected the time step given, 0.02 s (option dt), found 0.01 s"));
}

TEST(PeerAt2, WritesWhatItReads) {
  PeerAt2Sheet sheet{"T", "Event", "date", "Station", "EW", 0.005, {}};
  for (int k = 0; k < 13; ++k) sheet.acceleration.push_back(std::sin(k) * 3.0);
  const Record record = read(write_peer_at2(sheet));
  EXPECT_EQ(record.component, "EW");
  EXPECT_DOUBLE_EQ(record.interval, 0.005);
  ASSERT_EQ(record.acceleration.size(), 13u);
  for (std::size_t k = 0; k < 13; ++k) EXPECT_NEAR(record.acceleration[k], sheet.acceleration[k], 2e-6);
}

}  // namespace
}  // namespace dougong::seismic
