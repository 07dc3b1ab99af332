#include "seismic/design/design_spectrum.h"

#include <fmt/format.h>

#include "seismic/input_error.h"

namespace dougong::seismic {

double DesignSpectrum::at(double period) const {
  constexpr double forgiven = 1e-9;  // rounding of a period at the end
  if (!(period >= shortest_period * (1.0 - forgiven) && period <= longest_period * (1.0 + forgiven)))
    throw InputError(
        "target spectrum", 0,
        fmt::format("periods from {:g} s to {:g} s ({}, {})", shortest_period, longest_period, name, clause),
        fmt::format("{:g} s", period));
  return acceleration(period);
}

std::vector<double> DesignSpectrum::at(std::span<const double> periods) const {
  std::vector<double> out;
  for (const double period : periods) out.push_back(at(period));
  return out;
}

}  // namespace dougong::seismic
