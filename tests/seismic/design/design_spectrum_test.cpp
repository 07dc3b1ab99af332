#include <gmock/gmock.h>

#include <array>

#include "seismic/constants.h"
#include "seismic/design/asce7.h"
#include "seismic/design/eurocode8.h"
#include "seismic/design/gb50011.h"
#include "seismic/design/japan.h"
#include "seismic/design/spectrum_table.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;

struct P08 {
  double period, gb, ec8_1, ec8_2, asce7;  // 0: beyond the code
};
constexpr std::array<P08, 18> p08 = {{
    {0, 0.072, 1.15, 1.5, 0.4},
    {0.03, 0.0984, 1.40875, 2.175, 0.55},
    {0.05, 0.116, 1.58125, 2.625, 0.65},
    {0.1, 0.16, 2.0125, 3.75, 0.9},
    {0.15, 0.16, 2.44375, 3.75, 1},
    {0.2, 0.16, 2.875, 3.75, 1},
    {0.3, 0.16, 2.875, 3.125, 1},
    {0.4, 0.16, 2.875, 2.34375, 1},
    {0.5, 0.13088834, 2.875, 1.875, 1},
    {0.7, 0.09669093, 2.4642857, 1.3392857, 0.85714286},
    {1, 0.070141326, 1.725, 0.9375, 0.6},
    {1.5, 0.048695838, 1.15, 0.5, 0.4},
    {2, 0.037587806, 0.8625, 0.28125, 0.3},
    {2.5, 0.035987806, 0.552, 0.18, 0.24},
    {3, 0.034387806, 0.38333333, 0.125, 0.2},
    {4, 0.031187806, 0.215625, 0.0703125, 0.15},
    {5, 0.027987806, 0, 0, 0.12},
    {6, 0.024787806, 0, 0, 0.1},
}};

TEST(DesignSpectra, MeetP08) {
  constexpr double printed = 5e-8;
  const Eurocode8 type_1 = eurocode8(1, "C", 1.0), type_2 = eurocode8(2, "C", 1.0);
  for (const P08& row : p08) {
    EXPECT_CLOSE(influence_coefficient({0.16, 0.40, 0.05}, row.period), row.gb, printed) << row.period;
    EXPECT_CLOSE(design_acceleration({1.0, 0.6, 8.0}, row.period), row.asce7, printed) << row.period;
    if (row.ec8_1 == 0) continue;
    EXPECT_CLOSE(elastic_spectrum(type_1, row.period), row.ec8_1, printed) << row.period;
    EXPECT_CLOSE(elastic_spectrum(type_2, row.period), row.ec8_2, printed) << row.period;
  }
}

// Rare earthquake, alpha_max 0.90, Tg 0.45 s, other dampings.
TEST(Gb50011, MeetsTheCheckValuesOfOtherDampings) {
  constexpr std::array<double, 9> periods = {0, .05, .1, .3, .45, 1, 2, 3, 6};
  struct Row {
    double damping;
    std::array<double, 9> alpha;
  };
  for (const Row& row :
       {Row{.02, {.405, .773036, 1.141071, 1.141071, 1.141071, .525332, .26792, .221089, .149632}},
        Row{.05, {.405, .6525, .9, .9, .9, .438666, .235075, .197931, .143931}},
        Row{.10, {.405, .55875, .7125, .7125, .7125, .36303, .20218, .174226, .138976}},
        Row{.20, {.405, .48375, .5625, .5625, .5625, .296956, .170557, .151455, .136397}}}) {
    for (std::size_t i = 0; i < periods.size(); ++i)
      EXPECT_NEAR(influence_coefficient({0.9, 0.45, row.damping}, periods[i]), row.alpha[i], 1e-6)
          << row.damping << " " << periods[i];
  }
}

TEST(Gb50011, TakesItsTablesByIntensityLevelSiteAndGroup) {
  const Gb50011 rare = gb50011({"8", "rare", "II", 2, 0.05});
  EXPECT_EQ(rare.alpha_max, 0.90);
  EXPECT_NEAR(rare.characteristic_period, 0.45, 1e-15);
  EXPECT_EQ(gb50011({"7.5", "design", "III", 1, 0.02}).alpha_max, 0.34);
  EXPECT_EQ(gb50011({"9", "frequent", "IV", 3, 0.05}).characteristic_period, 0.90);
  EXPECT_THAT(input_error([] { gb50011({"10", "rare", "II", 1, 0.05}); }), HasSubstr("found \"10\""));
  EXPECT_THAT(input_error([] { gb50011({"8", "rare", "II", 4, 0.05}); }), HasSubstr("from 1 to 3"));
  EXPECT_THAT(input_error([] { design_spectrum(Gb50011{}).at(6.5); }), HasSubstr("0 s to 6 s"));
}

TEST(Eurocode8, MeetsTheVerticalCheckValues) {
  constexpr std::array<std::array<double, 2>, 6> rows = {
      {{0, .9}, {.02, 1.62}, {.1, 2.7}, {.5, .81}, {1, .405}, {2, .10125}}};
  for (const auto& [period, value] : rows)
    EXPECT_CLOSE(elastic_spectrum(eurocode8_vertical(1, 1.0), period), value, 1e-12) << period;
}

TEST(Eurocode8, HasItsDampingCorrectionAndItsBound) {
  EXPECT_CLOSE(elastic_spectrum(eurocode8(1, "A", 2.0, 0.10), 0.3), 2.5 * 2.0 * std::sqrt(10.0 / 15.0),
               1e-12);
  EXPECT_CLOSE(elastic_spectrum(eurocode8(1, "A", 2.0, 0.50), 0.3), 2.5 * 2.0 * 0.55, 1e-12);
  EXPECT_THAT(input_error([] { eurocode8(3, "A", 1.0); }), HasSubstr("type 1 or 2"));
  EXPECT_THAT(input_error([] { eurocode8(1, "F", 1.0); }), HasSubstr("A to E"));
}

TEST(Asce7, TakesItsSiteCoefficients) {
  const Asce7 s = asce7_16(1.125, 0.45, "D", 8.0);
  EXPECT_CLOSE(s.sds, 2.0 / 3.0 * 1.05 * 1.125, 1e-12);
  EXPECT_CLOSE(s.sd1, 2.0 / 3.0 * 1.85 * 0.45, 1e-12);
  EXPECT_TRUE(needs_site_study(0.45, "D"));
  EXPECT_FALSE(needs_site_study(0.1, "D"));
  EXPECT_CLOSE(asce7_16(0.75, 0.1, "E", 8.0).sds, 2.0 / 3.0 * 1.3 * 0.75, 1e-12);
  EXPECT_THAT(input_error([] { asce7_16(1.2, 0.1, "E", 8.0); }), HasSubstr("11.4.8"));
  EXPECT_CLOSE(design_acceleration({1.0, 0.6, 4.0}, 8.0), 0.6 * 4.0 / 64.0, 1e-12);
}

TEST(JapaneseSpectra, MeetTheirCheckValues) {
  struct Row {
    double period, type_1, type_2, type_3, bedrock;
  };
  for (const Row& row :
       {Row{0, 4.8, 4.8, 4.8, 3.2}, Row{.1, 9.3, 9.3, 9.3, 6.2}, Row{.3, 12, 12, 12, 8},
        Row{.6, 11.52, 12, 12, 8}, Row{.7, 9.8743, 12, 12, 7.3143}, Row{1, 6.912, 10.368, 12, 5.12},
        Row{2, 3.456, 5.184, 6.912, 2.56}, Row{5, 1.3824, 2.0736, 2.7648, 1.024}}) {
    EXPECT_NEAR(surface_acceleration({2, 1, 1.0}, row.period), row.type_1, 5e-5) << row.period;
    EXPECT_NEAR(surface_acceleration({2, 2, 1.0}, row.period), row.type_2, 5e-5) << row.period;
    EXPECT_NEAR(surface_acceleration({2, 3, 1.0}, row.period), row.type_3, 5e-5) << row.period;
    EXPECT_NEAR(surface_acceleration({2, 0, 1.0}, row.period), row.bedrock, 5e-5) << row.period;
    EXPECT_NEAR(surface_acceleration({1, 0, 0.8}, row.period), 0.8 * row.bedrock / 5.0, 5e-5);
  }
}

// The branches of JRA 2017 meet near the published corners of the plateaus.
TEST(JapaneseSpectra, HaveThePlateausOfTheBridgeCode) {
  EXPECT_NEAR(bridge_acceleration({1, 1}, 0.3), 14.0, 1e-12);
  EXPECT_NEAR(bridge_acceleration({1, 1}, 1.2), 7.0, 1e-12);
  EXPECT_NEAR(bridge_acceleration({1, 3}, 0.343), 12.0, 0.05);
  EXPECT_NEAR(bridge_acceleration({2, 2}, 0.8), 17.5, 1e-12);
  EXPECT_NEAR(bridge_acceleration({2, 1}, 0.15), 44.63 * std::pow(0.15, 2.0 / 3.0), 1e-12);
  EXPECT_NEAR(bridge_acceleration({2, 3}, 3.0), 29.48 * std::pow(3.0, -5.0 / 3.0), 1e-12);
  EXPECT_THAT(input_error([] { design_spectrum(JapaneseBridge{1, 4}); }), HasSubstr("found 4"));
}

TEST(SpectrumTable, InterpolatesAsAskedAndKeepsToItsPeriods) {
  const SpectrumTable table{"mine", {0.1, 1.0, 10.0}, {10.0, 5.0, 0.5}};
  EXPECT_NEAR(design_spectrum(table).at(0.55), 7.5, 1e-12);
  EXPECT_NEAR(design_spectrum(table, Interpolation::logarithmic).at(std::sqrt(10.0)), std::sqrt(2.5), 1e-12);
  EXPECT_EQ(design_spectrum(table).at(10.0), 0.5);
  EXPECT_EQ(design_spectrum(table).at(0.1), 10.0);
  EXPECT_THAT(input_error([&] { design_spectrum(table).at(11.0); }), HasSubstr("0.1 s to 10 s"));
}

TEST(SpectrumTable, RefusesWhatIsNoSpectrum) {
  EXPECT_THAT(input_error([] { design_spectrum(SpectrumTable{"t", {1.0}, {1.0}}); }), HasSubstr("two rows"));
  EXPECT_THAT(input_error([] {
                design_spectrum(SpectrumTable{"t", {1.0, 0.5}, {1.0, 1.0}});
              }),
              HasSubstr("periods that rise"));
  EXPECT_THAT(input_error([] {
                design_spectrum(SpectrumTable{"t", {0.0, 0.5}, {1.0, -1.0}});
              }),
              HasSubstr("positive acceleration (row 2)"));
}

}  // namespace
}  // namespace dougong::seismic
