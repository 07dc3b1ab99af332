// What vectors of oscillators gain: 5 % spectra at 200 periods of a record of 300 s at 100 Hz, by the loop
// over one oscillator at a time that most programs have, and by every kernel this machine can run; in turn,
// the least of some rounds each.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>

#include "seismic/measures/peak_kernels.h"
#include "seismic/measures/response_spectrum.h"
#include "seismic/synthesis/random.h"
#include "tests/bench/alternate.h"

namespace dougong::bench {
namespace {

constexpr std::size_t periods = 200, samples = 30001;
constexpr double interval = 0.01;  // s

// Nigam and Jennings as it is usually written: one oscillator after the other, all three peaks.
[[gnu::noinline]] void one_by_one(const seismic::PeakCall& call) {
  for (std::size_t i = 0; i < call.count; ++i) {
    const seismic::OscillatorStep& c = call.oscillators[i].step;
    double u = 0.0, v = 0.0, most_u = 0.0, most_v = 0.0, most_a = 0.0;
    for (std::size_t k = 1; k < call.samples; ++k) {
      const double next = c.uu * u + c.uv * v + c.ua * call.acceleration[k - 1] + c.ub * call.acceleration[k];
      v = c.vu * u + c.vv * v + c.va * call.acceleration[k - 1] + c.vb * call.acceleration[k];
      u = next;
      most_u = std::max(most_u, std::abs(u));
      most_v = std::max(most_v, std::abs(v));
      most_a = std::max(most_a, std::abs(u + call.oscillators[i].twice_damping * v));
    }
    call.peaks[i] = {most_u, most_v, most_a};
  }
}

double microseconds(void (*find)(const seismic::PeakCall&), const seismic::PeakCall& call) {
  const auto start = std::chrono::steady_clock::now();
  find(call);
  benchmark::DoNotOptimize(call.peaks[0].displacement);
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

void spectra(benchmark::State& bench) {
  const std::vector<double> a = seismic::gaussian_noise(1, 0, samples);
  std::vector<seismic::PeakOscillator> oscillators;
  for (const double period : seismic::log_spaced_periods(0.02, 10.0, periods))
    oscillators.push_back({seismic::scaled_oscillator_step({period, 0.05}, interval), 0.1});
  std::vector<seismic::OscillatorPeaks> peaks(periods);
  const seismic::PeakCall call{a.data(), samples, oscillators.data(), periods, peaks.data()};
  std::vector<Contestant> contestants{{"one by one", [&] { return microseconds(one_by_one, call); }}};
  for (const seismic::PeakKernel& kernel : seismic::supported_peak_kernels()) {
    contestants.push_back({std::string(kernel.name), [&] { return microseconds(kernel.all, call); }});
    contestants.push_back(
        {std::string(kernel.name) + "_psa_alone", [&] { return microseconds(kernel.displacement, call); }});
  }
  for (auto _ : bench) alternate(contestants, 15);
  constexpr double work = static_cast<double>(periods * (samples - 1));
  for (const Contestant& c : contestants) {
    bench.counters[c.name + "_ns"] = 1e3 * c.least / work;
    bench.counters[c.name + "_gain"] = contestants.front().least / c.least;
  }
}

BENCHMARK(spectra)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dougong::bench
