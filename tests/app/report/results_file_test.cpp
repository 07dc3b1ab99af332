#include "app/report/results_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <functional>
#include <limits>

#include "app/report/results_fields.h"
#include "app/report/safe_file.h"
#include "fixtures.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Walks a run and writes every byte of it down: equal runs, equal text.
class Bytes {
 public:
  std::string out;

  template <class T>
  void optional_field(const std::string& name, const char* unit, const T& value) {
    field(name, unit, value);
  }
  template <class Inner>
  void optional_group(const std::string& name, Inner inner) {
    group(name, inner);
  }
  template <class Inner>
  void group(const std::string& name, Inner inner) {
    out += name + "{";
    inner();
    out += "}";
  }
  template <class Rows, class Inner>
  void table(const std::string& name, const Rows& rows, Inner inner) {
    out += std::to_string(rows.size());
    group(name, inner);
  }
  template <class Rows, class Inner>
  void rows(const std::string& name, const Rows& rows, Inner inner) {
    group(name, [&] {
      for (const auto& row : rows) inner(row);
    });
  }
  template <class Row, class T>
  void column(const std::string& name, const char*, const std::vector<Row>& rows, T Row::*member) {
    for (const Row& row : rows) field(name, "", row.*member);
  }
  template <class Row, class Member, class T>
  void column(const std::string& name, const char* unit, const std::vector<Row>& rows, Member Row::*member,
              T Member::*part) {
    for (const Row& row : rows) field(name, unit, row.*member.*part);
  }
  template <class Row, class T>
  void optional_column(const std::string& name, const char* unit, const std::vector<Row>& rows,
                       T Row::*member) {
    column(name, unit, rows, member);
  }
  template <class T>
  void field(const std::string& name, const char*, const std::vector<T>& values) {
    out += std::to_string(values.size()) + ":";
    for (const T& value : values) field(name, "", value);
  }
  void field(const std::string& name, const char*, const std::optional<double>& value) {
    out += value ? "some" : "none";
    if (value) field(name, "", *value);
  }
  void field(const std::string& name, const char*, const std::string& text) {
    out += name + "=" + text + ";";
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void field(const std::string& name, const char*, const T& value) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    out += name + "=" + raw + ";";
  }
  void matrix(const std::string& name, const char*, const std::vector<double>& values,
              std::initializer_list<std::size_t>) {
    field(name, "", values);
  }
};

std::string bytes_of(const RunResult& run) {
  Bytes bytes;
  walk_run(bytes, run);
  return bytes.out;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

RunResult round_trip(const RunResult& run) {
  const TemporaryDirectory folder;
  write_results(run, folder.path() / "results.h5");
  return read_results(folder.path() / "results.h5");
}

/// Files of this process cannot grow beyond a size while in scope: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(ResultsFile, EveryFieldComesBackBitForBit) {
  for (const RunResult& run : {fixtures::collapsed(), fixtures::repeated(), fixtures::brick_wall(),
                               fixtures::partial(), fixtures::motionless()}) {
    const RunResult back = round_trip(run);
    EXPECT_EQ(bytes_of(back), bytes_of(run)) << run.verdict.headline;
  }
}

// The list of fields is what both sides walk: a field that it forgets would go unseen above.
TEST(ResultsFile, KeepsWhatTheTerminalQuotes) {
  const RunResult run = fixtures::collapsed();
  const structures::Response back = round_trip(run).response;
  EXPECT_EQ(back.blocks, run.model.blocks.size());
  EXPECT_EQ(back.peak_base_shear_ratio.positive.value, 0.31);
  EXPECT_EQ(back.peak_base_shear_ratio.negative.time, 9.7);
  EXPECT_EQ(back.greatest_lean.block, "S4.column.left");
  EXPECT_EQ(back.greatest_lean.limit, 0.115);
  EXPECT_EQ(back.storeys[0].lost_because, run.response.storeys[0].lost_because);
}

TEST(ResultsFile, AnEmptyRunComesBack) {
  const RunResult back = round_trip({});
  EXPECT_EQ(bytes_of(back), bytes_of({}));
  EXPECT_FALSE(back.response.first_loss_of_support.has_value());
}

TEST(ResultsFile, KeepsUnicodeAndOddNumbers) {
  RunResult run = fixtures::survived();
  run.model.title = "汶川 – Tōhoku “ü” 𝛳 \n second line";
  run.model.layout.clear();
  run.response.roof_displacement = {-0.0, std::numeric_limits<double>::denorm_min(),
                                    std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN(), 0.1};
  run.response.first_loss_of_support = 0.0;
  run.model.blocks[0].outline.clear();
  run.model.blocks[0].radius = 0.3;
  EXPECT_EQ(bytes_of(round_trip(run)), bytes_of(run));
}

TEST(ResultsFile, TheSameRunGivesTheSameFile) {
  const TemporaryDirectory folder;
  write_results(fixtures::survived(), folder.path() / "a.h5");
  write_results(fixtures::survived(), folder.path() / "b.h5");
  EXPECT_EQ(read_file(folder.path() / "a.h5"), read_file(folder.path() / "b.h5"));
}

TEST(ResultsFile, LeavesNoTemporaryFileBehind) {
  const TemporaryDirectory folder;
  write_results({}, folder.path() / "results.h5");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(ResultsFile, ANewFolderThatDoesNotExistIsNamedWithTheReason) {
  const std::string said = message_of([] { write_results({}, "/nonexistent/folder/results.h5"); });
  EXPECT_THAT(said,
              AllOf(HasSubstr("/nonexistent/folder/results.h5"), HasSubstr("No such file or directory")));
}

TEST(ResultsFile, AFullDiskIsNamedAndTheOldFileStays) {
  const TemporaryDirectory folder;
  const fs::path path = folder.path() / "results.h5";
  write_file(path, "old");
  std::string said;
  {
    const FullDisk full(10000);
    said = message_of([&] { write_results(fixtures::survived(), path); });
  }
  EXPECT_THAT(said, AllOf(HasSubstr(path.string()), HasSubstr("File too large")));
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(ResultsFile, ADamagedOrForeignFileIsRefused) {
  const TemporaryDirectory folder;
  write_file(folder.path() / "x.h5", "this is no HDF5 file");
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "x.h5"); }), HasSubstr("x.h5"));
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "none.h5"); }), HasSubstr("no such file"));
  write_results(fixtures::survived(), folder.path() / "cut.h5");
  fs::resize_file(folder.path() / "cut.h5", 20000);
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "cut.h5"); }), HasSubstr("cut.h5"));
}

}  // namespace
}  // namespace dougong::app
