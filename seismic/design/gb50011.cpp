#include "seismic/design/gb50011.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "seismic/constants.h"
#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

constexpr double longest = 6.0;       // s
constexpr double rare_period = 0.05;  // s, added to Tg (5.1.4; GB 18306-2015, 7.2.2)

constexpr std::array<const char*, 6> intensities = {"6", "7", "7.5", "8", "8.5", "9"};
constexpr std::array<const char*, 3> levels = {"frequent", "design", "rare"};
constexpr std::array<const char*, 5> classes = {"I0", "I1", "II", "III", "IV"};

// Table 5.1.4-1 by level and intensity; the design level by 2.25 times the basic acceleration.
constexpr std::array<std::array<double, 6>, 3> alpha_max = {
    {{.04, .08, .12, .16, .24, .32}, {.12, .23, .34, .45, .68, .90}, {.28, .50, .72, .90, 1.20, 1.40}}};
// Table 5.1.4-2 by group and site class, s.
constexpr std::array<std::array<double, 5>, 3> characteristic = {
    {{.20, .25, .35, .45, .65}, {.25, .30, .40, .55, .75}, {.30, .35, .45, .65, .90}}};

template <std::size_t N>
std::size_t place(const std::array<const char*, N>& names, const std::string& word, const char* what) {
  for (std::size_t i = 0; i < N; ++i)
    if (word == names[i]) return i;
  std::string known;
  for (const char* name : names) known += (known.empty() ? "" : ", ") + std::string(name);
  throw InputError("GB 50011", 0, fmt::format("{}: {}", what, known), "\"" + word + "\"");
}

}  // namespace

double influence_coefficient(const Gb50011& s, double period) {
  const double z = s.damping_ratio, tg = s.characteristic_period;
  const double gamma = 0.9 + (0.05 - z) / (0.3 + 6.0 * z);
  const double eta1 = std::max(0.0, 0.02 + (0.05 - z) / (4.0 + 32.0 * z));
  const double eta2 = std::max(0.55, 1.0 + (0.05 - z) / (0.08 + 1.6 * z));
  if (period <= 0.1) return s.alpha_max * (0.45 + (eta2 - 0.45) * period / 0.1);
  if (period <= tg) return s.alpha_max * eta2;
  if (period <= 5.0 * tg) return s.alpha_max * eta2 * std::pow(tg / period, gamma);
  return s.alpha_max * (eta2 * std::pow(0.2, gamma) - eta1 * (period - 5.0 * tg));
}

DesignSpectrum design_spectrum(const Gb50011& s) {
  DesignSpectrum out;
  out.name = fmt::format("GB 50011-2010, alpha_max {:g}, Tg {:g} s, {:g} %", s.alpha_max,
                         s.characteristic_period, 100.0 * s.damping_ratio);
  out.clause = "5.1.5";
  out.longest_period = longest;
  out.damping_ratio = s.damping_ratio;
  out.acceleration = [s](double period) { return standard_gravity * influence_coefficient(s, period); };
  return out;
}

Gb50011 gb50011(const GbSite& site) {
  const std::size_t level = place(levels, site.level, "a level");
  const std::size_t intensity = place(intensities, site.intensity, "an intensity");
  const std::size_t site_class = place(classes, site.site_class, "a site class");
  if (site.group < 1 || site.group > 3)
    throw InputError("GB 50011", 0, "a group of earthquakes from 1 to 3", std::to_string(site.group));
  const double tg = characteristic[static_cast<std::size_t>(site.group - 1)][site_class];
  return {alpha_max[level][intensity], site.level == "rare" ? tg + rare_period : tg, site.damping_ratio};
}

}  // namespace dougong::seismic
