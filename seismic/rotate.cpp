#include "seismic/rotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "seismic/constants.h"
#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

constexpr double closest = 5.0;  // degrees between two directions that still tell the motion

double radians(double degrees) {
  return degrees * two_pi / 360.0;
}

// sin and cos that are exact at the quarters, so that turning by 90 degrees changes no bit.
std::pair<double, double> cos_sin(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0.0) return {1.0, 0.0};
  if (turned == 90.0) return {0.0, 1.0};
  if (turned == -90.0) return {0.0, -1.0};
  if (std::abs(turned) == 180.0) return {-1.0, 0.0};
  return {std::cos(radians(turned)), std::sin(radians(turned))};
}

std::vector<const Record*> horizontal_pair(const RecordSet& set) {
  std::vector<const Record*> pair;
  for (const Record& record : set.components)
    if (record.axis == Axis::horizontal && record.azimuth && pair.size() < 2) pair.push_back(&record);
  return pair;
}

Record turned(const Record& model, const NorthEast& motion, double azimuth, const std::string& from) {
  Record record = model;
  record.acceleration = rotate(motion.north, motion.east, azimuth);
  record.azimuth = std::fmod(std::fmod(azimuth, 360.0) + 360.0, 360.0);
  record.component = fmt::format("{:g}", *record.azimuth);
  record.axis = Axis::horizontal;
  record.processing.push_back(fmt::format("rotated: {} to {} degrees from north", from, record.component));
  return record;
}

}  // namespace

std::vector<double> rotate(std::span<const double> north, std::span<const double> east, double azimuth) {
  const auto [cosine, sine] = cos_sin(azimuth);
  std::vector<double> out(std::min(north.size(), east.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = north[i] * cosine + east[i] * sine;
  return out;
}

NorthEast north_east(std::span<const double> first, double azimuth_of_first, std::span<const double> second,
                     double azimuth_of_second) {
  const double apart = std::abs(std::remainder(azimuth_of_first - azimuth_of_second, 180.0));
  if (!(apart >= closest)) throw std::invalid_argument("components in one direction do not tell the motion");
  const auto [c1, s1] = cos_sin(azimuth_of_first);
  const auto [c2, s2] = cos_sin(azimuth_of_second);
  const double determinant = c1 * s2 - c2 * s1;
  NorthEast out;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    out.north.push_back((first[i] * s2 - second[i] * s1) / determinant);
    out.east.push_back((second[i] * c1 - first[i] * c2) / determinant);
  }
  return out;
}

RecordSet rotated(const RecordSet& set, double azimuth) {
  const auto pair = horizontal_pair(set);
  const std::string file = set.components.empty() ? "records" : set.components.front().provenance.file;
  if (pair.size() < 2)
    throw InputError(file, 0, "two horizontal components of known direction", fmt::format("{}", pair.size()));
  const std::string from = fmt::format("{} ({:g}) and {} ({:g})", pair[0]->component, *pair[0]->azimuth,
                                       pair[1]->component, *pair[1]->azimuth);
  if (std::abs(std::remainder(*pair[0]->azimuth - *pair[1]->azimuth, 180.0)) < closest)
    throw InputError(file, 0, "two horizontal components in different directions", from);
  const NorthEast motion =
      north_east(pair[0]->acceleration, *pair[0]->azimuth, pair[1]->acceleration, *pair[1]->azimuth);
  RecordSet out;
  out.warnings = set.warnings;
  out.components.push_back(turned(*pair[0], motion, azimuth, from));
  out.components.push_back(turned(*pair[1], motion, azimuth + 90.0, from));
  for (const Record& record : set.components)
    if (record.axis == Axis::vertical) out.components.push_back(record);
  return out;
}

}  // namespace dougong::seismic
