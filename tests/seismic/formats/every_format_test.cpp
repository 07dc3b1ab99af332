// What holds of every format alike, on a generated file of each.
#include <gmock/gmock.h>

#include <numeric>

#include "seismic/formats/format.h"
#include "seismic/measures/peaks.h"
#include "tests/seismic/generated_files.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace testing {

void PrintTo(const GeneratedFile& file, std::ostream* out) {
  *out << file.format;
}

}  // namespace testing

namespace {

using ::testing::ElementsAreArray;
using testing::GeneratedFile;
using ::testing::HasSubstr;
using testing::input_error;
using testing::sample;
using testing::samples;
using testing::write_file;

class EveryFormat : public ::testing::TestWithParam<GeneratedFile> {
 protected:
  std::vector<Record> read(const std::string& bytes) const {
    return read_bytes_as_record("a.file", bytes, GetParam().options);
  }
};

std::vector<std::string> names_of(const std::vector<Record>& records) {
  std::vector<std::string> names;
  for (const Record& record : records) names.push_back(record.component);
  return names;
}

TEST_P(EveryFormat, IsRecognisedByItsContentAlone) {
  FileText text;
  set_bytes("misleading.at2", GetParam().bytes, text);
  for (const Format& format : formats()) {
    if (!format.recognises(text)) continue;
    EXPECT_EQ(format.id, GetParam().format);
    break;
  }
}

TEST_P(EveryFormat, GivesTheSamplesOfEveryChannel) {
  const std::vector<Record> records = read(GetParam().bytes);
  EXPECT_THAT(names_of(records), ElementsAreArray(GetParam().names));
  double offset = 0.0;
  for (std::size_t k = 0; k < samples; ++k) offset += sample(k) / static_cast<double>(samples);
  if (!GetParam().offset_removed) offset = 0.0;
  for (const Record& record : records) {
    ASSERT_EQ(record.acceleration.size(), samples);
    EXPECT_NEAR(record.interval, GetParam().interval, 1e-12);
    for (std::size_t k = 0; k < samples; ++k)
      ASSERT_NEAR(record.acceleration[k], sample(k) - offset, GetParam().precision)
          << record.component << " " << k;
  }
}

TEST_P(EveryFormat, KeepsWhereARecordComesFrom) {
  for (const Record& record : read(GetParam().bytes)) {
    const Provenance& from = record.provenance;
    EXPECT_FALSE(from.format.empty());
    EXPECT_FALSE(from.units.empty());
    EXPECT_FALSE(from.scale.empty());
    EXPECT_EQ(from.file, "a.file");
    EXPECT_EQ(from.sha256, sha256_hex(GetParam().bytes));
    EXPECT_FALSE(from.component.empty());
  }
}

// Text only: binary formats have no lines.
bool is_text(const GeneratedFile& file) {
  return file.format != "sac" && file.format != "miniseed";
}

std::string with_line_ends(const std::string& bytes, const std::string& end) {
  std::string out;
  for (const char c : bytes) {
    if (c == '\n') out += end;
    if (c != '\n' && c != '\r') out += c;
  }
  return out;
}

TEST_P(EveryFormat, ReadsEveryLineEndAndNoLastOne) {
  if (!is_text(GetParam())) GTEST_SKIP() << "no lines";
  const auto expected = read(GetParam().bytes);
  for (const char* end : {"\n", "\r\n", "\r\r\n"}) {
    std::string bytes = with_line_ends(GetParam().bytes, end);
    for (const std::string& tail : {std::string{}, std::string(end), std::string("  ") + end}) {
      const auto records = read(bytes + tail);
      ASSERT_EQ(records.size(), expected.size());
      for (std::size_t i = 0; i < records.size(); ++i)
        EXPECT_EQ(records[i].acceleration, expected[i].acceleration);
    }
    while (bytes.back() == '\n' || bytes.back() == '\r') bytes.pop_back();
    EXPECT_EQ(read(bytes).back().acceleration, expected.back().acceleration);
  }
}

TEST_P(EveryFormat, RefusesAFileThatWasCutOffOrSaysSo) {
  if (GetParam().format == "columns" || GetParam().format == "rec" || GetParam().format == "record-csv")
    GTEST_SKIP() << "states no count";
  const std::string& bytes = GetParam().bytes;
  std::vector<Record> records;
  const std::string text = input_error([&] { records = read(bytes.substr(0, bytes.size() * 3 / 5)); });
  if (!text.empty()) {
    EXPECT_THAT(text, HasSubstr("a.file"));
    EXPECT_THAT(text, HasSubstr("expected"));
    return;
  }
  // Only what stands behind a whole acceleration may be missing, and then that is said.
  ASSERT_FALSE(records.empty());
  EXPECT_THAT(records.back().warnings, ::testing::Contains(HasSubstr("cut off")));
}

TEST_P(EveryFormat, RefusesUnitsOtherThanItsOwn) {
  if (GetParam().options.units) GTEST_SKIP() << "states no units";
  ReadOptions options = GetParam().options;
  options.units = "furlongs";
  EXPECT_THAT(input_error([&] { read_bytes_as_record("a.file", GetParam().bytes, options); }),
              HasSubstr("leave out the option units"));
}

TEST_P(EveryFormat, AsksForUnitsThatItDoesNotState) {
  if (!GetParam().options.units) GTEST_SKIP() << "states its units";
  EXPECT_THAT(input_error([&] { read_bytes_as_record("a.file", GetParam().bytes, {}); }),
              HasSubstr("the units of the values: option units ="));
}

TEST_P(EveryFormat, RefusesAStepOtherThanItsOwn) {
  if (GetParam().takes_step) GTEST_SKIP() << "takes a step from the caller";
  ReadOptions options = GetParam().options;
  options.interval = 0.02;
  EXPECT_THAT(input_error([&] { read_bytes_as_record("a.file", GetParam().bytes, options); }),
              HasSubstr("the time step given, 0.02 s (option dt)"));
}

TEST_P(EveryFormat, NamesTheLineOfABadValue) {
  if (!is_text(GetParam())) GTEST_SKIP() << "no lines";
  std::string bytes = GetParam().bytes;
  const std::size_t last_line = bytes.find_last_of('\n', bytes.size() - 60);
  const std::size_t digit = bytes.find_last_of("0123456789", last_line);
  bytes[digit] = 'x';
  const std::string text = input_error([&] { read(bytes); });
  // In the last channel's velocity or displacement, which are not read, nothing is wrong.
  if (text.empty()) GTEST_SKIP() << "not part of the acceleration";
  EXPECT_THAT(text, ::testing::ContainsRegex("a\\.file:[0-9]+: expected"));
}

INSTANTIATE_TEST_SUITE_P(Generated, EveryFormat, ::testing::ValuesIn(testing::generated_files()),
                         [](const auto& info) {
                           std::string name = info.param.format + "_" + std::to_string(info.index);
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(Formats, HaveAGeneratedFileEach) {
  std::vector<std::string> generated;
  for (const GeneratedFile& file : testing::generated_files()) generated.push_back(file.format);
  for (const Format& format : formats()) {
    if (format.id == "volume-3") continue;  // refused: nothing to read
    EXPECT_THAT(generated, ::testing::Contains(std::string(format.id)));
  }
}

}  // namespace
}  // namespace dougong::seismic
