// Quantities as text: "0.4 g", "2.9 m", "25 GPa", "15 deg", "2400 kg/m3" to SI and back.
//
// The reader says which dimension it expects. A bare number for a quantity with a unit is an error that
// lists the possible units; so is a unit of another dimension. Counts and ratios are bare numbers; a
// ratio may also be written in percent. The units themselves are a table in structures/units.h.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "structures/units.h"

namespace dougong::app {

using structures::Dimension;

class QuantityError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The value in SI and radians. Throws QuantityError.
double parse_quantity(std::string_view text, Dimension dimension);
/// "0.4 g". Parsing it gives the same double back.
std::string print_quantity(double value, Dimension dimension);

}  // namespace dougong::app
