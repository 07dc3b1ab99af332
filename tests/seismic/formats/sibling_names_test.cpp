#include "seismic/formats/sibling_names.h"

#include <gmock/gmock.h>

#include "seismic/formats/write_record.h"
#include "seismic/read_record.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> names(const char* path) {
  std::vector<std::string> out;
  for (const auto& sibling : sibling_names(path)) out.push_back(sibling.string());
  return out;
}

TEST(SiblingNames, AreThoseThatStationsUse) {
  EXPECT_THAT(names("d/x-EW.at2"), ElementsAre("d/x-EW.at2", "d/x-NS.at2", "d/x-UD.at2", "d/x-UP.at2"));
  EXPECT_THAT(names("RSN1_A-N.AT2"),
              ElementsAre("RSN1_A-N.AT2", "RSN1_A-E.AT2", "RSN1_A-V.AT2", "RSN1_A-Z.AT2"));
  EXPECT_THAT(names("GIL067.AT2"), ::testing::IsSupersetOf({"GIL157.AT2", "GIL337.AT2", "GIL-UP.AT2"}));
  EXPECT_THAT(names("A-ELC270.AT2"),
              ::testing::IsSupersetOf({"A-ELC180.AT2", "A-ELC000.AT2", "A-ELC360.AT2"}));
  EXPECT_THAT(names("quake.dat"), ElementsAre("quake.dat"));
  EXPECT_THAT(names("51BXD_ua0001.dat"), ElementsAre("51BXD_ua0001.dat"));
}

Record record(const std::string& event, const char* component, double scale) {
  Record r;
  r.acceleration = {0.0, scale, -scale, 0.5 * scale, 0.0};
  r.interval = 0.01;
  r.component = component;
  r.axis = axis_of(component);
  r.provenance.event = event;
  r.provenance.station = "S01";
  return r;
}

TEST(Siblings, OfAt2AndCsmncAreFoundBesideAFile) {
  const std::vector<Record> station = {record("Quake", "EW", 1.0), record("Quake", "NS", 2.0),
                                       record("Quake", "UD", 3.0)};
  for (const WrittenFormat format : {WrittenFormat::at2, WrittenFormat::csmnc}) {
    std::filesystem::path path;
    for (const WrittenFile& file : write_records(station, format))
      path = testing::write_file("q" + file.suffix, file.bytes);
    const RecordSet set = read_record(path.parent_path() / ("q-NS" + path.extension().string()));
    ASSERT_EQ(set.components.size(), 3u);
    EXPECT_EQ(set.horizontal().component, "NS");  // the file that was named
    ASSERT_NE(set.vertical(), nullptr);
    EXPECT_CLOSE(set.vertical()->acceleration[1], 3.0, 1e-6);
    ReadOptions alone;
    alone.siblings = false;
    EXPECT_EQ(read_record(path, alone).components.size(), 1u);
  }
}

TEST(Siblings, OfAnotherEarthquakeAreLeftAlone) {
  for (const Record& r : {record("Quake", "EW", 1.0), record("Other", "NS", 2.0)}) {
    const WrittenFile file = write_records({&r, 1}, WrittenFormat::at2).front();
    testing::write_file("q" + file.suffix, file.bytes);
  }
  const auto path = testing::write_file("none.txt", "").parent_path() / "q-EW.AT2";
  EXPECT_EQ(read_record(path).components.size(), 1u);
}

}  // namespace
}  // namespace dougong::seismic
