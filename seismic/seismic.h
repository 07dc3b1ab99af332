// The module seismic, as a table of contents: from a file to the motion of the ground.
//
//   read_record -> RecordSet -> condition -> ConditionedMotion -> ground_motion -> GroundMotion
#pragma once

#include "seismic/catalogue.h"                        // the shipped recordings
#include "seismic/conditioning/baseline.h"            // least-squares baselines, an end at rest
#include "seismic/conditioning/butterworth.h"         // zero-phase and causal filters
#include "seismic/conditioning/condition.h"           // every step from record to motion
#include "seismic/conditioning/resample.h"            // another time step
#include "seismic/conditioning/taper.h"               // windows and pads
#include "seismic/constants.h"                        // g
#include "seismic/describe.h"                         // facts and measures of a record
#include "seismic/design/asce7.h"                     // ASCE 7-16
#include "seismic/design/eurocode8.h"                 // EN 1998-1
#include "seismic/design/gb50011.h"                   // GB 50011-2010
#include "seismic/design/japan.h"                     // Building Standard Law, highway bridges
#include "seismic/design/scaling.h"                   // factors to a target, suites
#include "seismic/design/spectrum_table.h"            // targets of the user
#include "seismic/formats/format.h"                   // the table of formats
#include "seismic/formats/write_record.h"             // records to files
#include "seismic/input_error.h"                      // what is wrong with an input
#include "seismic/measures/bilinear_oscillator.h"     // yielding oscillators, constant ductility
#include "seismic/measures/fourier_spectrum.h"        // Fourier amplitude, mean period
#include "seismic/measures/instrumental_intensity.h"  // JMA, GB/T 17742, MMI
#include "seismic/measures/integrate.h"               // velocity and displacement
#include "seismic/measures/intensity.h"               // Arias, CAV, durations
#include "seismic/measures/oscillator.h"              // exact oscillator response
#include "seismic/measures/peaks.h"                   // peaks, mean, rms
#include "seismic/measures/response_spectrum.h"       // Sd, Sv, Sa, PSa
#include "seismic/measures/rotated.h"                 // RotD, other angles
#include "seismic/measures/spectrum_intensity.h"      // Housner, ASI, VSI, average Sa
#include "seismic/motions/ground_motion.h"            // a record as prescribed motion
#include "seismic/motions/harmonic_motion.h"          // sine from rest
#include "seismic/motions/pulse_motion.h"             // rectangular pulses
#include "seismic/orientation.h"                      // which way a component points
#include "seismic/read_record.h"                      // files to records
#include "seismic/record.h"                           // what a record is
#include "seismic/rotate.h"                           // horizontal pairs to any direction
#include "seismic/stations.h"                         // channels by station
#include "seismic/synthesis/compatible_motion.h"      // motions that follow a target spectrum
#include "seismic/synthesis/finite_fault.h"           // stochastic motion of a rupture
#include "seismic/synthesis/point_source.h"           // stochastic motion of one patch
#include "seismic/synthesis/pulses.h"                 // pulses, sweeps, noise
#include "seismic/synthesis/scenario.h"               // the shipped earthquakes
#include "seismic/synthesis/shipped.h"                // the shipped files
#include "seismic/units.h"                            // units of files
