#include "seismic/design/spectrum_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

void check(const SpectrumTable& t) {
  std::vector<InputProblem> problems;
  if (t.periods.size() < 2 || t.periods.size() != t.accelerations.size())
    problems.push_back({t.name, 0, "at least two rows of a period and an acceleration",
                        fmt::format("{} and {}", t.periods.size(), t.accelerations.size())});
  for (std::size_t i = 0; i < std::min(t.periods.size(), t.accelerations.size()); ++i) {
    const double before = i == 0 ? -1e-300 : t.periods[i - 1];
    if (!(t.periods[i] > before && std::isfinite(t.periods[i])))
      problems.push_back({t.name, 0, fmt::format("periods that rise from 0 or more (row {})", i + 1),
                          fmt::format("{:g} s", t.periods[i])});
    if (!(t.accelerations[i] > 0.0 && std::isfinite(t.accelerations[i])))
      problems.push_back({t.name, 0, fmt::format("a positive acceleration (row {})", i + 1),
                          fmt::format("{:g} m/s2", t.accelerations[i])});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

double interpolated(const SpectrumTable& t, double period, Interpolation how) {
  const auto above = std::upper_bound(t.periods.begin() + 1, t.periods.end() - 1, period);
  const auto i = static_cast<std::size_t>(above - t.periods.begin());
  const double t0 = t.periods[i - 1], t1 = t.periods[i], a0 = t.accelerations[i - 1], a1 = t.accelerations[i];
  if (how == Interpolation::linear || t0 == 0.0) return a0 + (a1 - a0) * (period - t0) / (t1 - t0);
  return a0 * std::pow(a1 / a0, std::log(period / t0) / std::log(t1 / t0));
}

}  // namespace

DesignSpectrum design_spectrum(SpectrumTable table, Interpolation how, double damping_ratio) {
  check(table);
  DesignSpectrum out;
  out.name = table.name, out.clause = "table of the user";
  out.shortest_period = table.periods.front(), out.longest_period = table.periods.back();
  out.damping_ratio = damping_ratio;
  out.acceleration = [table = std::move(table), how](double period) {
    return interpolated(table, period, how);
  };
  return out;
}

}  // namespace dougong::seismic
