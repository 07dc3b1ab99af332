#include "seismic/catalogue.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "seismic/conditioning/condition.h"
#include "seismic/describe.h"
#include "seismic/formats/write_record.h"
#include "seismic/measures/peaks.h"
#include "seismic/read_record.h"
#include "seismic/synthesis/shipped.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;

std::filesystem::path records() {
  return testing::source_directory() / "records";
}

TEST(Catalogue, FindsTheShippedRecordsByIdAndAlias) {
  const auto catalogue = read_catalogue(records());
  ASSERT_EQ(catalogue.size(), 6u);
  EXPECT_EQ(find_entry(catalogue, "wenchuan")->id, "wenchuan-synthetic");
  EXPECT_EQ(find_entry(catalogue, "Tohoku-Synthetic")->alias, "tohoku");
  for (const char* alias : {"kobe", "chichi", "kocaeli", "elcentro"})
    EXPECT_TRUE(find_entry(catalogue, alias).has_value()) << alias;
  EXPECT_FALSE(find_entry(catalogue, "lisbon").has_value());
}

TEST(Catalogue, FilesReadBackToTheMeasuresItStates) {
  for (const CatalogueEntry& entry : read_catalogue(records())) {
    const RecordSet set = read_records(entry.paths());
    ASSERT_EQ(set.components.size(), entry.files.size());
    EXPECT_NE(set.vertical(), nullptr);
    for (std::size_t i = 0; i < entry.files.size(); ++i) {
      const RecordInfo info = describe(set.components[i]);
      const CatalogueFile& file = entry.files[i];
      EXPECT_TRUE(info.synthetic) << file.name;
      EXPECT_EQ(info.sha256, file.sha256) << file.name;
      EXPECT_EQ(info.component, file.component);
      EXPECT_EQ(info.interval, entry.interval);
      EXPECT_NEAR(static_cast<double>(info.samples) * info.interval, entry.duration, 1e-9);
      EXPECT_CLOSE(info.pga, file.pga, 1e-5);
      EXPECT_CLOSE(info.pgv, file.pgv, 1e-5);
      EXPECT_CLOSE(info.arias, file.arias, 1e-5);
      EXPECT_CLOSE(info.d5_95, file.d5_95, 1e-5);
      EXPECT_CLOSE(info.psa_1_0, file.psa_1_0, 1e-5);
      EXPECT_TRUE(info.warnings.empty()) << info.warnings.front();
      EXPECT_LT(std::filesystem::file_size(entry.directory / file.name), 400000u);
    }
  }
}

TEST(Catalogue, RegeneratingGivesTheSameBytes) {
  for (const ShippedFile& file : shipped_files()) {
    std::ifstream in(records() / file.name, std::ios::binary);
    const std::string shipped{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    EXPECT_TRUE(shipped == file.bytes) << file.name << " differs: run make_records records";
  }
}

// Mean square acceleration between two times.
double power(const Record& record, double from, double to) {
  const auto index = [&](double t) { return static_cast<std::size_t>(std::lround(t / record.interval)); };
  double sum = 0.0;
  for (std::size_t k = index(from); k < index(to); ++k)
    sum += record.acceleration[k] * record.acceleration[k];
  return sum / static_cast<double>(index(to) - index(from));
}

// The first area and, 50 s later, the third; then the southern ones.
TEST(Catalogue, TohokuHasTwoBurstsAndLastsLong) {
  const RecordSet set = read_records(find_entry(read_catalogue(records()), "tohoku")->paths());
  for (std::size_t i = 0; i < 2; ++i) {
    const Record& a = set.components[i];
    const double first = power(a, 4, 16), gap = power(a, 28, 48), second = power(a, 54, 70);
    EXPECT_GT(first, 30 * gap);
    EXPECT_GT(second, 30 * gap);
    EXPECT_GT(power(a, 105, 160), 3 * power(a, 85, 100));
    EXPECT_GT(describe(a).d5_95, 60.0);
  }
}

// Of the rupture's beginning and of Beichuan's; after a minute the north-eastern plane still breaks.
TEST(Catalogue, WenchuanHasTwoStrongPhasesAndALongEnd) {
  const RecordSet set = read_records(find_entry(read_catalogue(records()), "wenchuan")->paths());
  for (std::size_t i = 0; i < 2; ++i) {
    const Record& a = set.components[i];
    const double between = power(a, 15, 20);
    EXPECT_GT(power(a, 5, 15), 1.5 * between);
    EXPECT_GT(power(a, 24, 32), 1.1 * between);
    EXPECT_GT(power(a, 60, 80), 1.5 * power(a, 48, 56));
    EXPECT_GT(describe(a).d5_95, 50.0);
  }
}

TEST(Catalogue, EveryRecordReadsTheSameFromAllThreeNetworksFormats) {
  for (const Scenario& scenario : shipped_scenarios()) {
    const auto motion = shipped_motion(scenario);
    for (const WrittenFormat format : {WrittenFormat::at2, WrittenFormat::knet, WrittenFormat::csmnc}) {
      const auto files = write_records(motion, format);
      ASSERT_EQ(files.size(), 3u);
      for (std::size_t i = 0; i < 3; ++i) {
        ReadOptions options;
        options.component = motion[i].component;
        const auto path = testing::write_file(scenario.alias + files[i].suffix, files[i].bytes);
        const Record back = read_record(path, options).horizontal();
        EXPECT_TRUE(back.provenance.synthetic) << files[i].suffix;
        EXPECT_TRUE(back.warnings.empty()) << files[i].suffix << ": " << back.warnings.front();
        ASSERT_EQ(back.acceleration.size(), motion[i].acceleration.size());
        const double top = peak(motion[i].acceleration, motion[i].interval).value;
        double worst = 0.0;
        for (std::size_t k = 0; k < back.acceleration.size(); ++k)
          worst = std::max(worst, std::abs(back.acceleration[k] - motion[i].acceleration[k]));
        EXPECT_LT(worst, 2e-6 * top) << scenario.alias << files[i].suffix;
      }
    }
  }
}

TEST(Catalogue, FilesInOtherFormatsHoldTheSameMotion) {
  std::size_t files = 0;
  for (const CatalogueEntry& entry : read_catalogue(records())) {
    const RecordSet first = read_records(entry.paths());
    for (std::size_t i = 0; i < entry.also.size(); ++i, ++files) {
      ReadOptions options;
      options.component = entry.files[i % 3].component;
      const Record other = read_record(entry.directory / entry.also[i], options).horizontal();
      const Record& one = first.components[i % 3];
      EXPECT_EQ(other.interval, one.interval);
      EXPECT_CLOSE(describe(other).pga, entry.files[i % 3].pga, 1e-5);
      EXPECT_CLOSE(describe(other).psa_1_0, entry.files[i % 3].psa_1_0, 1e-5);
    }
  }
  EXPECT_EQ(files, 12u);  // Wenchuan and Tohoku
}

TEST(Catalogue, ShippedMotionsConditionToRest) {
  for (const CatalogueEntry& entry : read_catalogue(records())) {
    const ConditionedMotion motion = condition(read_records(entry.paths()));
    EXPECT_LT(std::abs(motion.residual_velocity), 1e-5);
    EXPECT_LT(std::abs(motion.residual_displacement), 1e-4);
    ASSERT_TRUE(motion.vertical.has_value());
  }
}

TEST(Catalogue, TellsWhereItIsBroken) {
  EXPECT_THAT(testing::input_error([] { read_catalogue("/no/such/folder"); }), HasSubstr("no such file"));
  const auto path = testing::write_file("catalogue.json", "{\"records\": [{\"id\": 3}]}");
  EXPECT_THAT(testing::input_error([&] { read_catalogue(path.parent_path()); }),
              HasSubstr("a catalogue of records"));
}

}  // namespace
}  // namespace dougong::seismic
