// The contact points of a scene, and the forces they make of its poses.
//
// A point is a corner of one body against an edge of another (contact/manifold.h):
//     gap  g = n . (p - e) - rho          n, e turn and move with the edge's body, rho rounding
//     slip s = t . (p - e) - rho (theta_corner - theta_edge) - anchor,   t = n turned by 90 degrees
// Both are functions of the poses alone: the elastic forces have a potential, whatever the integrator. The
// stiffness may follow the corner's position along the edge (contact/bearing_length.h).
// Round contacts (along a line of centres) keep the direction and the angles of the last committed step
// and add the slip since then.
#pragma once

#include <limits>
#include <utility>

#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"
#include "engine/contact/point_blocks.h"
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
  double calm_since = PointBlock::never;
};

/// Points 2 k and 2 k + 1 are those of one pair of bodies; one of them may be empty, or both.
class ContactPoints {
 public:
  ContactPoints() = default;
  explicit ContactPoints(bool with_rocking) : with_rocking_(with_rocking) {}

  std::vector<FeatureKind> kind;
  std::vector<Index> corner_body, edge_body;
  std::vector<RockingDashpot> rocking;  // one a point, or none at all

  std::size_t size() const { return kind.size(); }
  /// Of the loads of contact_forces().
  std::size_t load_count() const { return blocks_.size() * PointBlock::pairs; }
  /// Whole pairs; new points are empty.
  void resize(std::size_t n);
  /// Empties point i of a pair.
  void clear(std::size_t i, BodyPair bodies);
  /// Points `first` and the next become as points `from` and the next of others.
  void take_over(const ContactPoints& others, std::size_t from, std::size_t first);
  /// `bodies` are the pair's; the first of them bears the loads' force.
  void set(std::size_t i, BodyPair bodies, const Feature& feature, const BearingLength& length,
           const PointStiffness& law, double width);
  /// Points of a block that slept start anew.
  void wake(std::size_t block, std::span<const Frame> frames);
  /// Forgets: point i stands where the frames say, and has done nothing yet.
  void start(std::size_t i, std::span<const Frame> frames);

  PointStiffness stiffness(std::size_t i) const;
  void set_stiffness(std::size_t i, const PointStiffness& law);
  /// Lets the corner overlap by so much more (m) before it bears. Nothing on a round contact.
  void set_back(std::size_t i, double by);
  BearingLength bearing(std::size_t i) const;
  double inverse_width(std::size_t i) const { return block(i).inverse_width[lane(i) / 2]; }  // 1/m
  PointHistory history(std::size_t i) const;
  void set_history(std::size_t i, const PointHistory& history);
  PointPast past(std::size_t i) const;
  void set_past(std::size_t i, const PointPast& past);
  bool corner_is_b(std::size_t i) const { return block(i).corner_is_b[lane(i)] != 0; }
  bool open(std::size_t i) const { return block(i).open[lane(i)] != 0; }

  void note_roused() { roused_ = true; }
  /// Whether a face of any block has been roused since the last call (PointBlock::roused says which).
  bool take_roused() { return std::exchange(roused_, false); }

  std::span<PointBlock> blocks() { return blocks_; }
  std::span<const PointBlock> blocks() const { return blocks_; }

 private:
  friend PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames);

  // Of round points: the feature, and the pose that slip is measured from.
  struct Round {
    Vec2 corner, edge_point;                      // m
    double radius = 0.0, other_radius = 0.0;      // m
    Vec2 direction{0.0, 1.0};                     // -
    double angle_corner = 0.0, angle_edge = 0.0;  // rad
  };
  static std::size_t lane(std::size_t i) { return i % PointBlock::size; }
  PointBlock& block(std::size_t i) { return blocks_[i / PointBlock::size]; }
  const PointBlock& block(std::size_t i) const { return blocks_[i / PointBlock::size]; }

  bool with_rocking_ = false;
  bool roused_ = false;
  std::vector<PointBlock> blocks_;
  std::vector<Round> round_;
};

PointGeometry geometry_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames);
/// The law at these poses: that of the reference length, by the length it bears on now; and by the part of
/// the damping that a face at rest has.
PointStiffness law_at(const ContactPoints& points, std::size_t i, const PointGeometry& g);
/// The part of its dashpots' damping that a point has: less than 1 for a face at rest.
double damping_share(const ContactPoints& points, std::size_t i);
/// Rate at which the bodies of a point close (m/s).
double overlap_rate(const PointGeometry& g, const Frame& corner, const Frame& edge);
/// Force of one point on its corner's body (N).
Vec2 force_of(const ContactPoints& points, std::size_t i, std::span<const Frame> frames);

/// Loads of all pairs and the sums. With `commit`, the poses are those of an accepted step: anchors follow
/// Coulomb's return, totals.deepest_ratio is found, and faces come to rest or are roused at `time` (s).
///
/// Of a method that evaluates once a step, the forces of a pose stand for half a step before and half a step
/// after it. A point that closed tau ago, or opens in tau, bears for a part of that only: with `step` h (s)
/// since the last commit above 0 its spring counts 1/2 + tau/2h, the dashpot of a closing point, whose force
/// starts with a jump, 1/2 + tau/h. Impacts are then of second order in h and the spring's work balances.
ContactTotals contact_forces(ContactPoints& points, std::span<const Frame> frames, bool commit,
                             std::span<PairLoad> loads, double time = 0.0, double step = 0.0,
                             Crew& crew = Crew::alone());

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
