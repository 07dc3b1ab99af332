// The laboratory frame of comparison M03: three storeys of aluminium on a small table.
//
// Manohar and Venkatesha, Development of experimental setups for earthquake engineering education, Indian
// Institute of Science (2006).
#pragma once

#include <array>

#include "tests/scenes/modal_chain.h"
#include "tests/scenes/running.h"

namespace dougong::scenes {

struct PublishedMode {
  double frequency;             // rad/s
  std::array<double, 3> shape;  // mass-normalised, from below
  double ratio;                 // of the damping, measured
};
inline constexpr std::array<PublishedMode, 3> laboratory_modes{{{17.894, {0.2464, 0.4416, 0.5451}, 0.0243},
                                                                {49.748, {0.5401, 0.2132, -0.4560}, 0.0093},
                                                                {71.120, {0.4181, -0.5356, 0.2679}, 0.0067}}};

inline std::vector<oracles::ChainLevel> laboratory_levels() {
  return {{.mass = 1.8965, .stiffness = 2923.7},
          {.mass = 1.8965, .stiffness = 2923.7},
          {.mass = 1.7338, .stiffness = 2923.7}};
}

struct Decay {
  std::vector<double> cycles, swing;  // time over the period; modal coordinate over its first peak
  double ratio = 0.0;                 // by the logarithmic decrement
};

/// Let go with the speeds of a mode alone, every mode damped as it was measured.
inline Decay decay_of_mode(std::size_t mode, int cycles = 10) {
  constexpr std::size_t outputs = 400;  // a cycle
  const ModalChain chain = modal_chain(laboratory_levels());
  engine::Scene scene = shear_building_scene(laboratory_levels(), nullptr);
  std::vector<double> ratios;
  for (const PublishedMode& m : laboratory_modes) ratios.push_back(m.ratio);
  add_modal_damping(scene, modal_damping(chain, ratios));
  Running r(scene);
  const Running start = r;
  const auto j = static_cast<Eigen::Index>(mode);
  const auto weight = [&](std::size_t i) { return chain.shape(static_cast<Eigen::Index>(i), j); };
  for (std::size_t i = 0; i < 3; ++i) r.state.v()[i] = 0.1 * weight(i);
  const double period = 2.0 * std::numbers::pi / chain.frequency[j];
  Decay decay;
  r.run(run_for(cycles * period, period / outputs), [&](const engine::Sample& sample) {
    double q = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      q += r.model.mass[i] * weight(i) * (r.position(i).x - start.position(i).x);
    decay.cycles.push_back(sample.state.time / period), decay.swing.push_back(q);
    return engine::Wish::go_on;
  });
  const auto greatest = [&](int cycle) {
    const auto from = decay.swing.begin() + static_cast<std::ptrdiff_t>(outputs) * cycle;
    return *std::max_element(from, from + static_cast<std::ptrdiff_t>(outputs));
  };
  const double first = greatest(0), decrement = std::log(first / greatest(cycles - 1)) / (cycles - 1);
  decay.ratio = decrement / std::hypot(2.0 * std::numbers::pi, decrement);
  for (double& q : decay.swing) q /= first;
  return decay;
}

}  // namespace dougong::scenes
