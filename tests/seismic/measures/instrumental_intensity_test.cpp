#include "seismic/measures/instrumental_intensity.h"

#include <array>

#include "seismic/read_record.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

TEST(JmaFilter, HasThePublishedGains) {
  constexpr std::array<std::array<double, 2>, 8> rows = {{{.1, .282268},
                                                          {.25, .685426},
                                                          {.5, 1.12341},
                                                          {1, .996369},
                                                          {2, .69736},
                                                          {5, .410051},
                                                          {10, .223503},
                                                          {20, .056473}}};
  for (const auto& [f, gain] : rows) EXPECT_CLOSE(jma_filter_gain(f), gain, 1e-5) << f;
  EXPECT_EQ(jma_filter_gain(0.0), 0.0);
}

TEST(JmaIntensity, OfASineIsThatOfItsFilteredAmplitude) {
  std::vector<double> a;  // 16 s of 2 Hz, whole periods of the transform
  for (int k = 0; k < 2048; ++k) a.push_back(0.5 * std::sin(2 * std::numbers::pi * 2.0 * k / 128.0));
  const JmaIntensity jma = jma_intensity({a}, 1.0 / 128.0);
  EXPECT_NEAR(jma.level, 0.5 * jma_filter_gain(2.0), 1e-3);
  EXPECT_NEAR(jma.value, 2.0 * std::log10(50.0 * jma_filter_gain(2.0)) + 0.94, 0.005);
  EXPECT_EQ(jma.scale, "4");
}

TEST(JmaIntensity, OfTkyh12IsThePublishedOne) {
  Components components;
  for (const char* suffix : {"EW2", "NS2", "UD2"}) {
    const auto path = testing::real_record(std::string("kiknet/TKYH121103111446.") + suffix);
    SKIP_WITHOUT(path);
    ReadOptions options;
    options.siblings = false;
    components.push_back(read_record(path, options).components.at(0).acceleration);
  }
  const JmaIntensity jma = jma_intensity(components, 0.01);
  EXPECT_NEAR(jma.value, 4.665, 0.0006);
  EXPECT_EQ(jma.reported, 4.6);
  EXPECT_EQ(jma.scale, "5-");
}

TEST(JmaClass, ChangesWhereItShould) {
  EXPECT_EQ(jma_class(0.4), "0");
  EXPECT_EQ(jma_class(0.5), "1");
  EXPECT_EQ(jma_class(4.4), "4");
  EXPECT_EQ(jma_class(4.9), "5-");
  EXPECT_EQ(jma_class(5.0), "5+");
  EXPECT_EQ(jma_class(5.9), "6-");
  EXPECT_EQ(jma_class(6.4), "6+");
  EXPECT_EQ(jma_class(6.5), "7");
}

TEST(JmaIntensity, OfARecordOfZerosIsClassZero) {
  const JmaIntensity jma = jma_intensity({std::vector<double>(1000, 0.0)}, 0.01);
  EXPECT_EQ(jma.level, 0.0);
  EXPECT_EQ(jma.reported, 0.0);
  EXPECT_EQ(jma.scale, "0");
}

// GB/T 17742-2020: check values of the formulas, and the choice between them.
TEST(ChinaIntensity, TakesTheVelocityWhereBothReachSix) {
  EXPECT_NEAR(china_intensity(1.0, 0.1).by_acceleration, 6.59, 1e-12);
  EXPECT_NEAR(china_intensity(1.0, 0.1).value, 6.77, 1e-12);
  const ChinaIntensity weak = china_intensity(1.0, 0.02);
  EXPECT_NEAR(weak.value, 0.5 * (weak.by_acceleration + weak.by_velocity), 1e-12);
  EXPECT_EQ(china_intensity(1e-6, 1e-6).value, 1.0);
  EXPECT_EQ(china_intensity(0.0, 0.0).value, 1.0);
}

TEST(ChinaIntensity, FiltersARecordingToItsBand) {
  std::vector<double> a;
  for (int k = 0; k < 4000; ++k) {
    const double t = 0.01 * k;
    a.push_back(0.3 * std::sin(2 * std::numbers::pi * 2.0 * t) + std::sin(2 * std::numbers::pi * 30.0 * t));
  }
  EXPECT_NEAR(china_intensity({a}, 0.01).pga, 0.3, 0.02);
}

TEST(Mmi, MeetsTheCheckValuesOfWorden2012) {
  EXPECT_NEAR(mmi_by_acceleration(1.0), 5.80, 1e-9);
  EXPECT_NEAR(mmi_by_acceleration(5.0), 8.386, 5e-4);
  EXPECT_NEAR(mmi_by_velocity(0.1), 6.05, 1e-9);
  EXPECT_NEAR(mmi_by_velocity(0.5), 8.259, 5e-4);
  EXPECT_EQ(mmi_by_velocity(0.0), 1.0);
}

}  // namespace
}  // namespace dougong::seismic
