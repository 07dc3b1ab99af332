// Experiment M01: the granite boulder under measured motions of a shaking table, as a plane block whose
// restitution is given; by the contact engine, beside the event-driven solution of the rigid block. Prints
// one line a run and the counts.
//
//     granite_boulder FOLDER [E_in_GPa] [damping_ratio] [alpha] [p] [restitution]
//
// FOLDER holds index.csv and the motions TestNNN.AT2 (g, 200 Hz).
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "seismic/read_record.h"
#include "tests/oracles/driven_rocking.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/rocking.h"

namespace {

using namespace dougong;

struct Trial {
  std::string name;
  bool overturned = false;     // as tested
  std::vector<double> ground;  // m/s2
  double interval = 0.0;       // s
  oracles::RockingHistory by_engine, by_events;
};

struct Block {
  double alpha = 0.06, p = 5.0, restitution = 0.70;
  double young_modulus = 300e9, damping_ratio = 2.0;

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
    trial.overturned = cells.at(4) == "1";
    const auto set = seismic::read_record(folder + "/" + trial.name + ".AT2");
    trial.ground = set.horizontal().acceleration, trial.interval = set.horizontal().interval;
    trials.push_back(std::move(trial));
  }
  return trials;
}

constexpr double rest = 5.0;  // s, after the motion

void run(const Block& block, Trial& trial) {
  const oracles::RockingBlock rigid = block.rigid();
  const double duration = trial.interval * static_cast<double>(trial.ground.size() - 1);
  trial.by_events =
      oracles::DrivenRocking(
          rigid, [&](double t) { return oracles::interpolated(trial.ground, trial.interval, t); },
          trial.interval / 5.0)
          .run(duration + rest);
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

void print_counts(const char* name, const std::vector<Trial>& trials,
                  oracles::RockingHistory Trial::*history) {
  int stands = 0, overturned = 0, false_alarms = 0, misses = 0;
  for (const Trial& t : trials) {
    const bool fell = (t.*history).overturned;
    ++(t.overturned ? (fell ? overturned : misses) : (fell ? false_alarms : stands));
  }
  fmt::print("{}: right {} stands, {} overturned; {} false alarms, {} misses: {:.1f} % right\n", name, stands,
             overturned, false_alarms, misses,
             100.0 * (stands + overturned) / static_cast<double>(trials.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2)
    return fmt::print("granite_boulder FOLDER [E in GPa] [damping ratio] [alpha] [p] [restitution]\n"), 2;
  const auto argument = [&](int i, double value) { return argc > i ? std::atof(argv[i]) : value; };
  const Block block{.alpha = argument(4, 0.06),
                    .p = argument(5, 5.0),
                    .restitution = argument(6, 0.70),
                    .young_modulus = 1e9 * argument(2, 300.0),
                    .damping_ratio = argument(3, 2.0)};
  std::vector<Trial> trials = read_trials(argv[1]);
  run_all(block, trials);
  for (const Trial& t : trials)
    fmt::print("{} measured {} engine {} events {}  greatest angle {:.4f} {:.4f}\n", t.name, t.overturned,
               t.by_engine.overturned, t.by_events.overturned, t.by_engine.greatest_angle,
               t.by_events.greatest_angle);
  print_counts("contact engine", trials, &Trial::by_engine);
  print_counts("rigid block, event by event", trials, &Trial::by_events);
}
