// What is peculiar to one format, on generated files.
#include <gmock/gmock.h>

#include "seismic/formats/miniseed.h"
#include "seismic/read_record.h"
#include "tests/seismic/generated_files.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::Contains;
using testing::GeneratedFile;
using ::testing::HasSubstr;
using testing::input_error;
using testing::write_file;

std::vector<Record> read(const std::string& bytes, const ReadOptions& options = {}) {
  return read_bytes_as_record("a.file", bytes, options);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(Dyna, PartsAtTheFirstColonAndKnowsWhereItStood) {
  const Record record = read(testing::dyna_file().bytes).front();
  const Provenance& from = record.provenance;
  EXPECT_EQ(from.event, "MADE: twice 20190728, ML 4.6");
  EXPECT_EQ(from.station, "HI.ARS1");
  EXPECT_EQ(from.start_time, "2019-07-28T16:09:19.870Z");
  EXPECT_TRUE(from.processed);
  EXPECT_THAT(from.treatment, HasSubstr("BUTTERWORTH filter of order 2, 0.1 to 30 Hz"));
  EXPECT_DOUBLE_EQ(from.station_place->latitude, 37.6349);
  EXPECT_DOUBLE_EQ(*from.hypocentre->height, -9000.0);
  EXPECT_DOUBLE_EQ(*record.azimuth, 90.0);
  EXPECT_THAT(record.warnings, ::testing::IsEmpty());
}

TEST(Dyna, RefusesVelocityAndAPeakThatIsNotMetIsSaid) {
  const std::string bytes = testing::dyna_file().bytes;
  EXPECT_THAT(input_error([&] { read(replaced(bytes, "DATA_TYPE: ACCELERATION", "DATA_TYPE: VELOCITY")); }),
              HasSubstr("expected an acceleration, found \"VELOCITY\""));
  EXPECT_THAT(read(replaced(bytes, "PGA_CM/S^2: 100", "PGA_CM/S^2: 200")).front().warnings,
              Contains(HasSubstr("the header states a peak of 2 m/s2, the samples peak at 1 m/s2")));
}

TEST(Dyna, FindsTheOtherComponentsBesideIt) {
  const std::string bytes = testing::dyna_file().bytes;
  write_file("HI.ARS1..HNN.D.ACC.ASC", replaced(bytes, "STREAM: HNE", "STREAM: HNN"));
  write_file("HI.ARS1..HNZ.D.ACC.ASC", replaced(bytes, "STREAM: HNE", "STREAM: HNZ"));
  const RecordSet set = read_record(write_file("HI.ARS1..HNE.D.ACC.ASC", bytes));
  EXPECT_EQ(set.components.size(), 3u);
  EXPECT_EQ(set.horizontal().component, "HNE");
  EXPECT_EQ(set.vertical()->component, "HNZ");
}

TEST(Nsmn, SurvivesNamesInTurkishAndReadsItsPlaces) {
  const Record record = read(testing::nsmn_file().bytes).front();
  EXPECT_DOUBLE_EQ(record.provenance.station_place->latitude, 37.2401);
  EXPECT_DOUBLE_EQ(record.provenance.station_place->longitude, 27.6031);
  EXPECT_EQ(record.provenance.start_time, "2017-07-20T22:30:59.000Z");
}

TEST(Volumes, ReadTheirHeaders) {
  const Record film = read(testing::csmip_v1_file().bytes).front();
  EXPECT_EQ(film.provenance.station, "14403");
  EXPECT_DOUBLE_EQ(film.provenance.station_place->longitude, -118.26);
  EXPECT_EQ(film.provenance.start_time, "1994-01-17T12:31:04.100Z");
  EXPECT_FALSE(film.provenance.processed);
  const Record corrected = read(testing::csmip_v2_file().bytes).front();
  EXPECT_TRUE(corrected.provenance.processed);
  EXPECT_THAT(corrected.provenance.treatment, HasSubstr("bandpass filtered"));
  EXPECT_DOUBLE_EQ(*corrected.azimuth, 90.0);
  const Record usc = read(testing::usc_v2_file().bytes).front();
  EXPECT_EQ(usc.provenance.station, "0061");
  EXPECT_NEAR(usc.provenance.station_place->latitude, 34.2864, 1e-4);
  const auto iran = read(testing::bhrc_file().bytes);
  EXPECT_DOUBLE_EQ(*iran[0].azimuth, 106.0);
  EXPECT_DOUBLE_EQ(*iran[2].azimuth, 196.0);
  EXPECT_EQ(iran[1].axis, Axis::vertical);
  EXPECT_EQ(read(testing::renadic_file().bytes).front().provenance.start_time, "2010-02-27T06:35:46.000Z");
}

TEST(Volumes, ReadUncorrectedDataOfDigitalRecorders) {
  std::string bytes = testing::csmip_v2_file().bytes;
  for (int channel = 0; channel < 2; ++channel)
    bytes = replaced(bytes, "Corrected accelerogram  ", "Uncorrected Accelerogram Data ");
  const auto records = read(bytes);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].provenance.format, "CSMIP V1");
  EXPECT_FALSE(records[0].provenance.processed);
  EXPECT_NEAR(records[1].acceleration[5], 1.0, 1e-8);
}

TEST(Volumes, TheSignOfAStatedPeakIsNotReliable) {
  EXPECT_THAT(read(testing::usc_v2_file().bytes).front().warnings, ::testing::IsEmpty());
}

TEST(Volumes, RefuseTimesThatGoBackAndSpectra) {
  EXPECT_THAT(input_error([] { read(replaced(testing::usc_v1_file().bytes, "0.200", "0.100")); }),
              HasSubstr("times that increase"));
  EXPECT_THAT(input_error([] { read("RESPONSE AND FOURIER AMPLITUDE SPECTRA\n1 2 3\n"); }),
              HasSubstr("expected an acceleration, found response spectra"));
}

TEST(Cosmos, TakesItsStepFromReal62AndSaysThatReal34Differs) {
  const Record record = read(testing::cosmos_v2_file().bytes).front();
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  EXPECT_THAT(record.warnings, Contains(HasSubstr("0.02 s between raw samples (real 34) and 0.01 s")));
  EXPECT_EQ(record.provenance.station, "AK.BMR");
  EXPECT_EQ(record.provenance.start_time, "2018-11-30T17:29:39.137Z");
  EXPECT_DOUBLE_EQ(*record.provenance.station_place->height, 842.0);
}

TEST(Cosmos, ObeysTheFormatItStates) {
  const std::string bytes = testing::cosmos_v1_file().bytes;
  EXPECT_THAT(input_error([&] { read(replaced(bytes, "(8f9.6)", "(8f8.6)")); }),
              HasSubstr("in fields 8 wide"));
  EXPECT_THAT(input_error([&] { read(replaced(bytes, "g (02)", "g (99)")); }), HasSubstr("found code 99"));
  EXPECT_THAT(input_error([&] { read(replaced(bytes, "acceleration pts", "velocity pts")); }),
              HasSubstr("expected an acceleration"));
}

TEST(Cosmos, CountsNeedAScale) {
  EXPECT_THAT(input_error([] { read(testing::cosmos_v0_file().bytes); }), HasSubstr("option scale"));
}

TEST(Smc, ResamplesUnevenPairsAndSaysSo) {
  const GeneratedFile file = testing::smc_pairs_file(false);
  const Record record = read(file.bytes).front();
  EXPECT_DOUBLE_EQ(record.interval, 0.005);
  EXPECT_EQ(record.acceleration.size(), 202u);
  EXPECT_THAT(record.processing, Contains(HasSubstr("101 samples 0.005 to 0.015 s apart resampled to 202")));
  EXPECT_NEAR(record.acceleration[6], testing::sample(3), 1e-4);
}

TEST(Smc, RefusesVelocityAndKnowsItsTime) {
  const std::string bytes = testing::smc_file(2).bytes;
  EXPECT_THAT(input_error([&] { read(replaced(bytes, "2 CORRECTED", "3 VELOCITY")); }),
              HasSubstr("type 0, 1 or 2"));
  const Provenance from = read(bytes).front().provenance;
  EXPECT_EQ(from.start_time, "1989-10-18T00:04:00.000Z");
  EXPECT_EQ(from.station, "San Francisco, 1295 Shafter, F");
}

TEST(Geonet, LiesInTheSouth) {
  const Record record = read(testing::geonet_v2_file().bytes).front();
  EXPECT_NEAR(record.provenance.station_place->latitude, -39.944, 1e-9);
  EXPECT_EQ(record.provenance.start_time, "2018-02-12T21:15:17.000Z");
  EXPECT_DOUBLE_EQ(*record.azimuth, 196.0);
}

TEST(Unam, KeepsRowsBeyondTheStatedCountAndSaysSo) {
  const Record record = read(testing::unam_file().bytes).front();
  EXPECT_THAT(record.warnings, Contains(HasSubstr("states 99 values, the file holds 101: all are kept")));
  EXPECT_THAT(input_error([] { read(replaced(testing::unam_file().bytes, "/99/99/99", "/102/102/102")); }),
              HasSubstr("expected 102 values, as the header states, found 101"));
}

TEST(Cwa, RefusesARateThatItsTimesContradict) {
  EXPECT_THAT(input_error([] { read(replaced(testing::cwa_file().bytes, "(Hz): 100", "(Hz): 50")); }),
              HasSubstr("by the sample rate"));
}

TEST(KnetCsv, NamesTheSixSensorsOfKikNet) {
  const auto path = write_file("FKS005.csv", testing::kiknet_csv_file().bytes);
  EXPECT_THAT(input_error([&] { read_record(path); }),
              HasSubstr("found FKS005.1 (NS1, EW1, UD1), FKS005.2 (NS2, EW2, UD2)"));
  ReadOptions options;
  options.station = "FKS005.2";
  EXPECT_EQ(read_record(path, options).horizontal().component, "NS2");
  options = {};
  options.component = "EW1";
  const RecordSet set = read_record(path, options);
  EXPECT_EQ(set.horizontal().component, "EW1");
  EXPECT_EQ(set.vertical()->component, "UD1");
  EXPECT_EQ(set.horizontal().provenance.start_time, "2019-01-02T17:47:27.000+09:00");
}

TEST(Knet, BeginsBeforeItsTriggerAndReadsTheEnglishLabels) {
  const Record record = read(testing::knet_file().bytes).front();
  EXPECT_EQ(record.provenance.start_time, "2018-01-24T19:51:28.000+09:00");
  EXPECT_DOUBLE_EQ(record.provenance.station_place->longitude, 140.9244);
  EXPECT_DOUBLE_EQ(*record.provenance.hypocentre->height, -30000.0);
  std::string other = replaced(testing::knet_file().bytes, "Max. Acc. (gal)   ", "Max Acc. (gal)    ");
  other = replaced(other, "Long.             ", "Lon.              ");
  EXPECT_EQ(read(other).front().acceleration, record.acceleration);
}

TEST(Sac, ReadsBothByteOrdersAlike) {
  const GeneratedFile little = testing::sac_file(false), big = testing::sac_file(true);
  const Record a = read(little.bytes, little.options).front(), b = read(big.bytes, big.options).front();
  EXPECT_EQ(a.acceleration, b.acceleration);
  EXPECT_EQ(a.provenance.station, "CJ.T001230");
  EXPECT_EQ(b.provenance.start_time, "2019-07-06T03:19:52.750Z");
  EXPECT_DOUBLE_EQ(*b.azimuth, 90.0);
}

TEST(Sac, RefusesUnevenSeriesAndNan) {
  GeneratedFile file = testing::sac_file(false);
  std::string uneven = file.bytes, broken = file.bytes;
  uneven[280 + 4 * 35] = 0;
  EXPECT_THAT(input_error([&] { read(uneven, file.options); }), HasSubstr("LEVEN 0"));
  broken.replace(632 + 4 * 7, 4, "\xff\xff\xff\x7f");
  EXPECT_THAT(input_error([&] { read(broken, file.options); }), HasSubstr("as sample 8"));
}

std::string station_xml(const char* units, const char* channel = "HNE") {
  return std::string(
             "<?xml version='1.0'?><FDSNStationXML><Network code='CI'><Station code='CLC'>"
             "<Channel code='") +
         channel +
         "' locationCode='' startDate='2012-04-13T17:28:00' endDate='3000-01-01T00:00:00'>"
         "<Latitude>35.8</Latitude><Longitude>-117.6</Longitude><Elevation>775</Elevation><Azimuth>90.0</"
         "Azimuth>"
         "<Response><InstrumentSensitivity><Value>2000.0</Value><InputUnits><Name>" +
         units +
         "</Name></InputUnits></InstrumentSensitivity></Response></Channel></Station></Network></"
         "FDSNStationXML>";
}

std::string one_channel(double gap = 0.0) {
  const MiniseedChannel first{
      "CI", "CLC", "", "HNE", "2019-07-06T03:19:23", 0.01, std::vector<double>(200, 4.0)};
  MiniseedChannel second = first;
  second.start_time = "2019-07-06T03:20:23";
  const MiniseedChannel both[] = {first, second};
  return write_miniseed(std::span(both).first(gap > 0.0 ? 2 : 1));
}

TEST(Miniseed, CountsTakeTheirSensitivityFromStationXml) {
  ReadOptions options;
  options.remove_mean = false;
  options.response = write_file("r.xml", station_xml("M/S**2"));
  const Record record = read(one_channel(), options).front();
  EXPECT_DOUBLE_EQ(record.acceleration[7], 4.0 / 2000.0);
  EXPECT_THAT(record.provenance.scale, HasSubstr("1 / 2000 m/s2 a count, the overall sensitivity in r.xml"));
  EXPECT_DOUBLE_EQ(record.provenance.station_place->latitude, 35.8);
  options.response = write_file("cm.xml", station_xml("CM/S**2"));
  EXPECT_DOUBLE_EQ(read(one_channel(), options).front().acceleration[7], 4.0 / 200000.0);
}

TEST(Miniseed, FindsStationXmlBesideIt) {
  write_file("CI.CLC.xml", station_xml("M/S**2"));
  ReadOptions options;
  options.remove_mean = false;
  const auto path = write_file("a.mseed", one_channel());
  EXPECT_DOUBLE_EQ(read_record(path, options).horizontal().acceleration[7], 4.0 / 2000.0);
  options.count_scale = 3.0;
  EXPECT_DOUBLE_EQ(read_record(path, options).horizontal().acceleration[7], 12.0);
}

TEST(Miniseed, RefusesResponsesThatDoNotFit) {
  ReadOptions options;
  const auto refusal = [&](const std::string& xml) {
    options.response = write_file("r.xml", xml);
    return input_error([&] { read(one_channel(), options); });
  };
  EXPECT_THAT(refusal(station_xml("M/S")), HasSubstr("to an acceleration, found \"M/S\""));
  EXPECT_THAT(refusal(station_xml("M/S**2", "HNN")), HasSubstr("expected channel CI.CLC..HNE at 2019-07-06"));
  EXPECT_THAT(refusal("<FDSN"), HasSubstr("expected StationXML"));
}

TEST(Miniseed, RefusesGapsAndDamage) {
  ReadOptions options;
  options.units = "m/s2";
  EXPECT_THAT(input_error([&] { read(one_channel(1.0), options); }),
              HasSubstr("expected one stretch of samples of CI_CLC__HNE, found a gap or overlap after "
                        "2019-07-06T03:19:24.990Z"));
  EXPECT_THAT(input_error([&] { read(one_channel().substr(0, 3000), options); }), HasSubstr("a cut one"));
}

}  // namespace
}  // namespace dougong::seismic
