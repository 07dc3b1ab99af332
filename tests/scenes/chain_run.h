// A chain of storeys with a ratio for every mode on a recorded motion: by the engine, as a bonded shear
// building, and exactly, by superposition of its modes.
#pragma once

#include "seismic/measures/oscillator.h"
#include "tests/scenes/modal_chain.h"
#include "tests/scenes/record_motion.h"
#include "tests/scenes/running.h"

namespace dougong::scenes {

struct ChainHistory {
  double interval = 0.0;                          // s
  std::vector<std::vector<double>> displacement;  // by floor, then by time, m, over the ground
};

/// Each interval of the record is cut into `parts`, over which it stays linear.
inline ChainHistory by_superposition(const std::vector<oracles::ChainLevel>& levels,
                                     const std::vector<double>& ratios,
                                     const std::vector<double>& acceleration, double interval, int parts) {
  std::vector<double> fine;
  for (std::size_t k = 0; k + 1 < acceleration.size(); ++k)
    for (int p = 0; p < parts; ++p)
      fine.push_back(acceleration[k] + (acceleration[k + 1] - acceleration[k]) * p / parts);
  fine.push_back(acceleration.back());
  const ModalChain chain = modal_chain(levels);
  ChainHistory history{interval / parts, {}};
  history.displacement.assign(levels.size(), std::vector<double>(fine.size(), 0.0));
  for (Eigen::Index j = 0; j < chain.mass.size(); ++j) {
    const seismic::Oscillator oscillator{2.0 * std::numbers::pi / chain.frequency[j],
                                         ratios[static_cast<std::size_t>(j)]};
    const auto q = seismic::oscillator_response(fine, history.interval, oscillator).displacement;
    const double participation = chain.mass.dot(chain.shape.col(j));
    for (std::size_t i = 0; i < levels.size(); ++i)
      for (std::size_t k = 0; k < q.size(); ++k)
        history.displacement[i][k] += participation * chain.shape(static_cast<Eigen::Index>(i), j) * q[k];
  }
  return history;
}

inline ChainHistory by_engine(const std::vector<oracles::ChainLevel>& levels,
                              const std::vector<double>& ratios, const std::vector<double>& acceleration,
                              double interval, double output) {
  const auto motion = record_motion(acceleration, interval);
  engine::Scene scene = shear_building_scene(levels, motion);
  add_modal_damping(scene, modal_damping(modal_chain(levels), ratios));
  Running r(scene);
  const Running start = r;
  ChainHistory history{output, std::vector<std::vector<double>>(levels.size())};
  const double duration = interval * static_cast<double>(acceleration.size() - 1);
  const engine::RunOutcome end = r.run(run_for(duration, output), [&](const engine::Sample& sample) {
    const double ground = motion->at(sample.state.time).displacement.x;
    for (std::size_t i = 0; i < levels.size(); ++i)
      history.displacement[i].push_back(r.position(i).x - start.position(i).x - ground);
    return engine::Wish::go_on;
  });
  if (end.outcome != engine::Outcome::completed) throw std::runtime_error(end.detail);
  return history;
}

/// What a shear frame of equal storey heights is asked for.
struct FramePeaks {
  std::vector<double> drift;                             // m, of each storey
  double roof = 0.0, base_shear = 0.0, top_shear = 0.0;  // m, N, N
  double base_moment = 0.0;                              // N m
};

inline FramePeaks peaks_of(const ChainHistory& h, const std::vector<oracles::ChainLevel>& levels,
                           double storey) {
  FramePeaks peaks;
  peaks.drift.resize(levels.size());
  const auto larger = [](double& most, double value) { most = std::max(most, std::abs(value)); };
  for (std::size_t k = 0; k < h.displacement[0].size(); ++k) {
    double moment = 0.0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double drift = h.displacement[i][k] - (i > 0 ? h.displacement[i - 1][k] : 0.0);
      const double shear = levels[i].stiffness * drift;
      larger(peaks.drift[i], drift);
      moment += storey * shear;
      if (i == 0) larger(peaks.base_shear, shear);
      if (i + 1 == levels.size()) larger(peaks.top_shear, shear);
    }
    larger(peaks.base_moment, moment);
    larger(peaks.roof, h.displacement.back()[k]);
  }
  return peaks;
}

}  // namespace dougong::scenes
