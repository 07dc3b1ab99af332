#include "seismic/motions/harmonic_motion.h"

#include <cmath>

#include "seismic/constants.h"

namespace dougong::seismic {

HarmonicMotion::HarmonicMotion(double amplitude, double frequency, engine::Vec2 direction)
    : amplitude_(amplitude), angular_frequency_(two_pi * frequency), direction_(direction) {}

engine::MotionSample HarmonicMotion::at(double t) const {
  if (!(t >= 0.0)) return {};
  const double w = angular_frequency_, sine = std::sin(w * t), half = std::sin(0.5 * w * t);
  return {amplitude_ / w * (t - sine / w) * direction_, amplitude_ / w * 2.0 * half * half * direction_,
          amplitude_ * sine * direction_};
}

}  // namespace dougong::seismic
