// Horizontal motion in another direction.
//
//   a(θ) = a_n cos θ + a_e sin θ,   θ clockwise from north
//
// Two components that are not at right angles determine the motion as well, unless they are parallel: with
// u_i = (cos α_i, sin α_i) their directions, a_i = u_i . a is solved for a = (a_n, a_e).
#pragma once

#include <span>
#include <vector>

#include "seismic/record.h"

namespace dougong::seismic {

/// Acceleration along `azimuth` (degrees clockwise from north) of motions north and east, as many samples
/// each.
std::vector<double> rotate(std::span<const double> north, std::span<const double> east, double azimuth);

struct NorthEast {
  std::vector<double> north, east;
};

/// From components along two azimuths (degrees). They must differ by 5 degrees at least, modulo 180; closer
/// ones throw std::invalid_argument.
NorthEast north_east(std::span<const double> first, double azimuth_of_first, std::span<const double> second,
                     double azimuth_of_second);

/// The set with its first two horizontal components of known azimuth turned to `azimuth` and 90 degrees
/// beyond, named so; the rest is left out but for the vertical ones. Throws InputError when there are no two
/// such.
RecordSet rotated(const RecordSet& set, double azimuth);

}  // namespace dougong::seismic
