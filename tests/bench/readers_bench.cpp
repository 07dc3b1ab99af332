// How fast each format is read: bytes at hand (checksum, lines, header, numbers) to records, one core. The
// files are those of the tests, with 80 000 samples a channel.
#include <benchmark/benchmark.h>

#include "seismic/read_record.h"
#include "tests/seismic/generated_files.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t long_record = 80000;

void read_file(benchmark::State& bench, const testing::GeneratedFile& file) {
  for (auto _ : bench) benchmark::DoNotOptimize(read_bytes_as_record("a.file", file.bytes, file.options));
  const auto bytes = static_cast<double>(file.bytes.size()) * static_cast<double>(bench.iterations());
  bench.counters["MB/s"] = benchmark::Counter(bytes / 1e6, benchmark::Counter::kIsRate);
  bench.counters["MB"] = static_cast<double>(file.bytes.size()) / 1e6;
}

// Pairs of SMC, four digits each, repeat their times in so long a record.
bool is_long_enough(const testing::GeneratedFile& file) {
  return !(file.format == "smc" && file.takes_step);
}

const bool registered = [] {
  testing::samples = long_record;
  for (const testing::GeneratedFile& file : testing::generated_files())
    if (is_long_enough(file))
      benchmark::RegisterBenchmark(("read/" + file.format).c_str(), [file](benchmark::State& bench) {
        read_file(bench, file);
      })->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace dougong::seismic
