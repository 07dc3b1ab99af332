#include "app/study/record_list.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "seismic/seismic.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Two shipped records, a shape, and files that are none.
class RecordListing : public ::testing::Test {
 protected:
  RecordListing() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "deep" / ".git");
    for (const char* name : {"kobe-synthetic-EW.at2", "kobe-synthetic-NS.at2"})
      fs::copy_file(fs::path(DOUGONG_RECORDS_DIRECTORY) / name, folder_ / name);
    for (const char* name : {"tohoku-synthetic.EW", "tohoku-synthetic.NS", "tohoku-synthetic.UD"})
      fs::copy_file(fs::path(DOUGONG_RECORDS_DIRECTORY) / name, folder_ / "deep" / name);
    put("readme.txt", "Recordings of two earthquakes.\n");
    put("short.at2", "t\ne, d, s, c\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 9, DT= .01 SEC\n .1 .2\n");
    put(".hidden", "1 2\n");
    put("deep/.git/config", "1 2\n");
  }
  ~RecordListing() override { fs::remove_all(folder_); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  RecordList list(std::size_t jobs = 1) const { return list_records(files_below(folder_), {0.5, 1.0}, jobs); }
  fs::path folder_ = fs::temp_directory_path() / fmt::format("records-{}", ::getpid());
};

TEST_F(RecordListing, HasEveryComponentOnceWithTheMeasuresOfRecordInfo) {
  const RecordList all = list();
  ASSERT_EQ(all.records.size(), 5u);
  for (const RecordSummary& r : all.records) {
    seismic::ReadOptions options;
    options.component = r.component;
    const seismic::RecordInfo info = seismic::describe(seismic::read_record(r.file, options).horizontal());
    EXPECT_EQ(r.pga, info.pga) << r.file;
    EXPECT_EQ(r.pgv, info.pgv);
    EXPECT_EQ(r.d5_95, info.d5_95);
    EXPECT_NEAR(r.psa[0], info.psa_0_5, 1e-9 * info.psa_0_5);
    EXPECT_NEAR(r.psa[1], info.psa_1_0, 1e-9 * info.psa_1_0);
    EXPECT_EQ(r.samples, info.samples);
    EXPECT_EQ(r.units, info.units);
    EXPECT_TRUE(r.synthetic);
  }
}

TEST_F(RecordListing, NamesWhatItCannotReadAndPassesHiddenFilesOver) {
  const RecordList all = list();
  ASSERT_EQ(all.unreadable.size(), 2u);
  EXPECT_THAT(all.unreadable[0].file, HasSubstr("readme.txt"));
  EXPECT_EQ(all.unreadable[0].reason, "no known format of recordings");
  EXPECT_THAT(all.unreadable[1].file, HasSubstr("short.at2"));
  EXPECT_THAT(all.unreadable[1].reason, HasSubstr("expected 9 values"));
}

TEST_F(RecordListing, IsTheSameOnAnyNumberOfThreads) {
  const RecordList one = list(1), four = list(4);
  ASSERT_EQ(one.records.size(), four.records.size());
  for (std::size_t i = 0; i < one.records.size(); ++i) {
    EXPECT_EQ(one.records[i].file, four.records[i].file);
    EXPECT_EQ(one.records[i].psa, four.records[i].psa);
  }
  EXPECT_EQ(one.unreadable.size(), four.unreadable.size());
}

TEST_F(RecordListing, SortsByEveryKey) {
  const auto value = [](const RecordSummary& r, const std::string& key) {
    return key == "pga"      ? r.pga
           : key == "pgv"    ? r.pgv
           : key == "d5-95"  ? r.d5_95
           : key == "dt"     ? r.interval
           : key == "length" ? r.length
           : key == "psa"    ? r.psa.front()
                             : r.mean_period;
  };
  for (const std::string& key : sort_keys()) {
    RecordList all = list();
    std::reverse(all.records.begin(), all.records.end());
    sort_records(all, key);
    for (std::size_t i = 1; i < all.records.size(); ++i) {
      const RecordSummary &a = all.records[i - 1], &b = all.records[i];
      EXPECT_TRUE(key == "name" ? a.file <= b.file : value(a, key) >= value(b, key)) << key;
    }
  }
}

TEST_F(RecordListing, PutsTheMotionNearestToAPeriodFirst) {
  RecordList all = list();
  sort_near_period(all, 0.9);
  for (std::size_t i = 1; i < all.records.size(); ++i)
    EXPECT_LE(std::abs(std::log(all.records[i - 1].mean_period / 0.9)),
              std::abs(std::log(all.records[i].mean_period / 0.9)));
}

TEST(RecordList, RefusesWhatIsNoFolder) {
  EXPECT_THROW(files_below("/no/such/folder"), seismic::InputError);
}

}  // namespace
}  // namespace dougong::app
