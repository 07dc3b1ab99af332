// The contact points of a scene as arrays, and the kernel that turns poses into forces.
//
// A point is a corner of one body against an edge of another (contact/manifold.h):
//     gap  g = n . (p - e) - rho          n, e turn and move with the edge's body, rho rounding
//     slip s = t . (p - e) - rho (theta_corner - theta_edge) - anchor,   t = n turned by 90 degrees
// Both are functions of the poses alone: the elastic forces have a potential, whatever the integrator. The
// stiffness may follow the corner's position along the edge (contact/bearing_length.h).
// Round contacts (along a line of centres) keep the direction and the angles of the last committed step
// and add the slip since then.
#pragma once

#include <array>
#include <limits>

#include "engine/collision/manifold.h"
#include "engine/contact/bearing_length.h"
#include "engine/contact/law.h"
#include "engine/contact/rocking.h"

namespace dougong::engine {

/// What a point remembers: where its friction spring is relaxed. An open point has no spring: it is
/// anchored where it touches next.
struct PointHistory {
  double anchor = 0.0;  // m
  bool open = true;
  // Round contacts only: direction of the line of centres and angles when anchor was committed.
  Vec2 direction{0.0, 1.0};
  double angle_corner = 0.0, angle_edge = 0.0;  // rad
  /// Whether both points of the face rest; if not, since when both bear and hardly move (s).
  bool resting = false;
  double calm_since = std::numeric_limits<double>::infinity();
};

/// Where a point stood at the last committed poses and what it did there: the work of its forces since then
/// is the trapezoidal rule along its displacement.
struct PointPast {
  double overlap = 0.0, position = 0.0;  // m, negative overlap when open
  double dashpot = 0.0;                  // N, normal force less the spring's
  double viscous = 0.0, friction = 0.0;  // N, against slip: the tangential dashpot, and all else
};

/// Forces of one point on its two bodies; torques about their centroids.
struct PointLoad {
  double fx = 0.0, fy = 0.0;                      // N, on the corner's body; the edge's gets the opposite
  double torque_corner = 0.0, torque_edge = 0.0;  // N m
};

/// Sums over the points.
struct ContactTotals {
  double damping_power = 0.0;     // W, taken by the dashpots
  double tangential_power = 0.0;  // W, taken by the tangential forces less their dashpots
  // The same as work since the last committed poses (J); only with `commit`.
  double damping_work = 0.0, tangential_work = 0.0;
  double deepest_ratio = 0.0;  // overlap over the smaller body's minimum width
  std::size_t deepest_point = 0;
  bool roused = false;  // a face that rested no longer does: its dashpots are stiffer
};

struct ContactPoints {
  std::vector<FeatureKind> kind;
  std::vector<Index> corner_body, edge_body;
  std::vector<Vec2> corner, edge_point, edge_normal;
  std::vector<Vec2> edge_offset;  // m, edge_point along the normal and along the tangent
  std::vector<double> radius, other_radius;
  std::vector<PointStiffness> stiffness;
  std::vector<BearingLength> bearing;
  std::vector<double> inverse_width;  // 1/m
  std::vector<PointHistory> history;
  std::vector<PointPast> past;
  std::vector<RockingDashpot> rocking;  // one a point, or none at all

  std::size_t size() const { return kind.size(); }
  void resize(std::size_t n, bool with_rocking);
  void set(std::size_t i, const Feature& feature, const BearingLength& length, const PointStiffness& law,
           double width);
  /// Forgets: point i stands where the frames say, and has done nothing yet.
  void start(std::size_t i, std::span<const Frame> frames);
};

/// Geometry of one point at given poses.
struct PointGeometry {
  Vec2 normal;            // -, from the edge's body to the corner's
  Vec2 arm_corner;        // m, from the corner body's centroid to the contact point
  Vec2 arm_edge;          // m
  double overlap = 0.0;   // m, > 0 when touching
  double slip = 0.0;      // m, from the anchor; 0 for an open point
  double position = 0.0;  // m, of the corner along the edge; round contacts: slip since the last commit
};
PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames);
/// The law at these poses: that of the reference length, by the length it bears on now; and by the part of
/// the damping that a face at rest has.
PointStiffness law_at(const ContactPoints& points, std::size_t i, const PointGeometry& g);
/// Rate at which the bodies of a point close (m/s).
double overlap_rate(const PointGeometry& g, const Frame& corner, const Frame& edge);

/// Forces of all points. With `commit`, the poses are those of an accepted step: anchors follow
/// Coulomb's return, totals.deepest_ratio is found, and faces come to rest or are roused at `time` (s).
///
/// Of a method that evaluates once a step, the forces of a pose stand for half a step before and half a step
/// after it. A point that closed tau ago, or opens in tau, bears for a part of that only: with `step` h (s)
/// since the last commit above 0 its spring counts 1/2 + tau/2h, the dashpot of a closing point, whose force
/// starts with a jump, 1/2 + tau/h. Impacts are then of second order in h and the spring's work balances.
ContactTotals contact_forces(ContactPoints& points, std::span<const Frame> frames, bool commit,
                             std::span<PointLoad> loads, double time = 0.0, double step = 0.0);

/// Every face that bears on both its ends rests.
void put_to_rest(ContactPoints& points);

/// Two values for every point, whose sign changes are kinks of its force: its overlap; and its rate of slip
/// (m/s) if its spring stretches to Coulomb's limit `at_start`, else not a number. A step that straddles the
/// moment in which sliding turns back would leave the anchor behind.
void contact_events(const ContactPoints& points, std::span<const Frame> frames, bool at_start,
                    std::span<double> values);

struct StoredEnergy {
  double normal = 0.0, tangential = 0.0;  // J
};
StoredEnergy stored_energy(const ContactPoints& points, std::span<const Frame> frames);

}  // namespace dougong::engine
