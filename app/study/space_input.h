// The message loop of `dougong space`: a scene entered message by message, from a keyboard or a text.
//
//   cir charge  velocity x y  spin  mass  centre x y  radius          ... finish  [record]  n
//
// All values are bare numbers in SI units. From a keyboard a wrong value is asked for again, with the reason;
// in a text it is an error with its line. Stars are point masses: with the first of them uniform gravity ends
// and every body attracts every other.
#pragma once

#include <functional>

#include "app/study/scene_description.h"
#include "app/study/space_words.h"

namespace dougong::app {

inline constexpr double real_gravitational_constant = 6.67430e-11;  // m3/(kg s2), CODATA 2018
inline constexpr double space_tick = 0.01;                          // s; the step is a tick over n
inline constexpr double space_friction = 0.5;                       // of the usual concrete

struct SpaceRules {
  bool earthquake = false;  // a record's name follows finish and moves all terrain
  std::string material;     // a preset; empty: concrete with friction space_friction
  /// Throws seismic::InputError for a record that cannot be read.
  std::function<void(const MotionChoice&)> try_record;
};

struct SpaceInput {
  SceneDescription description;
  double divisor = 10.0;                // n
  std::vector<std::string> save_paths;  // of `save`
};

/// Throws seismic::InputError: source and line, what was expected, what was found; ScenarioError for a
/// material that does not exist.
SpaceInput read_space(SpaceWords& words, const SpaceRules& rules);

/// Gives the scene the step space_tick / n, or, where that is above the stability bound, half the bound. Says
/// which. Throws as prepare_scene().
std::string choose_space_step(SceneDescription& description, double divisor,
                              const std::filesystem::path& records_directory);

}  // namespace dougong::app
