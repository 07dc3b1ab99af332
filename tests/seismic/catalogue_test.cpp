#include "seismic/catalogue.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "seismic/conditioning/condition.h"
#include "seismic/describe.h"
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

TEST(Catalogue, TohokuHasTwoBurstsAndLastsLong) {
  const auto entry = find_entry(read_catalogue(records()), "tohoku");
  const RecordSet set = read_records(entry->paths());
  const auto& a = set.horizontal().acceleration;
  const auto energy = [&](double from, double to) {
    double sum = 0.0;
    for (auto k = static_cast<std::size_t>(from * 100); k < static_cast<std::size_t>(to * 100); ++k)
      sum += a[k] * a[k];
    return sum / (to - from);
  };
  const double first = energy(14, 34), gap = energy(50, 60), second = energy(64, 84);
  EXPECT_GT(first, 3 * gap);
  EXPECT_GT(second, 3 * gap);
  EXPECT_GT(describe(set.horizontal()).d5_95, 60.0);
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
