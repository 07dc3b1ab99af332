// The loop of peak_kernels.h as a template on an instruction set: its vector of doubles, with the magnitude
// and the larger of two, lane by lane.
#pragma once

#include "seismic/measures/peak_kernels.h"

namespace dougong::seismic {

template <class Set>
struct PeakLanes {
  using R = typename Set::Lanes;
  static constexpr std::size_t lanes = sizeof(R) / sizeof(double);
  static constexpr std::size_t block = lanes * Set::side_by_side;

  struct Group {
    R uu{}, uv{}, ua{}, ub{}, vu{}, vv{}, va{}, vb{}, twice_damping{};
    R u{}, v{};
    R displacement{}, velocity{}, acceleration{};
  };

  [[gnu::always_inline]] static void load(Group* groups, const PeakOscillator* oscillators,
                                          std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      Group& g = groups[i / lanes];
      const std::size_t lane = i % lanes;
      const OscillatorStep& s = oscillators[i].step;
      Set::put(g.uu, lane, s.uu), Set::put(g.uv, lane, s.uv);
      Set::put(g.ua, lane, s.ua), Set::put(g.ub, lane, s.ub);
      Set::put(g.vu, lane, s.vu), Set::put(g.vv, lane, s.vv);
      Set::put(g.va, lane, s.va), Set::put(g.vb, lane, s.vb);
      Set::put(g.twice_damping, lane, oscillators[i].twice_damping);
    }
  }

  template <bool All>
  [[gnu::always_inline]] static void advance(Group& g, R a0, R a1) {
    const R u = (g.uu * g.u + g.uv * g.v) + (g.ua * a0 + g.ub * a1);
    g.v = (g.vu * g.u + g.vv * g.v) + (g.va * a0 + g.vb * a1);
    g.u = u;
    g.displacement = Set::larger(g.displacement, Set::magnitude(g.u));
    if constexpr (All) {
      g.velocity = Set::larger(g.velocity, Set::magnitude(g.v));
      g.acceleration = Set::larger(g.acceleration, Set::magnitude(g.u + g.twice_damping * g.v));
    }
  }

  [[gnu::always_inline]] static void store(const Group* groups, std::size_t count, OscillatorPeaks* peaks) {
    for (std::size_t i = 0; i < count; ++i) {
      const Group& g = groups[i / lanes];
      const std::size_t lane = i % lanes;
      peaks[i] = {Set::get(g.displacement, lane), Set::get(g.velocity, lane), Set::get(g.acceleration, lane)};
    }
  }

  template <bool All>
  static void find(const PeakCall& call) {
    for (std::size_t first = 0; first < call.count; first += block) {
      const std::size_t count = call.count - first < block ? call.count - first : block;
      Group groups[Set::side_by_side];  // empty lanes stay zero
      load(groups, call.oscillators + first, count);
      for (std::size_t k = 1; k < call.samples; ++k) {
        const R a0 = R{} + call.acceleration[k - 1], a1 = R{} + call.acceleration[k];
        for (Group& group : groups) advance<All>(group, a0, a1);
      }
      store(groups, count, call.peaks + first);
    }
  }

  static PeakKernel kernel(const char* name) { return {name, find<true>, find<false>}; }
};

}  // namespace dougong::seismic
