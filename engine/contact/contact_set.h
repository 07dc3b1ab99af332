// The pairs that can meet and their contact points, kept up to date while bodies move.
//
// A pair's manifold is found again when its relative motion since the last time exceeds a third of its
// margin (a small part of the smaller body's width): until then the same corners face the same edges
// and the kernel follows them exactly.
#pragma once

#include <utility>

#include "engine/collision/broad_phase.h"
#include "engine/contact/contact_pair.h"

namespace dougong::engine {

struct PairLaw;

class ContactSet {
 public:
  ContactSet() = default;
  explicit ContactSet(const Model& model);

  /// Sorted pairs of bodies that something else holds: they do not touch. The next update sees it.
  void keep_apart(std::vector<BodyPair> held);
  /// Sorted pairs of bodies whose contacts have less damping than their materials ask for.
  void limit_damping(std::vector<PairDamping> tied);
  /// The next update finds two bodies touching that a bond held before: their springs then store that energy
  /// (J), as long as they stay closed.
  void inherit(BodyPair bodies, double energy) { heirs_.push_back({bodies, energy}); }
  /// What they took over of it since the last call (J).
  double take_inherited() { return std::exchange(inherited_, 0.0); }
  /// Brings pairs and points up to date with the frames. Returns true if any point was added, removed
  /// or replaced (its stability bound may have changed).
  bool update(const Model& model, std::span<const Frame> frames, Crew& crew = Crew::alone());
  /// Bodies and terrains whose points have come, gone, changed or been roused since the last call, one
  /// several times perhaps.
  std::vector<Index> take_disturbed();
  /// Of every pair that touches a body: its first point, plus one if the body is its second.
  std::span<const std::uint32_t> touches_of(Index body) const {
    return std::span(touches_).subspan(first_[body], first_[body + 1] - first_[body]);
  }
  /// Whether the points are rigid: without stiffness and dashpots, for an integrator that finds impulses. A
  /// change starts every point afresh where it is.
  void make_rigid(const Model& model, std::span<const Frame> frames, bool rigid);
  /// Steps of length h that may pass before the next update, whatever bodies whose fastest_rim() is `speed`
  /// do at that speed and in free fall (at least 1).
  std::size_t steps_until_update(const Model& model, double speed, double h) const;

  /// Longest step in which no body can pass from beyond the margin of another to touching it, at that speed
  /// and in free fall (s): contacts are found before they close. Infinite where nothing can touch.
  double longest_step(const Model& model, double speed) const;

  /// Sums the loads of the pairs over every body and terrain, in a fixed order.
  void gather(std::span<const PairLoad> loads, std::span<Vec2> forces, std::span<double> torques,
              Crew& crew = Crew::alone()) const;

  ContactPoints points;
  const std::vector<ContactPair>& pairs() const { return pairs_; }

 private:
  void rebuild_pairs(const Model& model, std::span<const Frame> frames);
  void note_skin_poses(const Model& model, std::span<const Frame> frames);
  bool moved_beyond_skin(const Model& model, std::span<const Frame> frames) const;
  void watch(const Model& model, std::size_t k);
  double moved(std::size_t k) const { return watches_[k / PairWatch::size].moved[k % PairWatch::size]; }
  void measure_motions(std::span<const Frame> frames, Crew& crew);
  void refresh_moved(const Model& model, std::span<const Frame> frames);
  void look_at(const Model& model, std::span<const Frame> frames, std::size_t k);
  bool refresh(const Model& model, std::span<const Frame> frames, ContactPair& pair);
  void enter(const Model& model, std::span<const Frame> frames, ContactPair& pair);
  void leave(ContactPair& pair);
  void disturb(BodyPair bodies) { disturbed_.push_back(bodies.a), disturbed_.push_back(bodies.b); }
  PairLaw law_of(const ContactPair& pair) const;
  struct Heir {
    BodyPair bodies;
    double energy = 0.0;  // J
  };
  void hand_over_to(const Heir& heir, std::span<const Frame> frames);
  void compact_slots(std::span<const Frame> frames);
  void index_bodies(std::size_t bodies);
  void gather_bodies(std::size_t begin, std::size_t end, std::span<const PairLoad> loads,
                     std::span<Vec2> forces, std::span<double> torques) const;
  void put_blocks_to_sleep(std::span<const Frame> frames);

  double skin_ = 0.0;             // m
  double smallest_margin_ = 0.0;  // m
  double smallest_limit_ = 0.0;   // m, of the motions that call for a new look
  double sleeping_gap_ = 0.0;     // m, of pairs that cannot close before the next look
  bool rigid_ = false;
  bool has_contacts_ = false;
  std::vector<ContactPair> pairs_;
  std::vector<PairWatch> watches_;  // of eight pairs each
  struct Seen {
    double smallest_limit = 0.0;  // m
    bool beyond_limit = false;    // a pair of them
  };
  std::vector<Seen> seen_;         // of each of them
  std::vector<Index> free_slots_;  // first points
  std::size_t entered_ = 0;        // pairs, since the slots were compacted
  std::vector<Index> disturbed_;
  std::vector<BodyPair> held_;
  std::vector<PairDamping> tied_;
  std::vector<Heir> heirs_;
  double inherited_ = 0.0;  // J
  std::vector<Vec2> skin_position_;
  std::vector<double> skin_angle_;
  std::vector<std::uint32_t> touches_;  // a pair's first point, plus one for its second body
  std::vector<Index> first_;            // of each body, into touches_
  bool slots_changed_ = false;          // since the bodies were indexed
  std::vector<char> sleeps_, slept_;    // of each block of points, now and before
};

/// Greatest speed of any point of a body that can touch, relative to the ground that moves all of them (m/s).
double fastest_rim(const Model& model, std::span<const Frame> frames);

}  // namespace dougong::engine
