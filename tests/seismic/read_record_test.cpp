#include "seismic/read_record.h"

#include <gmock/gmock.h>

#include "seismic/formats/file_text.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::HasSubstr;
using testing::input_error;
using testing::write_file;

TEST(ReadRecord, TellsAMissingFileADirectoryAndAnEmptyFileApart) {
  EXPECT_THAT(input_error([] { read_record("/no/such/file.at2"); }),
              HasSubstr("expected a recording, found no such file"));
  EXPECT_THAT(input_error([] { read_record(testing::source_directory()); }),
              HasSubstr("expected a file, found a directory"));
  EXPECT_THAT(input_error([] { read_record(write_file("empty.at2", "")); }), HasSubstr("zero length"));
}

TEST(ReadRecord, ListsWhatWasTriedForAnUnknownFormat) {
  const std::string text = input_error([] { read_record(write_file("a.at2", "GIF89a\n\xff\xfe\n")); });
  EXPECT_THAT(text, HasSubstr("expected a known format (tried: miniSEED, SAC, K-NET/KiK-net ASCII"));
  EXPECT_THAT(text, HasSubstr("plain columns)"));
  EXPECT_THAT(text, HasSubstr("found \"GIF89a\""));
}

TEST(ReadRecord, CutsChannelsToTheShortestAndSaysSo) {
  const std::string head = "# dougong record\n# interval (s): 0.01\ntime (s),";
  const auto east = write_file("e.csv", head + "EW (m/s2)\n0,1\n0.01,2\n0.02,3\n0.03,4\n");
  const auto north = write_file("n.csv", head + "NS (m/s2)\n0,1\n0.01,-2\n0.02,0\n");
  const std::vector<std::filesystem::path> both = {east, north};
  const RecordSet set = read_records(both);
  ASSERT_EQ(set.components.size(), 2u);
  EXPECT_THAT(set.components[0].acceleration, ::testing::ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(set.warnings,
              ::testing::Contains(HasSubstr("EW has 4 samples, cut to the 3 of the shortest component")));
}

TEST(ReadRecord, TakesTheFormatAskedFor) {
  ReadOptions options;
  options.format = "knet";
  EXPECT_THAT(input_error([&] { read_record(write_file("a.txt", "1 2\n3 4\n"), options); }),
              HasSubstr("Memo."));
  options.format = "excel";
  EXPECT_THAT(input_error([&] { read_record(write_file("a.txt", "1 2\n3 4\n"), options); }),
              HasSubstr("expected one of miniseed, sac, knet, knet-csv, record-csv, csmnc, rec, dyna"));
}

TEST(ReadRecord, ErrorsCarryFileLineExpectedAndFound) {
  const InputError error("a.at2", 7, "a number", "x");
  EXPECT_STREQ(error.what(), "a.at2:7: expected a number, found x");
  ASSERT_EQ(error.problems().size(), 1u);
  EXPECT_EQ(error.problems()[0].line, 7u);
}

TEST(FileText, HashesTheBytes) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Axis, KnowsTheNamesOfVerticalComponents) {
  for (const char* name : {"UD", "U-D", "UP", "up", "UD2", "HNZ", "BNZ", "V", "-UP", "DWN"}) {
    EXPECT_EQ(axis_of(name), Axis::vertical) << name;
  }
  for (const char* name : {"EW", "N-S", "180", "HNE", "H1", "360", ""})
    EXPECT_EQ(axis_of(name), Axis::horizontal) << name;
}

}  // namespace
}  // namespace dougong::seismic
