// Units: how a number with a dimension is written. Inside, every value is SI (and radians); a unit
// exists where a value is printed or read, and this table is the only place that knows the factors.
//
//   value in SI = number * multiply / divide      (two factors, so that "2.5 mm" is 2.5/1000 exactly)
//
// Counts and ratios have no unit and are written as bare numbers; a ratio may also be read in percent.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dougong::structures {

enum class Dimension {
  count,
  ratio,
  length,
  time,
  frequency,
  speed,
  acceleration,
  angle,
  mass,
  density,
  pressure,
  force,
  stiffness,
  charge,
  spin,
  damping,
  quadratic_drag,
  rotational_stiffness,
  areal_stiffness,
  fracture_energy,
  moment_of_inertia,
  electric_field,
  gravitational_constant,
  coulomb_constant,
};

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double multiply = 1.0;
  double divide = 1.0;
  /// Magnitudes (SI) for which a value is printed in this unit: from least up to below. An empty
  /// range belongs to a unit that is understood but not written.
  double least = 0.0;
  double below = 0.0;

  double to_si(double number) const { return number * multiply / divide; }
};

std::span<const Unit> units();
/// "length", "acceleration" ...
std::string_view name_of(Dimension dimension);
/// False for counts and ratios: a bare number is complete.
bool has_unit(Dimension dimension);
/// The units of a dimension as a sentence lists them: "m, mm, cm, km".
std::string possible_units(Dimension dimension);

/// The shortest decimal that reads back as the same double: "0.3", "30", "1e-07".
std::string print_number(double value);
/// A value with its unit, "0.3 m", "30 GPa", "15 deg". Reading it back gives the same double.
std::string print_value(double value, Dimension dimension);

}  // namespace dougong::structures
