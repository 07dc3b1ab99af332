#include "engine/dynamics.h"

#include <algorithm>
#include <cmath>

namespace dougong::engine {

Dynamics::Dynamics(const Model& model, State& state, bool terrain_held_still, double local_damping)
    : model_(model),
      state_(state),
      terrain_held_still_(terrain_held_still),
      local_damping_(local_damping),
      frames_(model.size()),
      forces_(model.size()),
      torques_(model.size()),
      field_forces_(model.fields.empty() ? 0 : model.body_count) {
  measure_scene();
  for (std::size_t i = 0; i < model.body_count; ++i) {
    inverse_mass_.push_back(1.0 / model.mass[i]);
    inverse_inertia_.push_back(1.0 / model.inertia[i]);
  }
}

void Dynamics::measure_scene() {
  const std::size_t n = model_.body_count;
  levers_.assign(3 * n, 1.0);
  for (std::size_t i = 0; i < n; ++i) {
    levers_[2 * n + i] = model_.bounding_radius[i];
    const Vec2 p{state_.q()[i], state_.q()[n + i]};
    length_ = std::max(length_, norm(p) + model_.bounding_radius[i]);
  }
  fall_speed_ = std::sqrt(norm(model_.gravity) * length_);
}

Powers Dynamics::accelerate(double t, std::span<const double> q, std::span<const double> v,
                            std::span<double> a, bool begins_step) {
  ++evaluations_;
  place_bodies(model_, q, v, frames_, *crew_);
  place_terrains(model_, t, terrain_held_still_, frames_);
  const ContactTotals totals = add_contacts(t, begins_step);
  const LinkTotals links = add_links(begins_step);
  divide_by_masses(a);
  const double drag_power = field_forces_.empty() ? 0.0 : add_fields(a);
  if (local_damping_ > 0.0) damp_locally(v, a);
  if (begins_step) {
    note_deepest(t, totals.deepest_ratio, totals.deepest_point);
    const double drag_work = drag_work_.since_last(model_.fields.drag, frames_);
    work_ = {{terrain_work(), totals.damping_work + links.damping_work + drag_work, totals.tangential_work,
              links.bond_work}};
  }
  return {{terrain_power(), totals.damping_power + links.damping_power + drag_power, totals.tangential_power,
           links.bond_power}};
}

void Dynamics::divide_by_masses(std::span<double> a) const {
  constexpr std::size_t share = 1024;
  const std::size_t n = model_.body_count;
  crew_->share_range(n, share, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      a[i] = forces_[i].x * inverse_mass_[i] + model_.gravity.x;
      a[n + i] = forces_[i].y * inverse_mass_[i] + model_.gravity.y;
      a[2 * n + i] = torques_[i] * inverse_inertia_[i];
    }
  });
}

// The first to write the sums of every body. Rigid contacts leave them at zero.
ContactTotals Dynamics::add_contacts(double t, bool commit) {
  if (impulses_) {
    std::fill(forces_.begin(), forces_.end(), Vec2{});
    std::fill(torques_.begin(), torques_.end(), 0.0);
    return {};
  }
  loads_.resize(state_.contacts.points.load_count());
  const bool weigh = commit && one_evaluation_ && t > last_begin_;
  const ContactTotals totals = contact_forces(state_.contacts.points, frames_, commit, loads_, t,
                                              weigh ? t - last_begin_ : 0.0, *crew_);
  roused_ |= totals.roused;
  if (commit) last_begin_ = t;
  state_.contacts.gather(loads_, forces_, torques_, *crew_);
  return totals;
}

double Dynamics::weighted_square(std::span<const double> a) const {
  const std::size_t n = model_.body_count;
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += model_.mass[i] * (a[i] * a[i] + a[n + i] * a[n + i]) +
           model_.inertia[i] * a[2 * n + i] * a[2 * n + i];
  return sum;
}

void Dynamics::make_contacts_rigid() {
  if (local_damping_ > 0.0)
    throw std::invalid_argument("local damping: expected 0 where contacts are rigid, found " +
                                std::to_string(local_damping_));
  impulses_.emplace(model_);
}

// Those at the step's start; and what carries a terrain from mid-step to the next.
void Dynamics::find_terrain_velocities(double middle, double h) {
  terrains_before_.assign(model_.terrain_count, {});
  for (std::size_t j = 0; j < model_.terrain_count; ++j) {
    if (!model_.motions[j] || terrain_held_still_) continue;
    const PrescribedMotion& motion = *model_.motions[j];
    const Vec2 way = motion.at(middle + h).displacement - motion.at(middle).displacement;
    Frame& frame = frames_[model_.body_count + j];
    frame.vx = way.x / h, frame.vy = way.y / h;
    terrains_before_[j] = motion.at(middle - 0.5 * h).velocity;
  }
}

Powers Dynamics::add_impulses(double middle, double h, std::span<const double> before, std::span<double> v) {
  if (!impulses_) return {};
  find_terrain_velocities(middle, h);
  const Powers work = impulses_->apply(state_.contacts.points, frames_, h, terrains_before_, before, v);
  note_deepest(middle, impulses_->deepest_ratio(), impulses_->deepest_point());
  return work;
}

void Dynamics::observe(double t, std::span<const double> q, std::span<const double> v, std::span<double> a) {
  accelerate(t, q, v, a, false);
  if (impulses_) add_mean_contact_forces(a);
}

void Dynamics::add_mean_contact_forces(std::span<double> a) {
  const std::vector<Vec2> others = forces_;
  loads_.resize(state_.contacts.points.load_count());
  ContactImpulses::mean_forces(state_.contacts.points, frames_, loads_);
  state_.contacts.gather(loads_, forces_, torques_);
  const std::size_t n = model_.body_count;
  for (std::size_t i = 0; i < n; ++i) {
    a[i] += forces_[i].x / model_.mass[i];
    a[n + i] += forces_[i].y / model_.mass[i];
    a[2 * n + i] += torques_[i] / model_.inertia[i];
  }
  for (std::size_t i = 0; i < forces_.size(); ++i) forces_[i] += others[i];
}

// Joints and bonds; a scene without them pays two tests.
Dynamics::LinkTotals Dynamics::add_links(bool commit) {
  LinkTotals totals;
  if (!model_.joints.empty()) {
    const JointTotals t = add_joint_forces(model_, state_.joints, frames_, commit, forces_, torques_);
    totals.damping_power += t.damping_power, totals.damping_work += t.damping_work;
  }
  if (!model_.bond_points.empty()) {
    const BondTotals t = add_bond_forces(model_, state_.bonds, frames_, commit, forces_, torques_);
    totals.damping_power += t.damping_power, totals.damping_work += t.damping_work;
    totals.bond_power = t.spring_power, totals.bond_work = t.spring_work;
  }
  return totals;
}

// Returns the power that drag takes.
double Dynamics::add_fields(std::span<double> a) {
  std::fill(field_forces_.begin(), field_forces_.end(), Vec2{});
  const double drag_power = add_field_forces(model_.fields, frames_, field_tree_, field_forces_);
  const std::size_t n = model_.body_count;
  for (std::size_t i = 0; i < n; ++i) {
    a[i] += field_forces_[i].x / model_.mass[i];
    a[n + i] += field_forces_[i].y / model_.mass[i];
  }
  return drag_power;
}

void Dynamics::damp_locally(std::span<const double> v, std::span<double> a) const {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double sign = v[i] > 0.0 ? 1.0 : (v[i] < 0.0 ? -1.0 : 0.0);
    a[i] -= local_damping_ * sign * std::abs(a[i]);
  }
}

// The terrains' work on the bodies: minus the force they bear, times their velocity.
double Dynamics::terrain_power() const {
  double input = 0.0;
  for (std::size_t j = model_.body_count; j < model_.size(); ++j)
    input -= dot(forces_[j], frames_[j].velocity());
  return input;
}

double Dynamics::terrain_work() {
  const bool first = terrain_past_.empty();
  terrain_past_.resize(model_.terrain_count);
  double work = 0.0;
  for (std::size_t j = 0; j < model_.terrain_count; ++j) {
    const std::size_t body = model_.body_count + j;
    const TerrainPast now{-forces_[body], frames_[body].position()};
    if (!first)
      work += 0.5 * dot(terrain_past_[j].force + now.force, now.position - terrain_past_[j].position);
    terrain_past_[j] = now;
  }
  return work;
}

void Dynamics::note_deepest(double t, double ratio, std::size_t point) {
  if (ratio <= state_.deepest_ratio) return;
  state_.deepest_ratio = ratio;
  state_.deepest_time = t;
  const Index a = state_.contacts.points.corner_body[point];
  const Index b = state_.contacts.points.edge_body[point];
  state_.deepest_pair = {std::min(a, b), std::max(a, b)};
}

Vec2 Dynamics::terrain_reaction() const {
  Vec2 sum;
  for (std::size_t j = model_.body_count; j < model_.size(); ++j) sum -= forces_[j];
  return sum;
}

}  // namespace dougong::engine
