// M01: the granite boulder under measured motions of a shaking table, as a plane block whose restitution is
// given; by the contact engine, beside the event-driven solution of the rigid block.
//
//     comparisons M01 FOLDER MOTIONS [E_in_GPa] [damping_ratio] [alpha] [p] [restitution]
//
// MOTIONS holds index.csv and the motions TestNNN.AT2 (g, 200 Hz).
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "seismic/read_record.h"
#include "tests/bench/comparisons/comparison.h"
#include "tests/oracles/driven_rocking.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/rocking.h"

namespace dougong::comparisons {
namespace {

struct Trial {
  std::string name;
  double pga = 0.0, pgv_over_pga = 0.0;  // g, s: as published
  bool overturned = false;               // as tested
  std::vector<double> ground;            // m/s2
  double interval = 0.0;                 // s
  oracles::RockingHistory by_engine, by_events;
};

struct Block {
  double young_modulus = 30e9, damping_ratio = 1.0;
  double alpha = 0.06, p = 5.0, restitution = 0.70;

  oracles::RockingBlock rigid() const {
    const double g = 9.81, radius = 0.75 * g / (p * p);
    oracles::RockingBlock block{radius * std::sin(alpha), radius * std::cos(alpha), g};
    block.restitution = restitution;
    return block;
  }
};

std::vector<Trial> read_trials(const std::string& folder) {
  std::vector<Trial> trials;
  std::ifstream index(folder + "/index.csv");
  std::string line;
  std::getline(index, line);
  while (std::getline(index, line)) {
    std::vector<std::string> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    Trial trial;
    trial.name = fmt::format("Test{:0>3}", cells.at(0));
    trial.pga = std::stod(cells.at(2)), trial.pgv_over_pga = std::stod(cells.at(3));
    trial.overturned = cells.at(4) == "1";
    const auto set = seismic::read_record(folder + "/" + trial.name + ".AT2");
    trial.ground = set.horizontal().acceleration, trial.interval = set.horizontal().interval;
    trials.push_back(std::move(trial));
  }
  if (trials.empty()) throw std::runtime_error("no trials in " + folder + "/index.csv");
  return trials;
}

void run(const Block& block, Trial& trial) {
  constexpr double rest = 5.0;  // s, after the motion
  const oracles::RockingBlock rigid = block.rigid();
  const double duration = trial.interval * static_cast<double>(trial.ground.size() - 1);
  const auto ground = [&](double t) { return oracles::interpolated(trial.ground, trial.interval, t); };
  trial.by_events = oracles::DrivenRocking(rigid, ground, trial.interval / 5.0).run(duration + rest);
  auto shaken =
      scenes::rocking_run(rigid, block.young_modulus, block.damping_ratio,
                          scenes::record_motion(trial.ground, trial.interval), duration, duration + rest);
  shaken.scene.materials[0].rocking_restitution = block.restitution;
  trial.by_engine = scenes::measured_rocking(shaken);
}

void run_all(const Block& block, std::vector<Trial>& trials) {
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < trials.size(); k = next++) run(block, trials[k]);
    });
  for (std::thread& thread : threads) thread.join();
}

std::string counts(const char* name, const std::vector<Trial>& trials,
                   oracles::RockingHistory Trial::*history) {
  int stands = 0, overturned = 0, false_alarms = 0, misses = 0;
  for (const Trial& t : trials) {
    const bool fell = (t.*history).overturned;
    ++(t.overturned ? (fell ? overturned : misses) : (fell ? false_alarms : stands));
  }
  return fmt::format("| {} | {} | {} | {} | {} | {:.1f} % |\n", name, stands, overturned, false_alarms,
                     misses, 100.0 * (stands + overturned) / static_cast<double>(trials.size()));
}

std::string table(const std::vector<Trial>& trials) {
  std::string out =
      "| | right: stands | right: overturned | false alarms | misses | right |\n"
      "|---|---|---|---|---|---|\n";
  out += counts("contact engine", trials, &Trial::by_engine);
  out += counts("rigid block, event by event", trials, &Trial::by_events);
  out += "\nThe two differ in";
  for (const Trial& t : trials)
    if (t.by_engine.overturned != t.by_events.overturned)
      out += fmt::format(" {} ({})", t.name, t.by_engine.overturned ? "engine overturns" : "engine stands");
  return out + "\n";
}

std::string points(const std::vector<Trial>& trials, bool tested, bool computed) {
  std::string out;
  for (const Trial& t : trials)
    if (t.overturned == tested && t.by_engine.overturned == computed)
      out += fmt::format("{:.6g} {:.6g}\n", t.pgv_over_pga, t.pga);
  return out.empty() ? "NaN NaN\n" : out;
}

app::Figure figure_of(const std::vector<Trial>& trials) {
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

Block block_of(const Arguments& arguments) {
  Block block;
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
  std::vector<Trial> trials = read_trials(arguments[0]);
  run_all(block_of(arguments), trials);
  return {table(trials), figure_of(trials)};
}

}  // namespace dougong::comparisons
