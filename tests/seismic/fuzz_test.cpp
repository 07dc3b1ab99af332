// Damaged files of every format: each is refused with an InputError or read as a sound record. The long run
// is tests/fuzz/.
#include <gtest/gtest.h>

#include <cmath>

#include "seismic/formats/archive.h"
#include "seismic/formats/format.h"
#include "seismic/input_error.h"
#include "seismic/read_record.h"
#include "tests/seismic/generated_files.h"
#include "tests/seismic/mutations.h"
#include "tests/seismic/test_data.h"

namespace dougong::seismic {
namespace {

constexpr int copies = 500;  // of every file

void expect_sound(const Record& record) {
  ASSERT_GE(record.acceleration.size(), 2u);
  ASSERT_TRUE(record.interval > 0.0 && record.interval <= 10.0);
  for (const double a : record.acceleration) ASSERT_TRUE(std::isfinite(a));
}

void read_damaged(const std::string& bytes, const ReadOptions& options) {
  try {
    for (const Record& record : read_bytes_as_record("damaged", bytes, options)) expect_sound(record);
  } catch (const InputError& error) {
    ASSERT_FALSE(error.problems().empty());
    ASSERT_FALSE(error.problems().front().expected.empty());
  }
}

TEST(DamagedFiles, AreRefusedOrReadSoundly) {
  testing::Mutations mutations(20240607);
  for (const testing::GeneratedFile& file : testing::generated_files()) {
    ReadOptions forced = file.options;
    forced.format = file.format;
    for (int copy = 0; copy < copies; ++copy) {
      const std::string bytes = mutations.damaged(file.bytes);
      SCOPED_TRACE(file.format + ", copy " + std::to_string(copy));
      read_damaged(bytes, file.options);
      read_damaged(bytes, forced);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(DamagedFiles, OfAnyKindAreRefusedByEveryReader) {
  ReadOptions options;
  options.units = "gal";
  options.count_scale = 1e-6;
  for (const Format& format : formats()) {
    options.format = format.id;
    for (const testing::GeneratedFile& file : testing::generated_files()) read_damaged(file.bytes, options);
    for (const char* bytes : {"", "\n", " ", "\r\n\r\n", "1", "/&", "\xff\xfe\xff"})
      read_damaged(bytes, options);
    read_damaged(std::string(100000, '\n'), options);
    read_damaged(std::string(100000, '9'), options);
    read_damaged(std::string(100000, ' '), options);
    read_damaged(std::string(100000, '\0'), options);
  }
}

TEST(DamagedFiles, AreRefusedByArchives) {
  const auto path = testing::real_record("archive/AOM0011801241951.tar.gz");
  SKIP_WITHOUT(path);
  const std::string whole = read_bytes(path);
  testing::Mutations mutations(7);
  ArchiveLimits limits;
  limits.bytes = 1 << 22;
  for (int copy = 0; copy < copies; ++copy) {
    try {
      unpack(mutations.damaged(whole), "damaged", limits);
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace dougong::seismic
