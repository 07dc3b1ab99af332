#include "fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::app::fixtures {
namespace {

using engine::Vec2;
using structures::Envelope;
using structures::StoreyResponse;
using structures::VerdictKind;

constexpr double pi = std::numbers::pi, g = 9.80665;

std::vector<Vec2> box(double width, double height) {
  return {
      {-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
}

DrawnShape block(const std::string& name, double w, double h, Vec2 at, int storey, double density = 2400) {
  return {name, box(w, h), 0.0, at, 0.0, w * h * density, storey, "concrete"};
}

DrawnShape ground(double width) {
  return {"ground", box(width, 1.0), 0.0, {0.0, -0.5}, 0.0, 0.0, -1, "soil"};
}

/// An earthquake-like displacement (m) that starts and ends at rest.
double ground_displacement(double t, double duration) {
  const double s = std::sin(pi * t / duration),
               envelope = s * s * std::exp(-std::pow(t / duration - 0.35, 2) * 9);
  return envelope * (0.10 * std::sin(2 * pi * 0.45 * t) + 0.012 * std::sin(2 * pi * 2.3 * t + 1) +
                     0.003 * std::sin(2 * pi * 5.1 * t));
}

double slope(double (*f)(double, double), double t, double duration) {
  const double h = 1e-3;
  return (f(t + h, duration) - f(t - h, duration)) / (2 * h);
}
double bend(double (*f)(double, double), double t, double duration) {
  const double h = 1e-3;
  return (f(t + h, duration) - 2 * f(t, duration) + f(t - h, duration)) / (h * h);
}

MotionSheet motion(double duration, double interval, double scale) {
  MotionSheet m;
  m.title = "synthetic Wenchuan-style / SYN1 / EW";
  m.interval = interval;
  m.provenance = {{"event", "synthetic, M 7.9 style", ""},
                  {"station", "SYN1", ""},
                  {"component", "EW", ""},
                  {"file", "synthetic_wenchuan_SYN1.EW", ""},
                  {"units as found", "gal", "1 gal = 0.01 m/s²"}};
  m.processing = {"mean of the first 2.00 s removed: 0.13 gal",
                  "band-pass 0.10 to 25 Hz, Butterworth, order 4, two-way", "scaled by 1.84 to PGA 0.350 g"};
  for (std::size_t i = 0; static_cast<double>(i) * interval <= duration + 1e-9; ++i) {
    const double t = static_cast<double>(i) * interval;
    m.times.push_back(t);
    m.displacement_x.push_back(scale * ground_displacement(t, duration));
    m.velocity_x.push_back(scale * slope(ground_displacement, t, duration));
    m.acceleration_x.push_back(scale * bend(ground_displacement, t, duration));
  }
  m.measures = {{"PGA", "0.350 g (3.43 m/s²)", "peak ground acceleration"},
                {"PGV", "0.29 m/s", "peak ground velocity"},
                {"Arias intensity", "1.9 m/s", "energy of the shaking"},
                {"D5-95", "14.2 s", "significant duration"}};
  if (scale == 0.0) return m;
  for (int i = 0; i <= 120; ++i) {
    const double period = 0.02 * std::pow(500.0, i / 120.0);
    m.spectrum_periods.push_back(period);
    const double x = std::log(period / 0.42);
    m.spectrum_psa.push_back(g * (0.35 + 0.75 * std::exp(-1.3 * x * x)) / (1 + std::pow(period / 1.4, 2.2)));
  }
  return m;
}

Envelope envelope(const std::vector<double>& times, const std::vector<double>& values, double until) {
  Envelope e;
  for (std::size_t i = 0; i < times.size() && times[i] < until; ++i) {
    if (values[i] > e.positive.value) e.positive = {values[i], times[i]};
    if (values[i] < e.negative.value) e.negative = {values[i], times[i]};
  }
  return e;
}

struct Shaking {
  double duration = 30.0, interval = 0.02, drift = 0.004, lost_at = 1e9;
  std::size_t lost_storeys = 0;
};

double storey_drift(std::size_t storey, double t, const Shaking& s) {
  const double share = 1.0 / (1.0 + 0.35 * static_cast<double>(storey));
  const double lag = 0.06 * static_cast<double>(storey);
  const double build = std::exp(-std::pow((t - 0.4 * s.duration) / (0.16 * s.duration), 2));
  return s.drift * share *
         (build * std::sin(2 * pi * 1.6 * (t - lag)) + 0.07 * (1 + std::tanh(t - 0.4 * s.duration)));
}

/// Rigid-body fall of a lost block: down to the pile, sideways, turning.
void fall(Vec2& p, double& angle, double since, std::size_t i, double pile) {
  const double down = 0.5 * g * since * since;
  p.y = std::max(pile, p.y - down);
  const double run = std::min(since, 1.4);
  p.x += (i % 2 == 0 ? 1.0 : -0.6) * 0.8 * run;
  angle += (i % 2 == 0 ? -1.0 : 1.0) * 0.7 * run * (0.5 + 0.1 * static_cast<double>(i % 5));
}

void add_trajectory(RunResult& run, const Shaking& s) {
  auto& t = run.trajectory;
  t.times = run.response.times;
  t.blocks = run.model.blocks.size();
  for (std::size_t k = 0; k < t.times.size(); ++k) {
    const double at = t.times[k], moved = ground_displacement(at, s.duration);
    t.ground_displacement.push_back({moved, 0.0});
    t.ground_reaction.push_back({run.response.base_shear[k], run.response.weight});
    for (std::size_t i = 0; i < t.blocks; ++i) {
      const DrawnShape& b = run.model.blocks[i];
      const auto storey = static_cast<std::size_t>(std::max(0, b.storey));
      const bool floor = b.mass > 3000 || run.model.blocks.size() > 100;
      double u = storey == 0 ? 0.0 : run.response.storeys[storey - 1].floor_displacement[k];
      const double above = run.response.storeys[storey].floor_displacement[k];
      u = floor ? above : 0.5 * (u + above);
      Vec2 p = b.position + Vec2{moved + u, 0.0};
      double angle = floor ? 0.0 : (u - above) / 3.0 * 2.0;
      if (at > s.lost_at) fall(p, angle, at - s.lost_at, i, 0.15 + 0.13 * static_cast<double>(i));
      t.poses.insert(t.poses.end(), {p.x, p.y, angle});
      t.accelerations.push_back(run.response.storeys[storey].floor_acceleration[k]);
    }
  }
}

void add_response(RunResult& run, const Shaking& s) {
  auto& r = run.response;
  r.weight = run.model.mass * g;
  for (double t = 0; t <= s.duration + 1e-9; t = s.interval * static_cast<double>(r.times.size()))
    r.times.push_back(t);
  std::vector<double> below(r.times.size(), 0.0);
  for (std::size_t i = 0; i < run.model.storeys.size(); ++i) {
    StoreyResponse storey;
    storey.name = run.model.storeys[i].name;
    storey.height = run.model.storeys[i].height;
    storey.original_mass = run.model.storeys[i].mass;
    if (i < s.lost_storeys) storey.lost_at = s.lost_at + 0.2 * static_cast<double>(i);
    double frozen = 0.0;
    for (std::size_t k = 0; k < r.times.size(); ++k) {
      const double t = r.times[k];
      const bool lost = storey.lost_at && t >= *storey.lost_at;
      if (!lost) frozen = storey_drift(i, t, s);
      storey.drift.push_back(frozen);
      storey.floor_displacement.push_back(below[k] + frozen * storey.height);
      storey.floor_acceleration.push_back(lost ? 0.0
                                               : 100 * frozen + bend(ground_displacement, t, s.duration));
      storey.mass_lost.push_back(lost ? 0.8 : 0.0);
    }
    below = storey.floor_displacement;
    storey.peak_drift = envelope(r.times, storey.drift, storey.lost_at.value_or(1e9));
    storey.peak_acceleration = envelope(r.times, storey.floor_acceleration, storey.lost_at.value_or(1e9));
    storey.residual_drift = storey.drift.back();
    r.storeys.push_back(storey);
  }
  r.roof_displacement = below;
  for (std::size_t k = 0; k < r.times.size(); ++k)
    r.base_shear.push_back(-0.02 * r.weight * 1e3 * r.storeys[0].drift[k]);
  for (std::size_t k = 0; k < r.times.size(); ++k) r.overturning_moment.push_back(7.0 * r.base_shear[k]);
  r.height = run.model.storeys.back().base + run.model.storeys.back().height;
  r.peak_overturning_moment = envelope(r.times, r.overturning_moment, 1e9);
  r.peak_roof_displacement = envelope(r.times, r.roof_displacement, 1e9);
  r.peak_base_shear = envelope(r.times, r.base_shear, 1e9);
}

void add_energy(RunResult& run, const Shaking& s) {
  EnergyHistory& e = run.energy;
  const double scale = 0.4 * run.model.mass;
  for (const double t : run.response.times) {
    const double done = 0.5 * (1 + std::tanh((t - 0.4 * s.duration) / 3.0));
    const double kinetic = 0.3 * scale * std::pow(storey_drift(0, t, s) / s.drift, 2);
    const double gravity = t > s.lost_at ? -2.0 * scale * std::min(1.0, t - s.lost_at) : 0.01 * kinetic;
    e.kinetic.push_back(kinetic);
    e.gravity.push_back(gravity + 5 * scale);
    e.elastic.push_back(0.2 * kinetic);
    e.input.push_back(scale * done + kinetic);
    e.damping.push_back(0.4 * scale * done);
    e.friction.push_back(e.input.back() - 1.2 * kinetic - gravity - e.damping.back());
    e.error.push_back(2e-3 * scale * std::sin(t) * done);
    e.largest_input = std::max(e.largest_input, std::abs(e.input.back()));
  }
  for (const double error : e.error)
    e.relative_error = std::max(e.relative_error, std::abs(error) / e.largest_input);
  e.standing_error = 0.5 * e.relative_error;
  e.input_error = e.relative_error;
}

void add_paperwork(RunResult& run, const Shaking& s) {
  run.settle = {true, 2.0, 2.1e-5, 3.2e-6};
  run.weight_joints = {
      {"S1.column.left / ground", false, {-3, 0}, {-2.7, 0}, 3.4e5, 120, 0.06, 1.3e6, 0, 0.06, "turning"},
      {"S1.slab / S1.column.left", true, {-3, 2.8}, {-2.7, 2.8}, 2.5e5, -40, 0.02, 9e5, 0, 0.01, "shear"}};
  const std::size_t ground = run.model.blocks.size();
  const auto joins = [&](WeightJoint& joint, std::size_t a, std::size_t b, double ratio) {
    joint.a = a, joint.b = b, joint.through = 0.5 * (joint.start + joint.end);
    joint.stiffness = ratio * 2e9, joint.blocks_stiffness = 2e9;
  };
  if (ground > 2) joins(run.weight_joints[0], 0, ground, 1.0), joins(run.weight_joints[1], 2, 0, 0.25);
  run.end_joints = {run.weight_joints.front()};
  run.moved_joints = {{"S1.column.left / ground",
                       false,
                       {-3, 0},
                       {-2.7, 0},
                       {0.012, 9.5},
                       {-0.034, 12.0},
                       0.001,
                       -0.03,
                       {4.1e5, 9.6},
                       {0, 0},
                       {-6e4, 9.4}},
                      {"S1.slab / S1.column.left",
                       true,
                       {-3, 2.8},
                       {-2.7, 2.8},
                       {2e-4, 9.4},
                       {1e-5, 9.4},
                       0,
                       0,
                       {2.9e5, 9.6},
                       {1e4, 9.5},
                       {4e4, 9.4}}};
  Numerics& n = run.numerics;
  n.integrator = "velocity Verlet";
  n.step = 2e-5;
  n.bound = 8.3e-5;
  n.steps = static_cast<std::size_t>(s.duration / n.step);
  n.outcome = "completed";
  n.end_time = n.asked_time = s.duration;
  n.deepest_overlap = 1.4e-4;
  n.deepest_overlap_ratio = 3.5e-4;
  n.deepest_overlap_where = "S1.column.left / ground at 12.08 s";
  for (const double t : run.response.times)
    n.overlap_ratio.push_back(2e-4 + 1.5e-4 * std::pow(std::sin(1.3 * t), 2));
  n.mean_overlap_ratio.assign(n.overlap_ratio.size(), 1.2e-4);
  run.reproducibility = {"0.1.0",
                         "1f3c5a7",
                         "g++ 12.2.0, Release",
                         "dougong run --layout slabs --record SYN1.EW -o out",
                         "[model]\nlayout = \"slabs\"\nstoreys = 4\n",
                         "9b74c9897bac770ffc029102a200c5de",
                         "aa61e9897bac770ffc029102a200c5de",
                         "f00dfeed01234567",
                         "2026-03-01T10:00:00Z",
                         18.4,
                         18.1};
  run.model.modelled = {"rigid blocks with dry contact and Coulomb friction", "ground motion in x"};
  run.model.not_modelled = {"deformation of the blocks themselves", "vertical ground motion",
                            "soil, and its interaction with the building", "the third dimension"};
}

RunResult finished(RunResult run, const Shaking& s) {
  for (const StoreySheet& storey : run.model.storeys) run.model.mass += storey.mass;
  run.motion = motion(s.duration, 0.01, 1.0);
  run.motion.spectrum_at_period = 0.93 * g;
  add_response(run, s);
  add_trajectory(run, s);
  add_energy(run, s);
  add_paperwork(run, s);
  return run;
}

void count_storeys(ModelSheet& model, std::size_t storeys, double height) {
  for (std::size_t i = 0; i < storeys; ++i) {
    model.storeys.push_back({"S" + std::to_string(i + 1), height * static_cast<double>(i), height, 0.0, 0});
  }
  for (const DrawnShape& b : model.blocks) {
    model.storeys[static_cast<std::size_t>(b.storey)].mass += b.mass;
    ++model.storeys[static_cast<std::size_t>(b.storey)].blocks;
  }
}

RunResult slab_building(std::size_t storeys) {
  RunResult run;
  ModelSheet& m = run.model;
  m.layout = "two-column slabs";
  m.title = "four slabs on pairs of columns, dry joints";
  m.parameters = {{"storeys", std::to_string(storeys), ""},
                  {"storey height", "3 m", "floor to floor"},
                  {"span", "5 m", "between column axes"},
                  {"column width", "0.5 m", ""}};
  m.materials = {{"concrete", "E 30 GPa, 2400 kg/m³, friction 0.6, damping ratio 1", ""}};
  for (std::size_t i = 0; i < storeys; ++i) {
    const double base = 3.0 * static_cast<double>(i);
    const std::string s = "S" + std::to_string(i + 1);
    m.blocks.push_back(block(s + ".column.left", 0.5, 2.6, {-2.5, base + 1.3}, static_cast<int>(i), 2000));
    m.blocks.push_back(block(s + ".column.right", 0.5, 2.6, {2.5, base + 1.3}, static_cast<int>(i), 2000));
    m.blocks.push_back(block(s + ".slab", 6.0, 0.4, {0.0, base + 2.8}, static_cast<int>(i)));
  }
  m.terrains = {ground(14)};
  m.bonds = 0;
  m.contact_points = 8 * storeys;
  m.period = 0.35;
  m.period_participation = 0.82;
  count_storeys(m, storeys, 3.0);
  return run;
}

// Four members, one of them invalid and one left out, and half the step; the first loss never happened in
// two.
EnsembleSheet small_ensemble() {
  const double never = std::numeric_limits<double>::quiet_NaN();
  EnsembleSheet e;
  e.perturbations = {{"friction", "± 2 %", "of every material"}};
  e.metrics = {"peak drift", "first loss of support"}, e.units = {"1", "s"};
  e.members = {{VerdictKind::collapsed, "a1", {0.031, 11.3}, true},
               {VerdictKind::survived, "a2", {0.021, never}, true},
               {VerdictKind::numerically_invalid, "a3", {9.0, 1.0}, true},
               {VerdictKind::undecided, "", {}, false}};
  e.half_step = {VerdictKind::collapsed, "a4", {0.033, 11.4}, true};
  for (int k = 0; k < 100; ++k) {
    const double t = 0.02 * k, drift = 0.01 * std::sin(3.0 * t);
    for (EnsembleMember* member : {&e.members[0], &e.members[1], &e.half_step}) {
      if (member == &e.members[0] && k >= 60) continue;  // lost a storey
      member->roof_times.push_back(t);
      member->roof_drift.push_back(member == &e.members[1] ? 0.8 * drift : drift);
    }
  }
  return e;
}

}  // namespace

RunResult repeated() {
  RunResult run = collapsed();
  run.ensemble = small_ensemble();
  run.screening = {
      "rc frame",
      {"FEMA 356 (Table C1-3): typical values."},
      {{"FEMA 356", "Table C1-3", "concrete frames", "2", "LS", "peak drift", 0.02, 0.03, true},
       {"FEMA 356", "Table C1-3", "concrete frames", "2", "CP", "peak drift", 0.04, 0.03, false}}};
  run.model.bonds = 3;
  run.model.bonded = {{"base", 0, {-0.25, -1.3}, {0.25, -1.3}, 9.5, 9.7, "tension", 9.6},
                      {"head", 2, {-2.5, -0.2}, {-2.0, -0.2}, 9.1, DrawnBond::never, "shear"},
                      {"sound", 5, {0.0, 0.0}, {1.0, 0.0}}};
  run.energy.fracture.assign(run.trajectory.times.size(), 12.0);
  return run;
}

RunResult survived() {
  const Shaking s;
  RunResult run = finished(slab_building(4), s);
  run.verdict = {VerdictKind::survived,
                 "The building stands: largest drift +0.43 % in S1, no block lost its support.",
                 {"All 12 blocks kept their support to the end at 30.00 s.",
                  "Largest residual drift +0.05 % (S1).", "Energy error 0.14 % of the largest input."}};
  run.moments = {{0.0, "before"},
                 {9.6, "first slip"},
                 {11.4, "strongest shaking"},
                 {12.18, "peak drift"},
                 {16.0, "last exceedance of 0.1 %"},
                 {30.0, "end"}};
  return run;
}

RunResult collapsed() {
  Shaking s;
  s.drift = 0.03;
  s.lost_at = 11.3;
  s.lost_storeys = 2;
  RunResult run = finished(slab_building(4), s);
  run.verdict = {
      VerdictKind::collapsed,
      "Collapsed: S1 lost its support at 11.30 s and S2 followed at 11.50 s.",
      {"S1.column.left fell 2.43 m by 12.10 s.", "78 % of the mass lies below half its original height.",
       "Energy error 0.14 % of the largest input, so this is no numerical failure."}};
  run.response.losses = {{0, 11.3, "fell 1.30 m"}, {1, 11.34, "turned 41 deg"}, {2, 11.5, "fell 1.50 m"}};
  run.response.first_loss_of_support = 11.3;
  run.response.fallen_mass_fraction = 0.78;
  run.collapse.mode = structures::CollapseMode::soft_storey;
  run.collapse.reasons = {"S1 had 81 % of the displacement between the 4 storeys at 11.30 s."};
  run.collapse.initiation = 11.2, run.collapse.no_return = 11.1, run.collapse.complete = 11.5;
  run.collapse.footprint = {-3.0, 3.0, 0.0, 12.0, {1.4, 2000.0}, {0.0, 0.0}, 1};
  run.collapse.falls = {{0, 11.2, 12.1, 5.5, 39000.0}, {2, 11.4, 12.2, 6.1, 101000.0}};
  run.collapse.impact_energy = 140000.0;
  run.collapse.voids = {{3.2, 1.1, {-1.0, 0.6}}};
  run.collapse.void_area = 3.2, run.collapse.void_area_before = 52.0;
  run.response.blocks = run.model.blocks.size();
  run.response.peak_base_shear_ratio = {{0.31, 9.2}, {-0.28, 9.7}};
  run.response.greatest_lean = {"S4.column.left", -0.02, 0.115};
  run.response.storeys[0].lost_because = "100 % of its level's mass was lost";
  run.moments = {{0.0, "before"},
                 {9.6, "first slip"},
                 {10.9, "strongest shaking"},
                 {11.3, "first loss of support"},
                 {11.5, "S2 lost"},
                 {11.9, "point of no return"},
                 {12.6, "peak fall speed"},
                 {30.0, "end"}};
  run.numerics.warnings = {"the step was reduced 3 times between 11.30 s and 11.62 s",
                           "overlap reached 1.2 % of S2.slab at 11.42 s"};
  run.numerics.step_reductions = 3;
  return run;
}

RunResult brick_wall() {
  RunResult run;
  ModelSheet& m = run.model;
  m.layout = "brick wall";
  m.title = "running bond, 50 courses of 20 bricks";
  for (int course = 0; course < 50; ++course) {
    for (int i = 0; i < 20; ++i) {
      const double x = 0.25 * (i - 9.5) + (course % 2 == 0 ? 0.0625 : -0.0625);
      m.blocks.push_back(block("c" + std::to_string(course) + "." + std::to_string(i), 0.24, 0.065,
                               {x, 0.0325 + 0.065 * course}, course * 2 / 5, 1800));
    }
  }
  m.terrains = {ground(8)};
  m.period = 0.06;
  count_storeys(m, 20, 0.1625);
  Shaking s;
  s.duration = 8.0;
  s.interval = 0.04;
  s.drift = 0.002;
  run = finished(run, s);
  run.verdict = {VerdictKind::undecided,
                 "Undecided: the wall still moved when the motion ended.",
                 {"Residual speed 3 mm/s."}};
  run.moments = {{0.0, "before"}, {2.0, "first slip"}, {3.2, "peak drift"}, {8.0, "end"}};
  return run;
}

RunResult partial() {
  RunResult run = survived();
  run.partial = true;
  run.verdict = {VerdictKind::undecided,
                 "Undecided: the run was interrupted at 30.00 s of 60.00 s.",
                 {"Interrupted by the user."}};
  run.numerics.outcome = "interrupted";
  run.numerics.asked_time = 60.0;
  return run;
}

RunResult motionless() {
  RunResult run = slab_building(1);
  run.model.mass = run.model.storeys[0].mass;
  run.motion = motion(2.0, 0.01, 0.0);
  run.motion.title = "no motion";
  run.response.weight = run.model.mass * g;
  StoreyResponse storey;
  storey.name = "S1";
  storey.height = 3.0;
  run.response.storeys = {storey};
  run.verdict = {VerdictKind::survived, "The building stands: nothing moved.", {}};
  return run;
}

RunResult long_record() {
  Shaking s;
  s.interval = s.duration / 20000;
  RunResult run = finished(slab_building(4), s);
  run.motion = motion(s.duration, s.interval, 1.0);
  run.verdict = survived().verdict;
  run.moments = survived().moments;
  return run;
}

}  // namespace dougong::app::fixtures
