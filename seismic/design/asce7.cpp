#include "seismic/design/asce7.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "seismic/constants.h"
#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

constexpr double study = std::numeric_limits<double>::quiet_NaN();  // 11.4.8 asks for one

using Row = std::array<double, 6>;
constexpr Row ss_at = {.25, .5, .75, 1.0, 1.25, 1.5}, s1_at = {.1, .2, .3, .4, .5, .6};
// Tables 11.4-1 and 11.4-2 of the 2016 edition, classes A to E.
constexpr std::array<Row, 5> fa = {{{.8, .8, .8, .8, .8, .8},
                                    {.9, .9, .9, .9, .9, .9},
                                    {1.3, 1.3, 1.2, 1.2, 1.2, 1.2},
                                    {1.6, 1.4, 1.2, 1.1, 1.0, 1.0},
                                    {2.4, 1.7, 1.3, study, study, study}}};
constexpr std::array<Row, 5> fv = {{{.8, .8, .8, .8, .8, .8},
                                    {.8, .8, .8, .8, .8, .8},
                                    {1.5, 1.5, 1.5, 1.5, 1.5, 1.4},
                                    {2.4, 2.2, 2.0, 1.9, 1.8, 1.7},
                                    {4.2, study, study, study, study, study}}};

double interpolated(const Row& at, const Row& values, double x) {
  if (x <= at.front()) return values.front();
  if (x >= at.back()) return values.back();
  std::size_t i = 1;
  while (at[i] < x) ++i;
  if (at[i] == x) return values[i];
  return values[i - 1] + (values[i] - values[i - 1]) * (x - at[i - 1]) / (at[i] - at[i - 1]);
}

}  // namespace

double design_acceleration(const Asce7& s, double period) {
  const double ts = s.sd1 / s.sds, t0 = 0.2 * ts;
  if (period < t0) return s.sds * (0.4 + 0.6 * period / t0);
  if (period <= ts) return s.sds;
  if (period <= s.long_period) return s.sd1 / period;
  return s.sd1 * s.long_period / (period * period);
}

DesignSpectrum design_spectrum(const Asce7& s) {
  DesignSpectrum out;
  out.name = fmt::format("ASCE 7-16, SDS {:.4g}, SD1 {:.4g} g, TL {:g} s", s.sds, s.sd1, s.long_period);
  out.clause = "11.4.6";
  out.acceleration = [s](double period) { return standard_gravity * design_acceleration(s, period); };
  return out;
}

Asce7 asce7_16(double ss, double s1, const std::string& site_class, double long_period) {
  if (site_class.size() != 1 || site_class[0] < 'A' || site_class[0] > 'E')
    throw InputError("ASCE 7-16", 0, "a site class from A to E", "\"" + site_class + "\"");
  const auto row = static_cast<std::size_t>(site_class[0] - 'A');
  const double a = interpolated(ss_at, fa[row], ss), v = interpolated(s1_at, fv[row], s1);
  if (!(a > 0.0 && v > 0.0))
    throw InputError("ASCE 7-16", 0,
                     "SS below 1 g and S1 below 0.2 g for class E (11.4.8 asks for a study of the site)",
                     fmt::format("SS {:g} g, S1 {:g} g", ss, s1));
  return {2.0 / 3.0 * a * ss, 2.0 / 3.0 * v * s1, long_period};
}

bool needs_site_study(double s1, const std::string& site_class) {
  return (site_class == "D" || site_class == "E") && s1 >= 0.2;
}

}  // namespace dougong::seismic
