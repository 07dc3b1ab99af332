#include "seismic/orientation.h"

#include <cctype>
#include <cmath>
#include <string>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

std::string letters_and_digits(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '.')
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return plain;
}

// "EW2": with the digit of a borehole or surface sensor.
bool names_a_sensor(const std::string& plain) {
  return plain.size() == 3 && std::isalpha(static_cast<unsigned char>(plain[1])) &&
         (plain[2] == '1' || plain[2] == '2');
}

std::string without_sensor(std::string plain) {
  if (names_a_sensor(plain)) plain.pop_back();
  return plain;
}

double positive_angle(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0.0 ? turned + 360.0 : turned;
}

// "N08W": from north (or south) so many degrees towards west (or east).
std::optional<double> bearing(const std::string& plain) {
  if (plain.size() < 3 || (plain[0] != 'N' && plain[0] != 'S')) return std::nullopt;
  if (plain.back() != 'E' && plain.back() != 'W') return std::nullopt;
  const auto turn = parse_number(std::string_view(plain).substr(1, plain.size() - 2));
  if (!turn || *turn < 0.0 || *turn > 90.0) return std::nullopt;
  const bool north = plain[0] == 'N', east = plain.back() == 'E';
  return positive_angle((north ? 0.0 : 180.0) + (north == east ? *turn : -*turn));
}

std::optional<double> degrees(std::string plain) {
  if (plain.ends_with("DEG")) plain.resize(plain.size() - 3);
  if (plain.empty() || !std::isdigit(static_cast<unsigned char>(plain[0]))) return std::nullopt;
  const auto angle = parse_number(plain);
  if (!angle || *angle > 360.0) return std::nullopt;
  return positive_angle(*angle);
}

std::optional<double> compass_point(const std::string& name) {
  // SEED channels of accelerometers: band, instrument N (or L, G), direction.
  if (name.size() == 3 && name[1] == 'N' && name.back() == 'N') return 0.0;
  if (name.size() == 3 && name[1] == 'N' && name.back() == 'E') return 90.0;
  if (name == "N" || name == "NS" || name == "NORTH") return 0.0;
  if (name == "E" || name == "EW" || name == "EAST") return 90.0;
  if (name == "S" || name == "SN" || name == "SOUTH") return 180.0;
  if (name == "W" || name == "WE" || name == "WEST") return 270.0;
  return std::nullopt;
}

}  // namespace

std::optional<double> azimuth_of(std::string_view component) {
  if (axis_of(component) == Axis::vertical) return std::nullopt;
  if (component.starts_with("-") && component.find_first_not_of("-0123456789.") == std::string_view::npos)
    return std::nullopt;
  const std::string plain = letters_and_digits(component);
  if (const auto angle = bearing(plain)) return angle;
  if (const auto angle = degrees(plain)) return angle;
  return compass_point(without_sensor(plain));
}

bool is_component(const Record& record, std::string_view asked) {
  const std::string own = letters_and_digits(record.component), wanted = letters_and_digits(asked);
  if (own == wanted || (names_a_sensor(own) && names_a_sensor(wanted))) return own == wanted;
  if (without_sensor(own) == without_sensor(wanted)) return true;
  const auto azimuth = azimuth_of(asked);
  if (!azimuth || !record.azimuth || record.axis == Axis::vertical) return false;
  return std::abs(std::remainder(*azimuth - *record.azimuth, 360.0)) <= 0.5;
}

}  // namespace dougong::seismic
