// Recordings of others, which the project does not hold: skipped where they are absent.
#include <gmock/gmock.h>

#include <numeric>
#include <optional>
#include <vector>

#include "seismic/conditioning/condition.h"
#include "seismic/constants.h"
#include "seismic/describe.h"
#include "seismic/measures/fourier_spectrum.h"
#include "seismic/measures/peaks.h"
#include "seismic/read_record.h"
#include "seismic/units.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::real_record;

// Signed value of the sample with the greatest magnitude.
double signed_peak(const Record& record) {
  return record.acceleration[peak(record.acceleration, record.interval).index];
}

struct Known {
  const char* file;
  std::vector<std::size_t> samples;  // of each channel in the file's order; one number stands for all
  double interval;
  std::vector<double> pga;              // signed; g, counts, or of peak 1 for shapes
  const char* units = nullptr;          // for files that do not say
  std::optional<double> count_scale{};  // m/s2; 1 to compare counts
};

// How ctest names the parameter.
void PrintTo(const Known& known, std::ostream* out) {
  *out << known.file;
}

class RealRecord : public ::testing::TestWithParam<Known> {};

TEST_P(RealRecord, HasItsSamplesStepAndPeak) {
  const Known known = GetParam();
  const auto path = real_record(known.file);
  SKIP_WITHOUT(path);
  ReadOptions options;
  options.siblings = false;
  if (known.units) options.units = known.units;
  options.count_scale = known.count_scale;
  const Channels channels = read_channels(path, options);
  ASSERT_EQ(channels.records.size(), known.pga.size());
  for (std::size_t i = 0; i < channels.records.size(); ++i) {
    const Record& record = channels.records[i];
    EXPECT_EQ(record.acceleration.size(), known.samples[std::min(i, known.samples.size() - 1)]);
    EXPECT_NEAR(record.interval, known.interval, 1e-12 * known.interval);
    const bool as_found = record.dimensionless || known.count_scale == 1.0;
    const double unit = as_found ? 1.0 : standard_gravity;
    const double printed = known.count_scale == 1.0 ? 0.006 : 6e-7;
    EXPECT_NEAR(signed_peak(record) / unit, known.pga[i], printed) << record.component;
    EXPECT_FALSE(record.provenance.format.empty());
    EXPECT_THAT(record.provenance.sha256, ::testing::SizeIs(64));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RealRecord,
    ::testing::Values(
        Known{"peer-at2/elCentro.AT2", {1559}, 0.02, {-0.318820}},
        Known{"peer-at2/A-ELC180.AT2", {4000}, 0.01, {0.130069}},
        Known{"peer-at2/ARL360.at2", {2000}, 0.02, {0.308057}},
        Known{"peer-at2/EIL-EW.AT2", {12000}, 0.005, {0.096668}},
        Known{"peer-at2/RSN1616_DUZCE_362-N.AT2", {4316}, 0.01, {0.044148}},
        Known{"peer-at2/RSN763_LOMAP_GIL067.AT2", {7999}, 0.005, {-0.358533}},
        Known{"kiknet/TKYH121103111446.EW2", {30000}, 0.01, {0.108002}},
        Known{"kiknet/TKYH121103111446.NS2", {30000}, 0.01, {-0.160279}},
        Known{"kiknet/TKYH121103111446.UD2", {30000}, 0.01, {0.066749}},
        Known{"kiknet/NGNH311106302345.EW1", {12000}, 0.01, {-0.000196}},
        Known{"knet/AOM0011801241951.EW", {10200}, 0.01, {0.004158}},
        Known{"knet/AOM0011801241951.NS", {10200}, 0.01, {-0.005052}},
        Known{"knet/AOM0011801241951.UD", {10200}, 0.01, {-0.002284}},
        Known{"csmnc/51BXD_lushan_ua0001.dat", {12000}, 0.005, {-1.025172}},
        Known{"rec/EQKobe.rec", {4000}, 0.01, {-1.0}}, Known{"rec/EQNorth.rec", {4000}, 0.01, {1.0}},
        Known{"rec/EQTohoku.rec", {4001}, 0.01, {-1.0}}, Known{"rec/EQWenchuan.rec", {19500}, 0.01, {1.0}},
        Known{"dyna-asc/20230206011732_3116_mp_Acc_E.asc", {12500}, 0.01, {-0.164977}},
        Known{"dyna-asc/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", {19128}, 0.005, {0.000306}},
        Known{"nsmn/20170720223109_4817.txt", {9156}, 0.01, {-0.080602, 0.059124, -0.032354}},
        Known{"csmip/LA116TH.RAW", {11999, 11998, 11998}, 0.005, {-0.200300, 0.060400, -0.142800}},
        Known{"csmip/CE58667.V2", {7500}, 0.01, {0.027648, 0.011465, -0.026932}},
        Known{"cosmos/NCC031-n.711.v0c", {36200}, 0.005, {65894.22, -51101.26, 29792.03}, nullptr, 1.0},
        Known{"cosmos/us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c", {42000}, 0.005, {-0.006987}},
        Known{"smc/0111a.smc", {6001}, 0.005, {0.106469}},
        Known{"usc/017m30bt.s0a", {1887}, 0.02, {0.247174}},
        Known{"geonet/20180212_211557_WPWS_20.V2A", {5800}, 0.02, {-0.004242, -0.019782, -0.002784}},
        Known{"cwa/2-ECU.dat", {6000}, 0.02, {0.001220, -0.002989, -0.002866}},
        Known{"bhrc/5529-1.V1", {9472}, 0.005, {0.010244, 0.002878, 0.009506}},
        Known{"unam/CUP50401.012", {17502}, 0.004, {0.000479, -0.001212, 0.001240}},
        Known{"plain-text/Northridge.dat", {3989}, 0.01, {0.568300}, "g"},
        Known{"mseed/CI.CLC..HNE.mseed", {39001}, 0.01, {0.343315}},
        Known{"sac/20190706031952.CJ.T001230.HNE.sac", {15001}, 0.02, {0.043384}, "g"},
        Known{"archive/AOM0011801241951.tar.gz", {10200}, 0.01, {0.004158, -0.005052, -0.002284}},
        Known{"archive/ce14196p.zip", {2000}, 0.02, {0.223590, 0.068552, 0.250956}}),
    [](const auto& info) {
      std::string name = info.param.file;
      for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      }
      return name;
    });

// Validation case P11; g = 9.81 there. Six to seven digits are printed.
struct P11 {
  const char* file;
  double pga, pga_time, pgv, arias, cav, d5_95, psa_0_2, psa_1_0;
};

void PrintTo(const P11& row, std::ostream* out) {
  *out << row.file;
}

class RealMeasures : public ::testing::TestWithParam<P11> {};

TEST_P(RealMeasures, MeetP11) {
  const P11 known = GetParam();
  const auto path = real_record(known.file);
  SKIP_WITHOUT(path);
  ReadOptions options;
  options.siblings = false;
  options.gravity = 9.81;
  const RecordInfo info = describe(read_record(path, options).components.at(0), 9.81);
  const double tolerance = 1e-6;
  EXPECT_CLOSE(info.pga, known.pga, tolerance);
  EXPECT_NEAR(info.pga_time, known.pga_time, 1e-9);
  EXPECT_CLOSE(info.pgv, known.pgv, tolerance);
  EXPECT_CLOSE(info.arias, known.arias, tolerance);
  EXPECT_CLOSE(info.cav, known.cav, tolerance);
  EXPECT_CLOSE(info.d5_95, known.d5_95, tolerance);
  EXPECT_CLOSE(info.psa_0_2, known.psa_0_2, tolerance);
  EXPECT_CLOSE(info.psa_1_0, known.psa_1_0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(P11, RealMeasures,
                         ::testing::Values(P11{"peer-at2/elCentro.AT2", 3.127624, 2.02, 0.3615726, 1.801588,
                                               12.61732, 23.84336, 7.774874, 4.45518},
                                           P11{"rec/EQWenchuan.rec", 1, 18.49, 0.1384438, 0.5424638, 14.29284,
                                               89.92552, 3.080847, 0.9536861},
                                           P11{"rec/EQTohoku.rec", 1, 13.85, 0.1049034, 0.3029688, 6.22854,
                                               25.70101, 2.643661, 1.093484},
                                           P11{"kiknet/TKYH121103111446.NS2", 1.571795, 127.36, 0.1255226,
                                               0.8296414, 17.6893, 61.04036, 3.914749, 1.173198}),
                         [](const auto& info) { return std::to_string(info.index); });

// Mean periods that were computed from the same files by another program.
TEST(RealMeanPeriod, IsTheOneFoundElsewhere) {
  struct Known {
    const char* file;
    double period;
  };
  for (const Known& known :
       {Known{"peer-at2/elCentro.AT2", 0.533}, Known{"rec/EQWenchuan.rec", 0.353},
        Known{"kiknet/TKYH121103111446.EW2", 0.458}, Known{"kiknet/TKYH121103111446.NS2", 0.426},
        Known{"kiknet/TKYH121103111446.UD2", 0.352}, Known{"rec/EQTohoku.rec", 0.649}}) {
    const auto path = real_record(known.file);
    SKIP_WITHOUT(path);
    ReadOptions options;
    options.siblings = false;
    const Record record = read_record(path, options).components.at(0);
    EXPECT_NEAR(mean_period(record.acceleration, record.interval), known.period, 0.0011) << known.file;
  }
}

TEST(RealColumns, NorthridgeInGWithItsOwnStep) {
  const auto path = real_record("plain-text/Northridge.dat");
  SKIP_WITHOUT(path);
  ReadOptions options;
  options.units = "g";
  options.interval = 0.01;
  const Record record = read_record(path, options).horizontal();
  EXPECT_EQ(record.acceleration.size(), 3989u);
  EXPECT_DOUBLE_EQ(record.interval, 0.01);
  EXPECT_NEAR(signed_peak(record) / standard_gravity, 0.5683, 1e-9);
}

TEST(RealColumns, CountsOfMyg004WithTheirScale) {
  const auto path = real_record("plain-text/sample-MYG0041103111446.NS.csv");
  SKIP_WITHOUT(path);
  ReadOptions options;
  options.units = "counts";
  options.interval = 0.01;
  options.count_scale = parse_count_scale("3920(gal)/6182761");
  const Record record = read_record(path, options).horizontal();
  EXPECT_EQ(record.acceleration.size(), 30000u);
  EXPECT_EQ(record.component, "NS");
  EXPECT_NEAR(peak(record.acceleration, 0.01).value, 26.99886, 1e-5);
  EXPECT_NEAR(peak(record.acceleration, 0.01).time, 95.60, 1e-9);
  options.remove_mean = false;
  EXPECT_NEAR(peak(read_record(path, options).horizontal().acceleration, 0.01).value, 26.79429, 1e-5);
}

TEST(RealStation, TheThreeComponentsComeTogether) {
  const auto path = real_record("kiknet/TKYH121103111446.EW2");
  SKIP_WITHOUT(path);
  const RecordSet set = read_record(path);
  ASSERT_EQ(set.components.size(), 3u);
  EXPECT_EQ(set.horizontal().component, "EW2");
  EXPECT_NEAR(signed_peak(*set.vertical()) / standard_gravity, 0.066749, 6e-7);
}

TEST(RealShape, IsRefusedWithoutATargetPga) {
  const auto path = real_record("rec/EQWenchuan.rec");
  SKIP_WITHOUT(path);
  const RecordSet set = read_record(path);
  EXPECT_THAT(testing::input_error([&] { condition(set); }), HasSubstr("target PGA"));
  ConditioningOptions options;
  options.target_pga = 5.0;
  EXPECT_NEAR(peak(condition(set, options).horizontal, 0.01).value, 5.0, 1e-12);
}

TEST(RealMotion, EveryConditionedRecordReturnsToRest) {
  for (const char* file :
       {"peer-at2/elCentro.AT2", "peer-at2/ARL360.at2", "peer-at2/RSN763_LOMAP_GIL067.AT2",
        "kiknet/TKYH121103111446.EW2", "knet/AOM0011801241951.EW", "csmnc/51BXD_lushan_ua0001.dat"}) {
    const auto path = real_record(file);
    SKIP_WITHOUT(path);
    const ConditionedMotion motion = condition(read_record(path));
    EXPECT_LT(std::abs(motion.residual_velocity), 1e-5) << file;
    EXPECT_LT(std::abs(motion.residual_displacement), 1e-4) << file;
    EXPECT_THAT(motion.warnings, ::testing::Not(Contains(HasSubstr("does not return")))) << file;
  }
}

}  // namespace
}  // namespace dougong::seismic
