#include "structures/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace dougong::structures {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double g = 9.80665;  // m/s2, standard gravity
constexpr double pi = std::numbers::pi;

using enum Dimension;

// Where two units of a dimension may both be written, the shorter text wins and the earlier on a tie.
constexpr Unit table[] = {
    {"m", length, 1, 1, 0.1, endless},
    {"mm", length, 1, 1e3, 0, 0.1},
    {"cm", length, 1, 1e2},
    {"km", length, 1e3, 1},
    {"s", time, 1, 1, 0.1, endless},
    {"ms", time, 1, 1e3, 0, 0.1},
    {"min", time, 60, 1},
    {"Hz", frequency, 1, 1, 0, endless},
    {"kHz", frequency, 1e3, 1},
    {"m/s", speed, 1, 1, 0.1, endless},
    {"mm/s", speed, 1, 1e3, 0, 0.1},
    {"cm/s", speed, 1, 1e2},
    {"g", acceleration, g, 1, 0, endless},
    {"m/s2", acceleration, 1, 1, 0, endless},
    {"m/s^2", acceleration, 1, 1},
    {"m/s²", acceleration, 1, 1},
    {"cm/s2", acceleration, 1, 1e2},
    {"gal", acceleration, 1, 1e2},
    {"deg", angle, pi, 180, 0, endless},
    {"°", angle, pi, 180},
    {"rad", angle, 1, 1, 0, endless},
    {"mrad", angle, 1, 1e3},
    {"kg", mass, 1, 1, 0, 1e4},
    {"t", mass, 1e3, 1, 1e4, endless},
    {"kg/m3", density, 1, 1, 0, endless},
    {"kg/m^3", density, 1, 1},
    {"kg/m³", density, 1, 1},
    {"t/m3", density, 1e3, 1},
    {"g/cm3", density, 1e3, 1},
    {"Pa", pressure, 1, 1, 0, 1e3},
    {"kPa", pressure, 1e3, 1, 1e3, 1e6},
    {"MPa", pressure, 1e6, 1, 1e6, 1e9},
    {"GPa", pressure, 1e9, 1, 1e9, endless},
    {"N/mm2", pressure, 1e6, 1},
    {"N", force, 1, 1, 0, 1e3},
    {"kN", force, 1e3, 1, 1e3, 1e6},
    {"MN", force, 1e6, 1, 1e6, endless},
    {"N/m", stiffness, 1, 1, 0, 1e3},
    {"kN/m", stiffness, 1e3, 1, 1e3, 1e6},
    {"MN/m", stiffness, 1e6, 1, 1e6, 1e9},
    {"GN/m", stiffness, 1e9, 1, 1e9, endless},
    {"N/mm", stiffness, 1e3, 1},
    {"C", charge, 1, 1, 0, endless},
    {"mC", charge, 1, 1e3},
    {"uC", charge, 1, 1e6},
    {"nC", charge, 1, 1e9},
    {"rad/s", spin, 1, 1, 0, endless},
    {"deg/s", spin, pi, 180},
    {"rpm", spin, pi, 30},
    {"N s/m", damping, 1, 1, 0, 1e3},
    {"kN s/m", damping, 1e3, 1, 1e3, endless},
    {"N s2/m2", quadratic_drag, 1, 1, 0, endless},
    {"kg/m", quadratic_drag, 1, 1},
    {"N m/rad", rotational_stiffness, 1, 1, 0, 1e3},
    {"kN m/rad", rotational_stiffness, 1e3, 1, 1e3, 1e6},
    {"MN m/rad", rotational_stiffness, 1e6, 1, 1e6, endless},
    {"Pa/m", areal_stiffness, 1, 1, 0, 1e6},
    {"MPa/m", areal_stiffness, 1e6, 1, 1e6, 1e9},
    {"GPa/m", areal_stiffness, 1e9, 1, 1e9, endless},
    {"J/m2", fracture_energy, 1, 1, 0, endless},
    {"N/m", fracture_energy, 1, 1},
    {"kg m2", moment_of_inertia, 1, 1, 0, endless},
    {"V/m", electric_field, 1, 1, 0, 1e3},
    {"kV/m", electric_field, 1e3, 1, 1e3, endless},
    {"N/C", electric_field, 1, 1},
    {"m3/(kg s2)", gravitational_constant, 1, 1, 0, endless},
    {"N m2/kg2", gravitational_constant, 1, 1},
    {"N m2/C2", coulomb_constant, 1, 1, 0, endless},
    {"%", ratio, 1, 100},
};

double read(std::string_view digits) {
  double number = 0.0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// The shortest text that this unit turns into exactly the value; empty when there is none.
std::string text_in(const Unit& unit, double value) {
  const double estimate = value * unit.divide / unit.multiply;
  std::array<char, 64> text;
  for (int digits = 1; digits <= 17; ++digits) {
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), estimate, std::chars_format::general, digits);
    const double number = read({text.data(), end.ptr});
    if (unit.to_si(number) == value) return print_number(number) + " " + std::string(unit.symbol);
  }
  return {};
}

bool is_written_in(const Unit& unit, double value) {
  const double magnitude = std::abs(value);
  if (magnitude == 0.0) return unit.least < unit.below;
  return unit.least <= magnitude && magnitude < unit.below;
}

std::string si_symbol(Dimension dimension) {
  for (const Unit& unit : table)
    if (unit.dimension == dimension && unit.multiply == 1.0 && unit.divide == 1.0)
      return std::string(unit.symbol);
  return {};
}

}  // namespace

std::span<const Unit> units() {
  return table;
}

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case count:
      return "count";
    case ratio:
      return "ratio";
    case length:
      return "length";
    case time:
      return "time";
    case frequency:
      return "frequency";
    case speed:
      return "speed";
    case acceleration:
      return "acceleration";
    case angle:
      return "angle";
    case mass:
      return "mass";
    case density:
      return "density";
    case pressure:
      return "pressure or modulus";
    case force:
      return "force";
    case stiffness:
      return "stiffness";
    case charge:
      return "charge";
    case spin:
      return "spin";
    case damping:
      return "damping coefficient";
    case quadratic_drag:
      return "quadratic drag";
    case rotational_stiffness:
      return "rotational stiffness";
    case areal_stiffness:
      return "stiffness per area";
    case fracture_energy:
      return "energy per area";
    case moment_of_inertia:
      return "moment of inertia";
    case electric_field:
      return "electric field";
    case gravitational_constant:
      return "gravitational constant";
    case coulomb_constant:
      return "Coulomb constant";
  }
  return "unknown";
}

bool has_unit(Dimension dimension) {
  return dimension != count && dimension != ratio;
}

std::string possible_units(Dimension dimension) {
  std::string list;
  for (const Unit& unit : table)
    if (unit.dimension == dimension) list += (list.empty() ? "" : ", ") + std::string(unit.symbol);
  return list;
}

std::string print_number(double value) {
  std::array<char, 64> text;
  // Plain digits where they are readable: 20000 rather than 2e+04.
  const double magnitude = std::abs(value);
  const bool plain = magnitude == 0.0 || (magnitude >= 1e-4 && magnitude < 1e7);
  const auto end =
      plain ? std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed)
            : std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string print_value(double value, Dimension dimension) {
  if (!has_unit(dimension)) return print_number(value);
  std::string best;
  for (const Unit& unit : table) {
    if (unit.dimension != dimension || !is_written_in(unit, value)) continue;
    const std::string text = text_in(unit, value);
    if (!text.empty() && (best.empty() || text.size() < best.size())) best = text;
    if (value == 0.0 && !best.empty()) break;  // nothing is zero kilograms, not zero tonnes
  }
  // Not exact in any unit that is written, or not finite: the SI unit changes no digit.
  return best.empty() ? print_number(value) + " " + si_symbol(dimension) : best;
}

}  // namespace dougong::structures
