// From records to the motion of the ground, every step said with its numbers.
//
//   cut -> offset -> baseline -> taper -> pad, Butterworth, pads cut back -> resample -> rest -> scale ->
//   integrate
//
// Why each step, and why these defaults:
//   offset   a constant error of acceleration becomes a parabola of displacement
//   taper    the filter would answer to a jump at the ends
//   filter   below 0.1 Hz an accelerograph records noise that integrates to metres of displacement; above
//            25 Hz there is little motion. A record that its publisher filtered keeps its upper band.
//   pads     a zero-phase filter answers before the first sample and after the last; its zeros must be long
//            enough for that answer to die: 1.5 order/(2 f) each side (Converse & Brady 1992, 1.5 order/f in
//            all). The building need not stand through them: they are cut back to `kept_pad` and the
//            displacement d is faded in and out over it by a smooth step w: the acceleration becomes
//            w a + 2 w' v + w'' d, so that the ground starts and ends at rest where it was.
//   phase    forward and backward: no shift of phase; forward alone (causal) nothing moves before the first
//            sample, and -3 dB at the corners for -6
//   rest     a record that is not filtered, or whose pads are not kept, may end at rest by a quintic
//   displacement
//            taken off over its whole length (baseline.h)
//   scale    last, so that the PGA asked for is that of the motion applied; one factor for all components,
//            from the horizontal one. A dimensionless record must be given a target.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seismic/conditioning/resample.h"
#include "seismic/input_error.h"
#include "seismic/measures/integrate.h"
#include "seismic/motions/ground_motion.h"
#include "seismic/record.h"

namespace dougong::seismic {

enum class OffsetRemoval { none, whole_record_mean, pre_event_mean };
/// acceleration_line and velocity_parabola are the polynomials of degree 1 of acceleration and 2 of velocity.
enum class BaselineCorrection {
  none,
  acceleration_line,
  velocity_parabola,
  acceleration_polynomial,
  velocity_polynomial
};
enum class FilterPhase { zero, causal };
enum class EndRule { as_it_is, at_rest };

struct ConditioningOptions {
  std::optional<double> from, to;  // s of the record; unset: all of it

  OffsetRemoval offset = OffsetRemoval::whole_record_mean;
  double pre_event = 5.0;  // s at the start, for pre_event_mean; before the first arrival
  BaselineCorrection baseline = BaselineCorrection::none;
  int baseline_degree = 3;  // of the polynomials: 0 to 6 of acceleration, 1 to 6 of velocity

  double taper_fraction = 0.05;  // of the duration, each end; 0 for none
  double longest_taper = 2.0;    // s; 5 % of a long record would reach into the shaking

  bool filter = true;
  FilterPhase phase = FilterPhase::zero;
  int order = 4;                          // of the prototype; both passes together -6 dB at the corners
  std::optional<double> high_pass = 0.1;  // Hz; unset: no lower corner
  std::optional<double>
      low_pass;  // Hz; unset: 25, or none for a processed record or where 25 is above 0.9 Nyquist
  std::optional<double> pad;  // s of zeros each side; unset: 1.5 order/(2 high_pass)
  double kept_pad = 5.0;      // s of them kept each side, over which the displacement is faded

  std::optional<double> target_pga;    // m/s2, of the horizontal motion applied
  std::optional<double> scale_factor;  // instead of a target

  std::optional<double> interval;  // s, step wanted; unset: the record's own
  ResampleMethod resample_method = ResampleMethod::fft;

  EndRule end = EndRule::as_it_is;

  bool vertical = true;  // apply the vertical component where the station has one

  bool keep_stages = false;  // for plots of before and after
};

/// The horizontal component behind one step.
struct ConditioningStage {
  std::string step;  // "read", "offset", "filter" ...
  double interval = 0.0;
  double lead = 0.0;                 // s before the record's first sample
  std::vector<double> acceleration;  // m/s2
};

struct ConditionedMotion {
  std::string title;  // "event / station / component"
  double interval = 0.0;
  double lead = 0.0;               // s of ground motion before the record's first sample (the kept pad)
  std::vector<double> horizontal;  // m/s2
  std::optional<std::vector<double>> vertical;  // m/s2
  double scale_factor = 1.0;                    // in all, of the values read
  double record_interval = 0.0;                 // s, of the samples read
  std::optional<double> high_pass, low_pass;    // Hz, corners of the filter as it was applied
  double residual_velocity = 0.0;               // m/s, horizontal, at the last sample
  double residual_displacement = 0.0;           // m
  std::vector<std::string> processing;          // reader's and conditioner's steps in order
  std::vector<std::string> warnings;            // reader's and conditioner's
  std::vector<ConditioningStage> stages;        // those that changed something; empty unless asked for

  GroundMotion ground_motion(const EndOptions& end = {}) const;
};

/// Throws InputError for options that contradict one another or the record.
ConditionedMotion condition(const RecordSet& records, const ConditioningOptions& options = {});

/// What a building of this period (s) must be told: a record with fewer than ten samples in its period, a
/// high-pass corner that takes away its frequency (PEER: usable above 1.25 of the corner), a low pass below
/// it.
std::vector<std::string> building_warnings(const ConditionedMotion& motion, double period);

}  // namespace dougong::seismic
