// Recordings as a user has them: a three-component K-NET set read and conditioned, and a folder of a hundred
// records summarised on one thread and two; beside the plain program that one would write for it (streams, a
// section of the filter after the other, one oscillator after the other; the mean period by the same
// transform), in turn and with the same flags.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "app/study/record_list.h"
#include "seismic/seismic.h"
#include "tests/bench/alternate.h"

namespace dougong::bench {
namespace {

namespace fs = std::filesystem;

// Of processor time: what else runs on the machine counts little.
template <class Work>
double processor_time(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <class Work>
double elapsed_time(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

// --- the plain program ---------------------------------------------------------------------------------

struct Plain {
  std::vector<double> a;  // m/s2
  double interval = 0.0;
};

Plain read_knet_plainly(const fs::path& path) {
  std::ifstream in(path);
  Plain out;
  double scale = 0.0;
  for (std::string line; std::getline(in, line) && !line.starts_with("Memo");) {
    if (line.starts_with("Sampling")) out.interval = 1.0 / std::stod(line.substr(18));
    if (line.starts_with("Scale"))
      scale = 0.01 * std::stod(line.substr(18)) / std::stod(line.substr(line.find('/') + 1));
  }
  double sum = 0.0;
  for (double count; in >> count;) out.a.push_back(count * scale), sum += out.a.back();
  for (double& a : out.a) a -= sum / static_cast<double>(out.a.size());
  return out;
}

Plain read_at2_plainly(const fs::path& path) {
  std::ifstream in(path);
  Plain out;
  std::string line;
  for (int i = 0; i < 4; ++i) std::getline(in, line);
  out.interval = std::stod(line.substr(line.find("DT=") + 3));
  for (double value; in >> value;) out.a.push_back(value * seismic::standard_gravity);
  return out;
}

void one_pass(const std::vector<seismic::Section>& sections, std::vector<double>& x, bool back) {
  for (const seismic::Section& s : sections) {
    double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      double& now = x[back ? x.size() - 1 - k : k];
      const double y = s.b0 * now + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
      x2 = x1, x1 = now, y2 = y1, y1 = y, now = y;
    }
  }
}

// Mean, taper, pads, band pass forward and backward, velocity and displacement.
double condition_plainly(Plain record) {
  std::vector<double>& a = record.a;
  const auto ramp = static_cast<std::size_t>(2.0 / record.interval);
  for (std::size_t k = 0; k < ramp; ++k) {
    const double w =
        0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(ramp));
    a[k] *= w, a[a.size() - 1 - k] *= w;
  }
  const auto pad = static_cast<std::size_t>(30.0 / record.interval);
  std::vector<double> padded(a.size() + 2 * pad, 0.0);
  std::copy(a.begin(), a.end(), padded.begin() + static_cast<std::ptrdiff_t>(pad));
  const auto sections = seismic::butterworth({0.1, 25.0, 4}, record.interval);
  one_pass(sections, padded, false);
  one_pass(sections, padded, true);
  double v = 0.0, d = 0.0, most = 0.0;
  for (std::size_t k = 1; k < padded.size(); ++k) {
    d += record.interval * v + record.interval * record.interval * (2 * padded[k - 1] + padded[k]) / 6;
    v += 0.5 * record.interval * (padded[k - 1] + padded[k]);
    most = std::max(most, std::abs(d));
  }
  return most;
}

double summarise_plainly(const Plain& record, const std::vector<double>& periods) {
  double result = seismic::mean_period(record.a, record.interval), v = 0.0, square = 0.0;
  std::vector<double> husid;
  for (std::size_t k = 1; k < record.a.size(); ++k) {
    v += 0.5 * record.interval * (record.a[k - 1] + record.a[k]);
    square += record.a[k] * record.a[k];
    husid.push_back(square);
    result = std::max({result, std::abs(v), std::abs(record.a[k])});
  }
  for (const double share : {0.05, 0.95})
    for (std::size_t k = 0; k < husid.size(); ++k)
      if (husid[k] >= share * square) {
        result += static_cast<double>(k);
        break;
      }
  for (const double period : periods) {
    const seismic::OscillatorStep c = seismic::oscillator_step({period, 0.05}, record.interval);
    double u = 0.0, w = 0.0, most = 0.0;
    for (std::size_t k = 1; k < record.a.size(); ++k) {
      const double next = c.uu * u + c.uv * w + c.ua * record.a[k - 1] + c.ub * record.a[k];
      w = c.vu * u + c.vv * w + c.va * record.a[k - 1] + c.vb * record.a[k];
      u = next;
      most = std::max(most, std::abs(u));
    }
    result += most;
  }
  return result;
}

// --- side by side --------------------------------------------------------------------------------------

void compare(benchmark::State& bench, std::vector<Contestant> contestants, int rounds) {
  for (auto _ : bench) alternate(contestants, rounds);
  for (const Contestant& c : contestants) {
    bench.counters[c.name + "_ms"] = 1e-3 * c.least;
    bench.counters[c.name + "_gain"] = contestants.front().least / c.least;
  }
}

void knet_set(benchmark::State& bench) {
  const fs::path stem = fs::path(DOUGONG_RECORDS_DIRECTORY) / "tohoku-synthetic.EW";
  const auto plain = [&] {
    for (const char* end : {".EW", ".NS", ".UD"})
      benchmark::DoNotOptimize(condition_plainly(read_knet_plainly(fs::path(stem).replace_extension(end))));
  };
  const auto ours = [&] { benchmark::DoNotOptimize(seismic::condition(seismic::read_record(stem))); };
  const auto reading = [&] { benchmark::DoNotOptimize(seismic::read_record(stem)); };
  compare(bench,
          {{"plain", [&] { return processor_time(plain); }},
           {"dougong", [&] { return processor_time(ours); }},
           {"reading_alone", [&] { return processor_time(reading); }}},
          60);
}

const std::vector<double> periods = {0.2, 0.5, 1.0, 2.0};  // s

// A hundred copies of a shipped record, for as long as it lives.
struct Hundred {
  fs::path folder = fs::temp_directory_path() / fmt::format("hundred-{}", ::getpid());
  std::vector<fs::path> files;
  Hundred() {
    fs::create_directories(folder);
    for (int i = 0; i < 100; ++i)
      fs::copy_file(fs::path(DOUGONG_RECORDS_DIRECTORY) / "wenchuan-synthetic-EW.at2",
                    folder / fmt::format("r{:02}.at2", i), fs::copy_options::overwrite_existing);
    files = app::files_below(folder);
  }
  Hundred(const Hundred&) = delete;
  ~Hundred() { fs::remove_all(folder); }
  void list(std::size_t jobs) const { benchmark::DoNotOptimize(app::list_records(files, periods, jobs)); }
};

void hundred_records(benchmark::State& bench) {
  const Hundred records;
  const auto plain = [&] {
    for (const fs::path& file : records.files)
      benchmark::DoNotOptimize(summarise_plainly(read_at2_plainly(file), periods));
  };
  compare(bench,
          {{"plain", [&] { return processor_time(plain); }},
           {"one_thread", [&] { return processor_time([&] { records.list(1); }); }}},
          8);
}

// Elapsed time, so only on a machine that is otherwise idle does it tell.
void hundred_records_on_two_cores(benchmark::State& bench) {
  const Hundred records;
  compare(bench,
          {{"one_thread", [&] { return elapsed_time([&] { records.list(1); }); }},
           {"two_threads", [&] { return elapsed_time([&] { records.list(2); }); }}},
          12);
}

BENCHMARK(knet_set)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(hundred_records)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(hundred_records_on_two_cores)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dougong::bench
