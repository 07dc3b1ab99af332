// What changes during a run: the motion of every body, what the contacts remember, the work done so far.
#pragma once

#include <string>

#include "engine/bonds/bonds.h"
#include "engine/bonds/joints.h"
#include "engine/contact/contact_set.h"

namespace dougong::engine {

/// Work since the start of the run (J), cumulated by the integrator.
struct Work {
  double input = 0.0;       // done by the moving terrain on the bodies
  double damping = 0.0;     // taken by the dashpots
  double tangential = 0.0;  // taken by the tangential forces less their dashpots: stored slip and friction
  double bonds = 0.0;       // taken by the springs of bonds: stored, and lost to fracture, yield and friction
  double stagger = 0.0;     // kinetic energy at the ends of steps beyond the method's own (velocity_verlet.h)
};

struct State {
  double time = 0.0;  // s
  /// [x | y | angle | vx | vy | spin], each body_count long; positions relative to the model's origin.
  std::vector<double> y;
  ContactSet contacts;
  BondState bonds;
  std::vector<JointPast> joints;
  Work work;
  double deepest_ratio = 0.0;  // deepest overlap so far over the smaller body's minimum width
  double deepest_time = 0.0;   // s
  BodyPair deepest_pair;

  std::span<double> q() { return std::span(y).first(y.size() / 2); }
  std::span<double> v() { return std::span(y).last(y.size() / 2); }
  std::span<const double> q() const { return std::span(y).first(y.size() / 2); }
  std::span<const double> v() const { return std::span(y).last(y.size() / 2); }
};

/// The state the scene describes, at t = 0, with its contacts found.
State initial_state(const Model& model, const Scene& scene);
/// All frames, bodies and terrains, of a state: those of all bodies, then those of the terrains.
void place_all(const Model& model, const State& state, bool terrain_held_still, std::span<Frame> frames,
               Crew& crew = Crew::alone());
std::vector<Frame> frames_of(const Model& model, const State& state, bool terrain_held_still = false);
/// 64-bit FNV-1a of the bits of time and motion, as 16 hexadecimal digits.
std::string state_hash(const State& state);

}  // namespace dougong::engine
