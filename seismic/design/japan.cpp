#include "seismic/design/japan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

double bedrock_level_1(double period) {
  if (period < 0.16) return 0.64 + 6.0 * period;
  return period <= 0.64 ? 1.6 : 1.024 / period;
}

double ground_factor(int ground, double period) {
  if (ground == 0) return 1.0;
  if (ground == 1) return period <= 0.576 ? 1.5 : period <= 0.64 ? 0.864 / period : 1.35;
  return std::clamp(1.5 * period / 0.64, 1.5, ground == 2 ? 2.025 : 2.7);
}

struct Bridge {
  double rising, plateau, falling;  // m/s2, with T in s
};
// By type of earthquake and ground.
constexpr std::array<std::array<Bridge, 3>, 2> bridges = {
    {{{{25.79, 14.0, 8.4}, {21.53, 13.0, 11.7}, {17.19, 12.0, 16.8}}},
     {{{44.63, 20.0, 11.04}, {32.24, 17.5, 23.71}, {23.81, 15.0, 29.48}}}}};

void require(bool holds, const char* expected, int found) {
  if (!holds) throw InputError("target spectrum", 0, expected, std::to_string(found));
}

}  // namespace

double surface_acceleration(const JapaneseBuilding& s, double period) {
  const double level = s.level == 2 ? 5.0 : 1.0;
  return s.zone_factor * level * bedrock_level_1(period) * ground_factor(s.ground, period);
}

DesignSpectrum design_spectrum(const JapaneseBuilding& s) {
  require(s.level == 1 || s.level == 2, "level 1 (rare) or 2 (extremely rare)", s.level);
  require(s.ground >= 0 && s.ground <= 3, "ground type 1, 2 or 3, or 0 for the bedrock", s.ground);
  DesignSpectrum out;
  out.name = fmt::format("Japan, level {}, {}, Z {:g}", s.level,
                         s.ground == 0 ? "engineering bedrock" : fmt::format("ground type {}", s.ground),
                         s.zone_factor);
  out.clause = "Notifications 1461 and 1457 (2000)";
  out.acceleration = [s](double period) { return surface_acceleration(s, period); };
  return out;
}

double bridge_acceleration(const JapaneseBridge& s, double period) {
  const Bridge& b = bridges[static_cast<std::size_t>(s.type - 1)][static_cast<std::size_t>(s.ground - 1)];
  const double power = s.type == 1 ? 1.0 / 3.0 : 2.0 / 3.0;
  return std::min({b.rising * std::pow(period, power), b.plateau,
                   b.falling * std::pow(period, power - (s.type == 1 ? 4.0 : 7.0) / 3.0)});
}

DesignSpectrum design_spectrum(const JapaneseBridge& s) {
  require(s.type == 1 || s.type == 2, "type 1 (subduction) or 2 (inland)", s.type);
  require(s.ground >= 1 && s.ground <= 3, "ground type 1, 2 or 3", s.ground);
  DesignSpectrum out;
  out.name = fmt::format("JRA 2017, level 2, type {}, ground type {}", s.type, s.ground);
  out.clause = "JRA 2017, part V";
  out.acceleration = [s](double period) { return bridge_acceleration(s, period); };
  return out;
}

}  // namespace dougong::seismic
