// What a building costs under a record of 40 s: a frame of 60 bonded blocks, a dry wall of 1020 soft bricks
// (S1), an ensemble of 16 on one thread and on two. Processor time, but for the ensemble, whose gain is of
// the clock.
#include <benchmark/benchmark.h>

#include <ctime>

#include "app/study/ensemble.h"
#include "app/study/stopwatch.h"
#include "tests/app/study/study_cases.h"
#include "tests/bench/peak_memory.h"

namespace dougong::app {
namespace {

Preparation prepared(std::vector<std::string> words) {
  for (const char* word : {"record=kobe", "solve.duration=40 s", "rate=50 Hz"}) words.emplace_back(word);
  return testing::prepared(words);
}

void shake(benchmark::State& bench, const std::vector<std::string>& words) {
  for (auto _ : bench) {
    const Stopwatch ready;
    Preparation p = prepared(words);
    bench.counters["prepare_cpu_s"] = ready.cpu();
    const RunResult run = execute(p, "");
    bench.counters["blocks"] = static_cast<double>(p.model.body_count);
    bench.counters["steps"] = static_cast<double>(run.numerics.steps);
    bench.counters["cpu_s_per_s"] = run.reproducibility.cpu_seconds / run.numerics.end_time;
    bench.counters["energy_error"] = run.energy.relative_error;
    bench.counters["peak_MB"] = bench::peak_megabytes();
  }
}

void frame_of_60_blocks(benchmark::State& bench) {
  shake(bench, {"layout=concrete-frame", "storeys=2", "bays=2", "pga=0.5 g"});
}
BENCHMARK(frame_of_60_blocks)->Iterations(1)->Unit(benchmark::kSecond);

void wall_of_1000_bricks(benchmark::State& bench) {
  shake(bench, {"layout=brick-wall", "courses=40", "bricks_per_course=25", "brick_length=0.25 m",
                "brick_height=62.5 mm", "young_modulus=100 MPa", "pga=0.3 g"});
}
BENCHMARK(wall_of_1000_bricks)->Iterations(1)->Unit(benchmark::kSecond);

// Argument: threads.
void ensemble_of_16(benchmark::State& bench) {
  for (auto _ : bench) {
    Preparation p = prepared({"layout=concrete-frame", "storeys=2", "bays=2", "pga=0.5 g", "ensemble.n=16",
                              "ensemble.half_step=false"});
    const RunResult described = execute(p, "");
    const Stopwatch members;
    const EnsembleSheet sheet = run_ensemble(p, described, static_cast<std::size_t>(bench.range(0)));
    bench.counters["members"] = static_cast<double>(sheet.members.size());
    bench.counters["wall_s"] = members.wall();
    bench.counters["peak_MB"] = bench::peak_megabytes();
  }
}
BENCHMARK(ensemble_of_16)->Arg(1)->Arg(2)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
}  // namespace dougong::app
