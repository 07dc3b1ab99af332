#include "engine/contact/rocking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/contact/contact_points.h"

namespace dougong::engine {
namespace {

struct Approach {
  double overlap, rate, spin;  // m, m/s, rad/s
};

// The couple of an impact that acts inside of its corner; the dashpot takes `force` times the rate.
double inset_couple(double inset, double force, const Approach& a) {
  const double couple = inset * force, most = force * a.rate;
  return couple * a.spin > most ? most / a.spin : couple;
}

double couple_of(const RockingDashpot& dashpot, const Approach& a) {
  const double impact = a.overlap > 0.0 ? a.rate - dashpot.rate * a.overlap : 0.0;
  if (!(impact > 0.0)) return 0.0;
  if (dashpot.inset != 0.0) return inset_couple(dashpot.inset, dashpot.damping * impact, a);
  return -dashpot.couple * std::clamp(a.spin * dashpot.length, -impact, impact);
}

// Of the corner at `side` of the face's middle.
RockingDashpot dashpot_of(const RockingImpact& p, const RockingLaw& law, double side) {
  return {.couple = law.couple,
          .inset = std::copysign(law.inset, -side),
          .length = 2.0 * p.half_length,
          .rate = p.law.normal / p.law.normal_damping,
          .damping = p.law.normal_damping};
}

// Displacements and velocities of the block's centroid and its angle, from a spin of -1 rad/s about the
// corner at -b: the other comes down.
struct Fall {
  std::array<double, 3> q{}, v{};
};

// Accelerations under the forces of both corners and the couple.
std::array<double, 3> accelerations(const RockingImpact& p, const RockingLaw& law, const Fall& f) {
  double fx = 0.0, fy = 0.0, torque = 0.0;
  for (const double side : {-p.half_length, p.half_length}) {
    const double overlap = -(f.q[1] + side * f.q[2]), rate = -(f.v[1] + side * f.v[2]);
    const double normal = normal_force(p.law.normal, p.law.normal_damping, overlap, rate);
    const double slip = f.q[0] + p.height * f.q[2], slip_rate = f.v[0] + p.height * f.v[2];
    const double tangential = -friction_force(p.law.tangential * slip + p.law.tangential_damping * slip_rate,
                                              p.law.friction * normal);
    fx += tangential, fy += normal;
    torque += side * normal + p.height * tangential;
    torque += couple_of(dashpot_of(p, law, side), {overlap, rate, f.v[2]});
  }
  return {fx / p.mass, fy / p.mass, torque / p.inertia};
}

Fall advanced(const Fall& f, const Fall& rate, double h) {
  Fall g = f;
  for (std::size_t k = 0; k < 3; ++k) g.q[k] += h * rate.q[k], g.v[k] += h * rate.v[k];
  return g;
}

Fall stepped(const RockingImpact& p, const RockingLaw& law, const Fall& f, double h) {
  const auto rate_at = [&](const Fall& g) { return Fall{g.v, accelerations(p, law, g)}; };
  return advanced(f, rate_at(advanced(f, rate_at(f), 0.5 * h)), h);
}

double corner_inertia(const RockingImpact& p) {
  return p.inertia + p.mass * (p.half_length * p.half_length + p.height * p.height);
}

// The fastest rate of the impact (1/s), by which the step is chosen.
double fastest_rate(const RockingImpact& p, double couple) {
  const double b = p.half_length, h = p.height;
  const double mobility = 1.0 / p.mass + (b * b + h * h) / p.inertia;
  return std::sqrt(2.0 * (p.law.normal + p.law.tangential) * mobility) +
         2.0 * (p.law.normal_damping + p.law.tangential_damping) * mobility + 2.0 * couple * b / p.inertia;
}

}  // namespace

double housner_ratio(const RockingImpact& p) {
  const double b2 = p.mass * p.half_length * p.half_length, h2 = p.mass * p.height * p.height;
  return (p.inertia + h2 - b2) / (p.inertia + h2 + b2);
}

// Forces at the corner leave the angular momentum about it alone, which is what the block turns with in the
// end. Where the corner bounces, its weight brings it back as fast as it left; the weight's own moment is no
// part of the impact.
double velocity_ratio(const RockingImpact& p, const RockingLaw& law) {
  constexpr double fineness = 0.05, at_rest = 1e-3;
  constexpr int most_steps = 100000;
  const double h = fineness / fastest_rate(p, law.couple), first = 2.0 * p.half_length;
  const auto rise = [&](const Fall& f) { return f.v[1] + p.half_length * f.v[2]; };
  Fall f{{}, {p.height, -p.half_length, -1.0}};
  double returned = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    f = stepped(p, law, f, h);
    const double up = rise(f);
    if (up <= 0.0 || accelerations(p, {}, f) != std::array<double, 3>{}) continue;
    if (up < at_rest * first) break;
    f.q = {}, f.v[1] -= 2.0 * up, returned += 2.0 * up;
  }
  const double momentum =
      p.inertia * f.v[2] - p.mass * (p.half_length * (f.v[1] + returned) + p.height * f.v[0]);
  return -momentum / corner_inertia(p);
}

namespace {

// The law between two, of which the first loses less than `ratio` and the second more.
RockingLaw law_between(const RockingImpact& p, RockingLaw loses_less, RockingLaw loses_more, double ratio) {
  const auto middle = [&] {
    return RockingLaw{std::midpoint(loses_less.couple, loses_more.couple),
                      std::midpoint(loses_less.inset, loses_more.inset)};
  };
  for (int i = 0; i < 30; ++i) (velocity_ratio(p, middle()) > ratio ? loses_less : loses_more) = middle();
  return middle();
}

}  // namespace

RockingLaw law_for_ratio(const RockingImpact& p, double ratio) {
  constexpr int most_doublings = 12;  // a stiffer couple changes nothing any more
  if (velocity_ratio(p, {}) < ratio) return law_between(p, {.inset = p.half_length}, {}, ratio);
  RockingLaw low, high{.couple = p.law.normal_damping * p.half_length};
  for (int i = 0; i < most_doublings && velocity_ratio(p, high) > ratio; ++i) low = high, high.couple *= 2.0;
  return law_between(p, low, high, ratio);
}

void add_rocking_couples(ContactPoints& points, std::span<const Frame> frames, bool commit,
                         std::span<PairLoad> loads, ContactTotals& totals) {
  for (std::size_t i = 0; i < points.rocking.size(); ++i) {
    RockingDashpot& dashpot = points.rocking[i];
    if (!dashpot.acts()) continue;
    const Frame &corner = frames[points.corner_body[i]], &edge = frames[points.edge_body[i]];
    const PointGeometry g = geometry_of(points, i, frames);
    const double spin = corner.spin - edge.spin, angle = corner.angle - edge.angle;
    const double couple = couple_of(dashpot, {g.overlap, overlap_rate(g, corner, edge), spin});
    loads[i / 2].add(points.corner_is_b(i), {}, couple, -couple);
    totals.damping_power -= couple * spin;
    if (!commit) continue;
    totals.damping_work -= 0.5 * (dashpot.past_couple + couple) * (angle - dashpot.past_angle);
    dashpot.past_couple = couple, dashpot.past_angle = angle;
  }
}

}  // namespace dougong::engine
