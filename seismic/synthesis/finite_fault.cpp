#include "seismic/synthesis/finite_fault.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>

#include "seismic/constants.h"
#include "seismic/synthesis/random.h"

namespace dougong::seismic {
namespace {

constexpr std::uint64_t slip_stream = 900001, delay_stream = 900002;  // beside those of the noise

struct Grid {
  int along, down;
  double dl, dw;  // m
  int count() const { return along * down; }
};

Grid grid_of(const FiniteFault& f) {
  const int along = std::max(1, static_cast<int>(f.length / f.subfault_length + 1e-9));
  const int down = std::max(1, static_cast<int>(f.width / f.subfault_width + 1e-9));
  return {along, down, f.length / along, f.width / down};
}

struct Place {
  int i, j;  // along, down
};

Place hypocentre(const FiniteFault& f, const Grid& g) {
  return {std::clamp(static_cast<int>(f.hypocentre_along * g.along), 0, g.along - 1),
          std::clamp(static_cast<int>(f.hypocentre_down * g.down), 0, g.down - 1)};
}

int ring(Place p, Place hypo) {
  return std::max(std::abs(p.i - hypo.i), std::abs(p.j - hypo.j)) + 1;
}

// Subfaults in each ring, from ring 1.
std::map<int, int> ring_counts(const Grid& g, Place hypo) {
  std::map<int, int> counts;
  for (int j = 0; j < g.down; ++j)
    for (int i = 0; i < g.along; ++i) ++counts[ring({i, j}, hypo)];
  return counts;
}

int pulsing(const std::map<int, int>& counts, int r, const FiniteFault& f, const Grid& g) {
  const int rings = std::max(1, static_cast<int>(g.along * f.pulsing_share / 2.0));
  int sum = 0;
  for (int q = std::max(1, r - rings + 1); q <= r; ++q) {
    const auto found = counts.find(q);
    if (found != counts.end()) sum += found->second;
  }
  return std::max(1, sum);
}

double distance_to(const FiniteFault& f, const Grid& g, Place p, const SitePlace& site) {
  const double along = (p.i + 0.5) * g.dl, down = (p.j + 0.5) * g.dw;
  const double out = down * std::cos(f.dip);  // to the right of the strike
  const double east = along * std::sin(f.strike) + out * std::cos(f.strike);
  const double north = along * std::cos(f.strike) - out * std::sin(f.strike);
  const double depth = f.top_depth + down * std::sin(f.dip);
  return std::sqrt(std::pow(site.east - east, 2) + std::pow(site.north - north, 2) + depth * depth);
}

// sum over frequencies of [(2 pi f)^2 D/(1 + (f/f0)^2)]^2, D of kappa: on one grid whatever the step of the
// motion.
double energy(double corner, const Region& region) {
  constexpr double step = 0.05, highest = 50.0;  // Hz
  double sum = 0.0;
  for (double f = step; f <= highest; f += step) {
    const double ratio = f / corner,
                 s = f * f * std::exp(-std::numbers::pi * region.kappa * f) / (1.0 + ratio * ratio);
    sum += s * s;
  }
  return sum;
}

std::vector<double> slips(const FiniteFault& f, int count, std::uint64_t seed) {
  std::vector<double> slip(static_cast<std::size_t>(count), 1.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    if (f.slip == SlipModel::random) slip[k] = uniform_number(seed, slip_stream, k);
    sum += slip[k];
  }
  for (double& s : slip) s /= sum;
  return slip;
}

}  // namespace

std::vector<Subfault> subfaults(const FiniteFault& f, const Region& region, const SitePlace& site,
                                std::uint64_t seed) {
  const Grid g = grid_of(f);
  const Place hypo = hypocentre(f, g);
  const auto counts = ring_counts(g, hypo);
  const double moment = seismic_moment(f.magnitude), n = g.count();
  const double rupture = f.rupture_ratio * region.shear_velocity;
  const double whole = energy(corner_frequency(region, moment, f.stress_drop), region);
  const std::vector<double> slip = slips(f, g.count(), seed);
  std::map<int, std::pair<double, double>> of_ring;  // corner and H
  std::vector<Subfault> out;
  for (int j = 0; j < g.down; ++j) {
    for (int i = 0; i < g.along; ++i) {
      const int r = ring({i, j}, hypo);
      auto [known, fresh] = of_ring.try_emplace(r);
      if (fresh) {
        const double corner = corner_frequency(region, moment / n * pulsing(counts, r, f, g), f.stress_drop);
        known->second = {corner, std::sqrt(n * whole / energy(corner, region))};
      }
      Subfault s;
      s.moment = moment * slip[out.size()];
      s.distance = distance_to(f, g, {i, j}, site);
      s.arrival =
          std::hypot((i - hypo.i) * g.dl, (j - hypo.j) * g.dw) / rupture + s.distance / region.shear_velocity;
      s.rise_time = std::sqrt(g.dl * g.dw / std::numbers::pi) / rupture;
      s.corner_frequency = known->second.first, s.high_scale = known->second.second;
      out.push_back(s);
    }
  }
  return out;
}

double closest_distance(const std::vector<Subfault>& subfaults) {
  double least = std::numeric_limits<double>::infinity();
  for (const Subfault& s : subfaults) least = std::min(least, s.distance);
  return least;
}

double fourier_amplitude(const Subfault& s, std::size_t count, const Region& region, double f) {
  const double low_scale = std::sqrt(static_cast<double>(count)), taper = low_scale / s.high_scale;
  const double ratio = f / (s.corner_frequency / std::sqrt(taper));
  return at_the_site(source_amplitude(region, s.moment, f) * low_scale / (1.0 + ratio * ratio), region,
                     s.distance, f);
}

std::vector<double> simulate(const FiniteFault& fault, const Region& region, const SitePlace& site,
                             double interval, double lead, std::uint64_t seed, std::uint64_t component,
                             double longest) {
  const std::vector<Subfault> parts = subfaults(fault, region, site, seed);
  double first = std::numeric_limits<double>::infinity(), last = 0.0;
  std::vector<double> starts, durations;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Subfault& s = parts[k];
    starts.push_back(s.arrival + s.rise_time * uniform_number(seed, delay_stream, k));
    durations.push_back(path_duration(s.distance) + s.rise_time);
    first = std::min(first, starts.back());
    last = std::max(last, starts.back() + 2.5 * durations.back());
  }
  const double length = std::min(longest, last - first + lead);
  std::vector<double> motion(static_cast<std::size_t>(std::ceil(length / interval)) + 1, 0.0);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto amplitude = [&](double f) { return fourier_amplitude(parts[k], parts.size(), region, f); };
    add_shaped_noise(motion, amplitude, durations[k], starts[k] - first + lead, interval, seed,
                     component * 1000000 + k);
  }
  return motion;
}

FaultSize fault_size(double magnitude, FaultStyle style, double stress_drop) {
  struct Fit {
    double a, b, c, d;  // lg length = a + b M, lg width = c + d M, km
  };
  constexpr Fit fits[] = {
      {-2.57, .62, -.76, .27}, {-2.42, .58, -1.61, .41}, {-1.88, .50, -1.14, .35}, {-2.44, .59, -1.01, .32}};
  const Fit& fit = fits[static_cast<int>(style)];
  const double factor = 1000.0 * std::cbrt(70.0e5 / stress_drop);
  return {factor * std::pow(10.0, fit.a + fit.b * magnitude),
          factor * std::pow(10.0, fit.c + fit.d * magnitude)};
}

}  // namespace dougong::seismic
