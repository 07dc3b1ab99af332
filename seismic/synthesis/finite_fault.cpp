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
constexpr std::uint64_t most_subfaults = 10000;                       // of a plane: how far its numbers run

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

double asperity_factor(const FiniteFault& f, const Grid& g, Place p) {
  const double along = (p.i + 0.5) * g.dl, down = (p.j + 0.5) * g.dw;
  double factor = 1.0;
  for (const Asperity& a : f.asperities)
    if (std::abs(along - a.along) <= 0.5 * a.length && std::abs(down - a.down) <= 0.5 * a.width)
      factor = std::max(factor, a.slip);
  return factor;
}

// Parts of the whole.
std::vector<double> slips(const FiniteFault& f, const Grid& g, std::uint64_t seed, std::uint64_t plane) {
  std::vector<double> slip;
  double sum = 0.0;
  for (int j = 0; j < g.down; ++j) {
    for (int i = 0; i < g.along; ++i) {
      const std::uint64_t number = plane * most_subfaults + slip.size();
      const double drawn = f.slip == SlipModel::random ? uniform_number(seed, slip_stream, number) : 1.0;
      slip.push_back(drawn * asperity_factor(f, g, {i, j}));
      sum += slip.back();
    }
  }
  for (double& s : slip) s /= sum;
  return slip;
}

// A subfault's share of the motion: when it starts, from the break of the first hypocentre, and how long.
struct Burst {
  Subfault source;
  double start, duration;  // s
  std::size_t subfaults;   // of its plane
  std::uint64_t number;    // of its noise
};

std::vector<Burst> bursts(const std::vector<RupturePlane>& planes, const Region& region,
                          const SitePlace& site, std::uint64_t seed) {
  std::vector<Burst> out;
  for (std::uint64_t p = 0; p < planes.size(); ++p) {
    const RupturePlane& plane = planes[p];
    const SitePlace place{site.east - plane.corner.east, site.north - plane.corner.north};
    const std::vector<Subfault> parts = subfaults(plane.fault, region, place, seed, p);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::uint64_t number = p * most_subfaults + k;
      const double delay = parts[k].rise_time * uniform_number(seed, delay_stream, number);
      out.push_back({parts[k], plane.onset + parts[k].arrival + delay,
                     path_duration(parts[k].distance) + parts[k].rise_time, parts.size(), number});
    }
  }
  return out;
}

double first_start(const std::vector<Burst>& parts) {
  double first = std::numeric_limits<double>::infinity();
  for (const Burst& b : parts) first = std::min(first, b.start);
  return first;
}

void add_bursts(std::vector<double>& motion, const std::vector<Burst>& parts, const Region& region,
                double interval, double shift, std::uint64_t seed, std::uint64_t component) {
  for (const Burst& b : parts) {
    const auto amplitude = [&](double f) { return fourier_amplitude(b.source, b.subfaults, region, f); };
    add_shaped_noise(motion, amplitude, b.duration, b.start + shift, interval, seed,
                     component * 1000000 + b.number);
  }
}

}  // namespace

std::vector<Subfault> subfaults(const FiniteFault& f, const Region& region, const SitePlace& site,
                                std::uint64_t seed, std::uint64_t plane) {
  const Grid g = grid_of(f);
  const Place hypo = hypocentre(f, g);
  const auto counts = ring_counts(g, hypo);
  const double moment = seismic_moment(f.magnitude), n = g.count();
  const double rupture = f.rupture_ratio * region.shear_velocity;
  const double whole = energy(corner_frequency(region, moment, f.stress_drop), region);
  const std::vector<double> slip = slips(f, g, seed, plane);
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
  const std::vector<Burst> parts = bursts({{fault, {}, 0.0}}, region, site, seed);
  const double first = first_start(parts);
  double last = first;
  for (const Burst& b : parts) last = std::max(last, b.start + 2.5 * b.duration);
  const double length = std::min(longest, last - first + lead);
  std::vector<double> motion(static_cast<std::size_t>(std::ceil(length / interval)) + 1, 0.0);
  add_bursts(motion, parts, region, interval, lead - first, seed, component);
  return motion;
}

std::vector<double> simulate(const std::vector<RupturePlane>& planes, const Region& region,
                             const SitePlace& site, double interval, double lead, std::uint64_t seed,
                             std::uint64_t component, std::size_t samples) {
  const std::vector<Burst> parts = bursts(planes, region, site, seed);
  std::vector<double> motion(samples, 0.0);
  add_bursts(motion, parts, region, interval, lead - first_start(parts), seed, component);
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
