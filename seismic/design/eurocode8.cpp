#include "seismic/design/eurocode8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

constexpr double longest = 4.0;  // s

struct Ground {
  double soil, tb, tc, td;
};
// Tables 3.2 (type 1) and 3.3 (type 2), grounds A to E.
constexpr std::array<std::array<Ground, 5>, 2> grounds = {{{{{1.0, .15, .4, 2.0},
                                                             {1.2, .15, .5, 2.0},
                                                             {1.15, .20, .6, 2.0},
                                                             {1.35, .20, .8, 2.0},
                                                             {1.4, .15, .5, 2.0}}},
                                                           {{{1.0, .05, .25, 1.2},
                                                             {1.35, .05, .25, 1.2},
                                                             {1.5, .10, .25, 1.2},
                                                             {1.8, .10, .30, 1.2},
                                                             {1.6, .05, .25, 1.2}}}}};

std::size_t row_of(int type) {
  if (type != 1 && type != 2)
    throw InputError("Eurocode 8", 0, "a spectrum of type 1 or 2", std::to_string(type));
  return static_cast<std::size_t>(type - 1);
}

}  // namespace

double elastic_spectrum(const Eurocode8& s, double period) {
  const double eta = std::max(0.55, std::sqrt(10.0 / (5.0 + 100.0 * s.damping_ratio)));
  const double ground = s.ground_acceleration * s.soil, top = s.plateau * eta;
  if (period < s.tb) return ground * (1.0 + period / s.tb * (top - 1.0));
  if (period <= s.tc) return ground * top;
  if (period <= s.td) return ground * top * s.tc / period;
  return ground * top * s.tc * s.td / (period * period);
}

DesignSpectrum design_spectrum(const Eurocode8& s) {
  DesignSpectrum out;
  out.name =
      fmt::format("{}, ag {:.4g} m/s2, {:g} %", s.title, s.ground_acceleration, 100.0 * s.damping_ratio);
  out.clause = "EN 1998-1:2004, 3.2.2.2";
  out.longest_period = longest;
  out.damping_ratio = s.damping_ratio;
  out.acceleration = [s](double period) { return elastic_spectrum(s, period); };
  return out;
}

Eurocode8 eurocode8(int type, const std::string& ground, double ground_acceleration, double damping_ratio) {
  const std::size_t row = row_of(type);
  if (ground.size() != 1 || ground[0] < 'A' || ground[0] > 'E')
    throw InputError("Eurocode 8", 0, "a ground type from A to E", "\"" + ground + "\"");
  const Ground& g = grounds[row][static_cast<std::size_t>(ground[0] - 'A')];
  return {ground_acceleration,
          g.soil,
          g.tb,
          g.tc,
          g.td,
          damping_ratio,
          2.5,
          fmt::format("Eurocode 8, type {}, ground {}", type, ground)};
}

Eurocode8 eurocode8_vertical(int type, double horizontal, double damping_ratio) {
  constexpr std::array<double, 2> share = {0.90, 0.45};
  return {share[row_of(type)] * horizontal,
          1.0,
          0.05,
          0.15,
          1.0,
          damping_ratio,
          3.0,
          fmt::format("Eurocode 8, vertical, type {}", type)};
}

}  // namespace dougong::seismic
