// The law of a bond at one Gauss point of its face.
//
//   e = g - p + c             opening g less the plastic opening p, and the closing c that crushing left (m)
//   N = kn e (1 - D)          tension > 0; D = 0 in compression
//   T = kt s,  |T| <= C (1 - D) + mu max(0, -N) (- mu N in tension)      s slip from the anchor
//
// Tension ends in one of three ways. Brittle: the point breaks when kn w = Ft. Softening: from the opening
// w0 = Ft/kn the envelope falls along a straight line to zero at wf = 2 Gf A / Ft, unloading to the origin
// (Hillerborg, Modeer and Petersson, Cement Concr. Res. 6 (1976) 773-781). In both w is the greatest of
//   e + D0 (e_edge - e)
// e_edge the opening of the face's end beside the point, D0 what was left of the strength: a sound face
// cracks where the stress at its edge reaches the strength, as a beam does, and a damaged point follows its
// own opening, so that it takes its fracture energy. Ductile, if Fy < Ft: N stays at Fy and p grows; slip
// beyond the shear strength then flows too. Otherwise shear beyond its strength breaks the point.
//
// A face that is joined bears compression by its points, to Fc each: N stays at -Fc and c grows. Here the
// stress at the point is asked, not that at the edge: an edge that crushes passes its load on instead of
// tearing, and a point at its strength is the block of stress fc over its half of the face, with L/(2 sqrt 3)
// for an arm in place of L/4. Once a point has left the elastic range in tension or shear the face has a
// crack: the bodies touch there as contacts do (contact/contact_set.h), which bear compression and friction,
// and what is left of the points holds tension and cohesion only. A broken point then does nothing.
//
// Units: N and m; the stiffness of the point's tributary area, its strengths times that area.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::engine {

struct BondStiffness {
  double normal = 0.0, tangential = 0.0;                      // N/m
  double normal_damping = 0.0, tangential_damping = 0.0;      // N s/m
  double tension = std::numeric_limits<double>::infinity();   // N, Ft
  double cohesion = std::numeric_limits<double>::infinity();  // N, C
  double yield = std::numeric_limits<double>::infinity();     // N, Fy
  double crushing = std::numeric_limits<double>::infinity();  // N, Fc
  double friction = 0.0;                                      // -, mu
  double last_opening = 0.0;                                  // m, wf; 0: brittle
  bool ductile() const { return yield < tension; }
};

struct BondHistory {
  double plastic = 0.0;  // m, opening that stays
  double crushed = 0.0;  // m, closing that stays, c
  double widest = 0.0;   // m, w
  double anchor = 0.0;   // m, where the shear spring is relaxed
  bool broken = false;
  bool sheared = false;     // that is why it broke
  bool joined = true;       // the face has no crack: its points bear compression
  bool was_joined = false;  // until its face cracked: the contacts there are damped as the bond while it ties
  /// Nothing is left of it: the contacts bear what there is to bear.
  bool gone() const { return broken && !joined; }
  double relaxed() const { return plastic - crushed; }  // m, opening at which the normal spring is relaxed
};

/// Where a point stands: opening and slip (m) and their rates (m/s), and the opening of the end of the face.
struct BondMotion {
  double opening = 0.0, slip = 0.0, opening_rate = 0.0, slip_rate = 0.0;
  double edge_opening = 0.0;  // m, less what crushing closed
};

struct BondForce {
  double normal = 0.0, tangential = 0.0;                  // N, of the springs; tension, and against slip
  double normal_dashpot = 0.0, tangential_dashpot = 0.0;  // N
  BondHistory history;                                    // as it is after these forces
};

/// Tension that an opening e can hold when w was the widest: the line to the origin under the envelope.
inline double softened_tension(const BondStiffness& k, double e, double w) {
  const double first = k.tension / k.normal;
  if (w <= first) return k.normal * e;
  if (w >= k.last_opening) return 0.0;
  return k.tension * (k.last_opening - w) / (k.last_opening - first) * (e / w);
}

/// What is left of the strength, 1 to 0.
inline double soundness(const BondStiffness& k, const BondHistory& h) {
  if (h.broken) return 0.0;
  const double first = k.tension / k.normal;
  if (!(h.widest > first)) return 1.0;
  return std::max(0.0, (k.last_opening - h.widest) / (k.last_opening - first));
}

/// Widens and breaks a point that is not ductile.
inline void open_bond(const BondStiffness& k, const BondMotion& m, BondHistory& h) {
  if (h.broken || k.ductile()) return;
  const double e = m.opening + h.crushed;
  h.widest = std::max(h.widest, e + soundness(k, h) * (m.edge_opening - e));
  h.broken = h.widest * k.normal > k.tension && !(h.widest < k.last_opening);
}

/// Of a joined face that is closed: elastic to the strength, then it crushes.
inline double bond_compression(const BondStiffness& k, double elastic, BondHistory& h) {
  if (!(elastic < -k.crushing)) return elastic;
  h.crushed += (-k.crushing - elastic) / k.normal;
  return -k.crushing;
}

inline double bond_tension(const BondStiffness& k, const BondMotion& m, BondHistory& h) {
  open_bond(k, m, h);
  const double e = m.opening - h.relaxed(), elastic = k.normal * e;
  if (e <= 0.0) return h.joined ? bond_compression(k, elastic, h) : 0.0;
  if (h.broken) return 0.0;
  if (!k.ductile()) return softened_tension(k, e, h.widest);
  h.plastic += std::max(0.0, elastic - k.yield) / k.normal;
  return std::min(elastic, k.yield);
}

/// Whether the point has left the elastic range in tension or shear.
inline bool has_cracked(const BondStiffness& k, const BondHistory& h) {
  return h.broken || h.plastic != 0.0 || h.widest * k.normal > k.tension;
}

inline double shear_limit(const BondStiffness& k, double normal, const BondHistory& h) {
  const double held = h.broken ? 0.0 : k.cohesion * soundness(k, h);
  return std::max(0.0, held - k.friction * (h.broken ? std::min(0.0, normal) : normal));
}

inline BondForce bond_force(const BondStiffness& k, const BondMotion& m, const BondHistory& history) {
  BondForce f;
  f.history = history;
  BondHistory& h = f.history;
  if (h.gone()) return f;
  f.normal = bond_tension(k, m, h);
  double limit = shear_limit(k, f.normal, h);
  const double wanted = k.tangential * (m.slip - h.anchor);
  if (std::abs(wanted) > limit && !h.broken && !k.ductile()) {
    h.broken = h.sheared = true;
    f.normal = std::min(0.0, k.normal * (m.opening - h.relaxed()));
    limit = shear_limit(k, f.normal, h);
  }
  f.tangential = std::clamp(wanted, -limit, limit);
  if (k.tangential > 0.0) h.anchor = m.slip - f.tangential / k.tangential;

  const bool closed = m.opening < h.relaxed();
  if (h.broken && !closed) return f;
  // What flows has no viscosity, a softened face as much as it is sound; a broken one never pulls.
  const bool flows = h.plastic != history.plastic || h.crushed != history.crushed;
  const double viscosity = !closed ? soundness(k, h) : h.joined ? 1.0 : 0.0;
  f.normal_dashpot = flows ? 0.0 : viscosity * k.normal_damping * m.opening_rate;
  if (h.broken) f.normal_dashpot = std::min(f.normal_dashpot, -f.normal);
  const double viscous = k.tangential_damping * m.slip_rate;
  f.tangential_dashpot = std::clamp(f.tangential + viscous, -limit, limit) - f.tangential;
  return f;
}

/// Energy that the springs of a point can give back (J).
inline double bond_energy(const BondStiffness& k, double opening, double slip, const BondHistory& h) {
  if (h.gone()) return 0.0;
  const double e = opening - h.relaxed();
  const double closed = h.joined ? k.normal * e : 0.0;
  const double normal = e <= 0.0 ? closed : h.broken ? 0.0 : softened_tension(k, e, h.widest);
  const double s = slip - h.anchor;
  return 0.5 * normal * e + 0.5 * k.tangential * s * s;
}

}  // namespace dougong::engine
