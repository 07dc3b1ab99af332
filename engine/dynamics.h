// The equations of motion of a scene: M q'' = gravity + contact + joints + bonds + fields, as an integrator
// sees them.
#pragma once

#include <limits>
#include <utility>

#include "engine/fields/fields.h"
#include "engine/integrators/error_control.h"
#include "engine/integrators/integrator.h"
#include "engine/nonsmooth/contact_impulses.h"
#include "engine/state.h"

namespace dougong::engine {

class Dynamics {
 public:
  /// The state's contacts are updated in place. With terrain held still the motions stay at t = 0.
  /// local_damping beta takes beta |a_i| against the sign of v_i off every acceleration: Cundall's
  /// non-viscous damping, for finding an equilibrium (Cundall 1987, in Brown (ed.), Analytical and
  /// Computational Methods in Engineering Rock Mechanics, ch. 4). 0 for any true motion.
  Dynamics(const Model& model, State& state, bool terrain_held_still = false, double local_damping = 0.0);

  /// Threads to evaluate with; they must outlive this.
  void work_with(Crew& crew) { crew_ = &crew; }
  /// Of a method that evaluates once a step, dashpots that close within one are weighed (contact_forces).
  void evaluated_once_a_step(bool once) { one_evaluation_ = once; }
  /// From now on contacts are rigid: they add nothing to accelerate(), and add_impulses() finds what they do.
  void make_contacts_rigid();
  const ContactImpulses* impulses() const { return impulses_ ? &*impulses_ : nullptr; }

  std::size_t degrees_of_freedom() const { return 3 * model_.body_count; }
  /// Accelerations at (t, q, v). begins_step: these are the poses of an accepted step.
  Powers accelerate(double t, std::span<const double> q, std::span<const double> v, std::span<double> a,
                    bool begins_step);
  /// Of rigid contacts, over the step whose middle accelerate() saw last: see HasImpulses.
  Powers add_impulses(double middle, double h, std::span<const double> before, std::span<double> v);
  /// Accelerations as an observer sees them: with the mean forces of rigid contacts over the last step.
  void observe(double t, std::span<const double> q, std::span<const double> v, std::span<double> a);
  /// Work between the last two accepted steps' poses: the trapezoidal rule on the forces along the
  /// displacements.
  Powers work() const { return work_; }
  /// Sum of m |a|^2, moments of inertia for the spins (N2/kg).
  double weighted_square(std::span<const double> a) const;
  /// Friction and bonds: what a step begins with changes what comes after.
  bool has_memory() const { return state_.contacts.points.size() > 0 || !model_.bond_points.empty(); }
  /// The scene's extent at the start, the speed of a fall through it, and the bodies' radii as levers.
  Scales scales() const { return {length_, fall_speed_, levers_}; }
  std::size_t event_count() const { return 2 * state_.contacts.points.size(); }
  /// Of the contacts at the last evaluated state (contact_events).
  void events(std::span<double> values, bool at_start) const {
    contact_events(state_.contacts.points, frames_, at_start, values);
  }
  std::size_t evaluations() const { return evaluations_; }
  /// Whether a face has left its rest since the last call: the stability bound may have shrunk.
  bool take_roused() { return std::exchange(roused_, false); }
  /// Force of the terrains on the bodies at the last evaluation (N).
  Vec2 terrain_reaction() const;

 private:
  void measure_scene();
  void divide_by_masses(std::span<double> a) const;
  ContactTotals add_contacts(double t, bool commit);
  void find_terrain_velocities(double middle, double h);
  void add_mean_contact_forces(std::span<double> a);
  double add_fields(std::span<double> a);
  void damp_locally(std::span<const double> v, std::span<double> a) const;
  struct LinkTotals {
    double damping_power = 0.0, bond_power = 0.0;  // W
    double damping_work = 0.0, bond_work = 0.0;    // J, since the last commit
  };
  LinkTotals add_links(bool commit);
  double terrain_power() const;
  double terrain_work();
  void note_deepest(double t, double ratio, std::size_t point);

  const Model& model_;
  State& state_;
  Crew* crew_ = &Crew::alone();
  bool terrain_held_still_;
  double local_damping_;
  bool one_evaluation_ = false, roused_ = false;
  double last_begin_ = std::numeric_limits<double>::infinity();  // s, of the last accepted step
  std::vector<Frame> frames_;
  std::vector<PairLoad> loads_;
  std::vector<Vec2> forces_;
  std::vector<double> torques_;
  std::vector<double> inverse_mass_, inverse_inertia_;  // 1/kg, 1/(kg m2)
  std::vector<Vec2> field_forces_;                      // N; empty without fields
  Tree field_tree_;
  DragWork drag_work_;
  struct TerrainPast {
    Vec2 force, position;  // N on the bodies, m
  };
  std::vector<TerrainPast> terrain_past_;  // at the last accepted step
  Powers work_;
  double length_ = 0.0, fall_speed_ = 0.0;  // m, m/s
  std::vector<double> levers_;              // -, -, m
  std::size_t evaluations_ = 0;
  std::optional<ContactImpulses> impulses_;  // of rigid contacts
  std::vector<Vec2> terrains_before_;        // m/s, for the impulses
};

}  // namespace dougong::engine
