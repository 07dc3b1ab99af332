// M01: the granite boulder under measured motions of a shaking table, as a plane block whose restitution is
// given; by the contact engine, beside the event-driven solution of the rigid block.
//
//     comparisons M01 FOLDER MOTIONS [E_in_GPa] [damping_ratio] [alpha] [p] [restitution]
//
// MOTIONS holds index.csv and the motions TestNNN.AT2 (g, 200 Hz).
#include <fmt/format.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/granite_boulder.h"

namespace dougong::comparisons {
namespace {

using Trials = std::vector<scenes::BoulderTrial>;

void run_all(const scenes::Boulder& block, Trials& trials) {
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < trials.size(); k = next++) scenes::run_boulder(block, trials[k]);
    });
  for (std::thread& thread : threads) thread.join();
}

std::string counts(const char* name, const Trials& trials,
                   oracles::RockingHistory scenes::BoulderTrial::*history) {
  int stands = 0, overturned = 0, false_alarms = 0, misses = 0;
  for (const scenes::BoulderTrial& t : trials) {
    const bool fell = (t.*history).overturned;
    ++(t.overturned ? (fell ? overturned : misses) : (fell ? false_alarms : stands));
  }
  return fmt::format("| {} | {} | {} | {} | {} | {:.1f} % |\n", name, stands, overturned, false_alarms,
                     misses, 100.0 * (stands + overturned) / static_cast<double>(trials.size()));
}

std::string table(const Trials& trials) {
  std::string out =
      "| | right: stands | right: overturned | false alarms | misses | right |\n"
      "|---|---|---|---|---|---|\n";
  out += counts("contact engine", trials, &scenes::BoulderTrial::by_engine);
  out += counts("rigid block, event by event", trials, &scenes::BoulderTrial::by_events);
  out += "\nThe two differ in";
  for (const scenes::BoulderTrial& t : trials)
    if (t.by_engine.overturned != t.by_events.overturned)
      out += fmt::format(" {} ({})", t.name, t.by_engine.overturned ? "engine overturns" : "engine stands");
  return out + "\n";
}

std::string points(const Trials& trials, bool tested, bool computed) {
  std::string out;
  for (const scenes::BoulderTrial& t : trials)
    if (t.overturned == tested && t.by_engine.overturned == computed)
      out += fmt::format("{:.6g} {:.6g}\n", t.pgv_over_pga, t.pga);
  return out.empty() ? "NaN NaN\n" : out;
}

app::Figure figure_of(const Trials& trials) {
  app::Figure figure;
  figure.data["stands"] = points(trials, false, false), figure.data["overturns"] = points(trials, true, true);
  figure.data["alarms"] = points(trials, false, true), figure.data["misses"] = points(trials, true, false);
  figure.script = look +
                  "set logscale xy\nset xrange [0.0095:0.3]\nset yrange [0.015:2.5]\n"
                  "set xlabel 'PGV/PGA (s)'\nset ylabel 'PGA (g)'\n"
                  "plot exp(-(19.385 + 4.708*log(x))/4.310) with lines lw 1.2 dt 2 lc rgb '#777777' "
                  "title 'half overturn (fit to the tests)', "
                  "'stands' using 1:2 with points pt 6 ps 0.6 lc rgb '#888888' title 'stands: right', "
                  "'overturns' using 1:2 with points pt 7 ps 0.6 lc rgb '" +
                  app::to_hex(app::category(0)) +
                  "' title 'overturns: right', "
                  "'alarms' using 1:2 with points pt 9 ps 1 lc rgb '" +
                  app::to_hex(app::category(1)) +
                  "' title 'false alarm', "
                  "'misses' using 1:2 with points pt 11 ps 1 lc rgb '" +
                  app::to_hex(app::category(2)) + "' title 'miss'\n";
  return figure;
}

scenes::Boulder block_of(const Arguments& arguments) {
  scenes::Boulder block;
  const auto read = [&](std::size_t i, double& value, double unit = 1.0) {
    if (i < arguments.size()) value = unit * std::stod(arguments[i]);
  };
  read(1, block.young_modulus, 1e9), read(2, block.damping_ratio);
  read(3, block.alpha), read(4, block.p), read(5, block.restitution);
  return block;
}

}  // namespace

Comparison granite_boulder(const Arguments& arguments) {
  if (arguments.empty()) throw std::runtime_error("M01 wants the folder of the table's motions");
  Trials trials = scenes::read_boulder_trials(arguments[0]);
  run_all(block_of(arguments), trials);
  return {table(trials), figure_of(trials)};
}

}  // namespace dougong::comparisons
