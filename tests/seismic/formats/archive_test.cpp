#include "seismic/formats/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>

#include "seismic/read_record.h"
#include "tests/seismic/generated_files.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::input_error;
using testing::write_file;

struct File {
  std::string name, bytes;
};

std::string packed(const std::vector<File>& files, bool zip) {
  std::string out(1 << 22, '\0');
  std::size_t used = 0;
  archive* writer = archive_write_new();
  zip ? archive_write_set_format_zip(writer) : archive_write_set_format_ustar(writer);
  if (!zip) archive_write_add_filter_gzip(writer);
  archive_write_open_memory(writer, out.data(), out.size(), &used);
  for (const File& file : files) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, file.name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(file.bytes.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_write_header(writer, entry);
    archive_write_data(writer, file.bytes.data(), file.bytes.size());
    archive_entry_free(entry);
  }
  archive_write_close(writer);
  archive_write_free(writer);
  out.resize(used);
  return out;
}

std::string gzipped(const std::string& bytes) {
  std::string out(1 << 22, '\0');
  std::size_t used = 0;
  archive* writer = archive_write_new();
  archive_write_set_format_raw(writer);
  archive_write_add_filter_gzip(writer);
  archive_write_open_memory(writer, out.data(), out.size(), &used);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_write_header(writer, entry);
  archive_write_data(writer, bytes.data(), bytes.size());
  archive_entry_free(entry);
  archive_write_close(writer);
  archive_write_free(writer);
  out.resize(used);
  return out;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

std::vector<File> two_stations() {
  const std::string east = testing::knet_file().bytes, north = replaced(east, "E-W", "N-S");
  return {{"data/AOM001.EW", east},
          {"data/AOM001.NS", north},
          {"data/AOM002.EW", replaced(east, "AOM001", "AOM002")},
          {"readme.txt", "not a recording\n"}};
}

TEST(Archive, IsToldByItsFirstBytes) {
  EXPECT_TRUE(is_archive(packed(two_stations(), true)));
  EXPECT_TRUE(is_archive(packed(two_stations(), false)));
  EXPECT_TRUE(is_archive(gzipped("x")));
  EXPECT_FALSE(is_archive(testing::knet_file().bytes));
  EXPECT_FALSE(is_archive(""));
}

TEST(Archive, ReadsARecordingThatIsOnlyCompressed) {
  const auto& file = testing::dyna_file();
  const auto path = write_file("a.asc.gz", gzipped(file.bytes));
  const Record record = read_record(path).horizontal();
  EXPECT_EQ(record.acceleration, read_bytes_as_record("a", file.bytes).front().acceleration);
  EXPECT_EQ(record.provenance.file, path.string());
}

TEST(Archive, GroupsItsMembersByStation) {
  for (const bool zip : {true, false}) {
    const auto path = write_file("a.archive", packed(two_stations(), zip));
    const Channels channels = read_channels(path);
    EXPECT_EQ(channels.records.size(), 3u);
    EXPECT_THAT(channels.warnings, ElementsAre(HasSubstr("readme.txt is passed over: no known recording")));
    EXPECT_THAT(
        input_error([&] { read_record(path); }),
        HasSubstr("expected one station (option station, or component), found AOM001 (EW, NS), AOM002 (EW)"));
    ReadOptions options;
    options.station = "aom001";
    const RecordSet set = read_record(path, options);
    EXPECT_EQ(set.components.size(), 2u);
    EXPECT_EQ(set.horizontal().provenance.member, "data/AOM001.EW");
    EXPECT_EQ(set.horizontal().provenance.file, path.string());
    options = {};
    options.component = "NS";
    EXPECT_EQ(read_record(path, options).horizontal().component, "NS");
  }
}

TEST(Archive, ReadsTheMemberAskedFor) {
  const auto path = write_file("a.zip", packed(two_stations(), true));
  ReadOptions options;
  for (const char* member : {"data/AOM002.EW", "AOM002.EW"}) {
    options.member = member;
    EXPECT_EQ(read_record(path, options).horizontal().provenance.station, "AOM002");
  }
  options.member = "AOM003.EW";
  EXPECT_THAT(input_error([&] { read_record(path, options); }),
              HasSubstr("expected member AOM003.EW, found data/AOM001.EW, data/AOM001.NS"));
  options.member = "readme.txt";
  EXPECT_THAT(input_error([&] { read_record(path, options); }),
              HasSubstr("a.zip/readme.txt: expected a known format"));
  options.member = "x";
  EXPECT_THAT(input_error([&] { read_record(write_file("a.EW", testing::knet_file().bytes), options); }),
              HasSubstr("expected an archive (option member), found no archive"));
}

TEST(Archive, PassesOverVelocityDisplacementAndSpectra) {
  const std::string at2 = testing::at2_file().bytes;
  const std::string vt2 =
      replaced(at2, "ACCELERATION TIME SERIES IN UNITS OF G", "VELOCITY TIME SERIES IN UNITS OF CM/S");
  const auto path =
      write_file("peer.zip", packed({{"RSN1.VT2", vt2},
                                     {"RSN1.AT2", at2},
                                     {"RSN1.V3", "RESPONSE AND FOURIER AMPLITUDE SPECTRA\n1 2\n"},
                                     {"_SearchResults.csv", "1,2\n3,4\n"}},
                                    true));
  const RecordSet set = read_record(path);
  EXPECT_EQ(set.components.size(), 1u);
  EXPECT_EQ(set.horizontal().provenance.member, "RSN1.AT2");
  EXPECT_THAT(set.warnings, Contains(HasSubstr("RSN1.VT2 is passed over: no acceleration")));
  EXPECT_THAT(set.warnings, Contains(HasSubstr("RSN1.V3 is passed over: no acceleration (response spectra")));
  EXPECT_THAT(set.warnings, Contains(HasSubstr("_SearchResults.csv is passed over")));
  ReadOptions options;
  options.member = "RSN1.VT2";
  EXPECT_THAT(input_error([&] { read_record(path, options); }),
              HasSubstr("peer.zip/RSN1.VT2:3: expected an acceleration"));
}

TEST(Archive, FindsArchivesInArchives) {
  const std::string inner = packed(two_stations(), false);
  const auto members = unpack(packed({{"AOM.tar.gz", inner}, {"x.EW.gz", gzipped("1\n")}}, true), "a.zip");
  ASSERT_EQ(members.size(), 5u);
  EXPECT_EQ(members[0].name, "AOM.tar.gz/data/AOM001.EW");
  EXPECT_EQ(members[4].bytes, "1\n");
}

TEST(Archive, BoundsWhatASmallFileMayUnpackTo) {
  const std::string bomb = gzipped(std::string(1 << 20, ' '));
  EXPECT_LT(bomb.size(), 10000u);
  ArchiveLimits limits;
  limits.bytes = 1000000;
  EXPECT_THAT(input_error([&] { unpack(bomb, "a.gz", limits); }),
              HasSubstr("at most 1000000 bytes unpacked"));
  limits = {};
  limits.members = 2;
  EXPECT_THAT(input_error([&] { unpack(packed(two_stations(), true), "a.zip", limits); }),
              HasSubstr("at most 2 files"));
  std::string nested = "1\n";
  for (int level = 0; level < 5; ++level) nested = packed({{"inner.zip", nested}}, true);
  EXPECT_THAT(input_error([&] { unpack(nested, "a.zip"); }), HasSubstr("at most 3 deep"));
}

TEST(Archive, RefusesADamagedOne) {
  std::string bytes = packed(two_stations(), false);
  bytes.resize(bytes.size() / 2);
  EXPECT_THAT(input_error([&] { unpack(bytes, "a.tar.gz"); }),
              HasSubstr("a.tar.gz: expected an archive that can be unpacked"));
  EXPECT_THAT(input_error([] { read_record(write_file("a.zip", packed({}, true))); }),
              HasSubstr("a.zip: expected"));
}

}  // namespace
}  // namespace dougong::seismic
