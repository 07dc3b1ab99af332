// Everything a run leaves behind, as plain data: what results.h5 holds and what the report is drawn
// from. SI units and radians.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/vec2.h"
#include "structures/code_screen.h"
#include "structures/collapse.h"
#include "structures/response.h"
#include "structures/verdict.h"

namespace dougong::app {

/// One block or terrain as it is drawn: outline in its own frame and where it stands at the start.
struct DrawnShape {
  std::string name;
  std::vector<engine::Vec2> outline;  // m, about the centroid; empty for a circle
  double radius = 0.0;                // m, of a circle
  engine::Vec2 position;              // m, as described (before the settle)
  double angle = 0.0;                 // rad
  double mass = 0.0;                  // kg; 0 for terrain
  int storey = -1;                    // index into the storeys; -1 for none
  std::string material;
  std::vector<DrawnShape> parts = {};  // of a compound, in its frame; only in memory
};

/// A joint as it is drawn: its anchors in the frames of what it connects. Terrains are numbered behind the
/// blocks.
struct DrawnLink {
  std::size_t a = 0, b = 0;
  engine::Vec2 anchor_a, anchor_b;  // m
};

/// A bond as it is drawn: its face in the frame of a body or terrain, and when it cracked and broke. A face
/// that cracked touches and holds tension only where it is not broken.
struct DrawnBond {
  std::string name;
  std::size_t owner = 0;                   // numbered as in DrawnLink
  engine::Vec2 start, end;                 // m
  double cracked = never, broken = never;  // s
  std::string mode = {};   // the first: "tension", "shear", "yield", "crushing"; empty while sound
  double crushed = never;  // s, as structures/bond_damage.h says
  static constexpr double never = std::numeric_limits<double>::infinity();
};

struct NamedValue {
  std::string name;
  std::string value;    // as printed, with its unit
  std::string meaning;  // one line; may be empty
};

struct StoreySheet {
  std::string name;
  double base = 0.0;    // m
  double height = 0.0;  // m
  double mass = 0.0;    // kg
  std::size_t blocks = 0;
};

struct ModelSheet {
  std::string layout;
  std::string title;  // one line: what the building is
  std::vector<NamedValue> parameters;
  std::vector<NamedValue> materials;  // name, "E 30 GPa, 2400 kg/m3, friction 0.6, damping ratio 1"
  std::vector<DrawnShape> blocks;
  std::vector<DrawnShape> terrains;
  std::vector<StoreySheet> storeys;
  double mass = 0.0;  // kg
  std::size_t bonds = 0;
  std::size_t contact_points = 0;     // touching after the settle
  double period = 0.0;                // s, small-amplitude; 0 when not found
  double period_participation = 0.0;  // fraction of the mass that moves with that mode
  std::vector<std::string> modelled;
  std::vector<std::string> not_modelled;
  std::vector<std::string> findings;  // of the model check
  std::vector<DrawnLink> links;       // joints
  std::vector<DrawnBond> bonded;
  bool free_scene = false;  // pictures frame the terrain too and know no storeys; only in memory
  bool trails = false;      // pictures draw the paths of the bodies; only in memory
};

/// Name of the storey that a bond belongs to; empty for none.
std::string storey_of(const ModelSheet& model, const DrawnBond& bond);

struct MotionSheet {
  std::string title;                    // "synthetic Wenchuan-style / SYN1 / EW"
  std::vector<NamedValue> provenance;   // event, station, component, file, sha256, units as found ...
  std::vector<std::string> processing;  // in order, each with its numbers
  std::vector<NamedValue> measures;     // PGA, PGV, PGD, Arias, CAV, D5-95 ...
  double interval = 0.0;                // s
  std::vector<double> times;            // s, as applied to the terrain
  std::vector<double> acceleration_x, velocity_x, displacement_x;  // m/s2, m/s, m
  std::vector<double> acceleration_y, velocity_y, displacement_y;  // empty without a vertical motion
  std::vector<double> spectrum_periods;                            // s
  std::vector<double> spectrum_psa;                                // m/s2, 5 % damping, horizontal
  double spectrum_at_period = 0.0;                 // m/s2, PSa at the building's period; 0 without one
  std::string design_name;                         // of a standard's spectrum drawn beside it; empty: none
  std::vector<double> design_periods, design_psa;  // s, m/s2
};

/// Cumulated energies (J), one entry an output time. error = kinetic + gravity + elastic + friction
/// + damping - input - (their sum at the start).
struct EnergyHistory {
  std::vector<double> input, kinetic, gravity, elastic, friction, damping, error;
  std::vector<double> fracture;  // lost in bonds; empty in a results file that knows no bonds
  std::vector<double> field;     // of gravitation and charges; empty in one that knows no fields
  double largest_input = 0.0;    // J, greatest |input|
  /// Greatest |error| over the energy turned over: the greatest sum of |input| and of what gravity gave. A
  /// collapse is driven by gravity, whose energy is a hundred times that of the shaking.
  double relative_error = 0.0;
  /// Greatest |error| over the greatest |input|, until the first block loses its support; 0 without input.
  double standing_error = 0.0;
  /// Greatest |error| over the greatest |input| of the whole run; 0 without input.
  double input_error = 0.0;
};

struct SettleSheet {
  bool settled = false;
  double duration = 0.0;           // s, simulated
  double greatest_movement = 0.0;  // m, of any block
  double unbalanced_ratio = 0.0;   // largest net force over the body's weight
};

/// What a joint, a bonded face or one where two blocks touch, bears (structures/self_weight.h): under the
/// weight alone before the motion, or at its end.
struct WeightJoint {
  std::string name;  // "S1.column.left / ground"
  bool bonded = false;
  engine::Vec2 start, end;                  // m, of the face
  double normal = 0.0, shear = 0.0;         // N, compression; N
  double eccentricity = 0.0;                // -, of half its length
  double compression = 0.0, tension = 0.0;  // Pa, the greatest
  double used = 0.0;                        // of its nearest limit
  std::string limit = {};                   // which that is
  std::size_t a = 0, b = 0;                 // numbered as in DrawnLink; equal: unknown
  engine::Vec2 through = {};                // m, where N passes
  double stiffness = 0.0;                   // N/m, against closing
  double blocks_stiffness = 0.0;            // N/m, of what it joins; 0 at a corner
};

/// How far a joint opened and slid during the motion, and what it bore (structures/joint_response.h).
struct MovedJoint {
  std::string name;
  bool bonded = false;
  engine::Vec2 start, end;                       // m, of the face at rest
  structures::Peak opening, slip;                // m
  double residual_opening = 0.0;                 // m
  double residual_slip = 0.0;                    // m
  structures::Peak compression, tension, shear;  // N
};

struct Numerics {
  std::string integrator;
  double step = 0.0;   // s, smallest used
  double bound = 0.0;  // s, stability bound of that integrator for this scene
  std::size_t steps = 0;
  std::size_t evaluations = 0;  // of the forces; only in memory
  std::size_t step_reductions = 0;
  std::string outcome;  // "completed", "diverged", "stopped by criterion", "interrupted"
  std::string outcome_detail;
  double end_time = 0.0;                   // s, reached
  double asked_time = 0.0;                 // s, asked for
  double deepest_overlap = 0.0;            // m
  double deepest_overlap_ratio = 0.0;      // over the smaller block's minimum width
  std::string deepest_overlap_where;       // "S1.column.left / ground at 3.21 s"
  std::vector<double> overlap_ratio;       // the deepest, one entry an output time
  std::vector<double> mean_overlap_ratio;  // of the points that touch; empty in older files
  std::vector<std::string> warnings;
};

/// One run of an ensemble, reduced to its numbers.
struct EnsembleMember {
  structures::VerdictKind verdict = structures::VerdictKind::undecided;
  std::string state_hash;
  std::vector<double> values;  // of EnsembleSheet::metrics
  bool done = false;           // false: it was not run to its end
  /// Roof displacement over the height (-), often enough to be drawn, until a storey is lost; its times (s).
  std::vector<double> roof_times = {}, roof_drift = {};
};

/// The run again with small changes. Without members it was run once.
struct EnsembleSheet {
  std::vector<NamedValue> perturbations;  // what was changed, by how much at most
  std::vector<std::string> metrics, units;
  std::vector<EnsembleMember> members;  // the run as described first
  EnsembleMember half_step;             // the run as described with half the step
};

struct Reproducibility {
  std::string version, git_hash, compiler, command, scenario, scenario_sha256, record_sha256, state_hash;
  std::string started;  // ISO 8601, UTC
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;
};

/// The response against the drift limits of standards: screening, not code compliance.
struct ScreeningSheet {
  std::string structural_type;     // "rc frame"; empty or "none": no limits are for it
  std::vector<std::string> notes;  // what the limits are for, or why there are none
  std::vector<structures::CodeCheck> checks;
};

/// A moment worth a picture.
struct Moment {
  double time = 0.0;    // s
  std::string caption;  // "strongest shaking", "first loss of support" ...
};

struct RunResult {
  structures::Verdict verdict;
  bool partial = false;  // the run was interrupted
  ModelSheet model;
  MotionSheet motion;
  SettleSheet settle;
  std::vector<WeightJoint> weight_joints;  // the most used first; empty where it did not settle
  std::vector<WeightJoint> end_joints;     // the same at the end of the run
  std::vector<MovedJoint> moved_joints;    // those that opened or slid farthest first; empty as well
  structures::Trajectory trajectory;       // of a building: at the states kept (output_times.h)
  structures::Response response;
  structures::Collapse collapse;  // nothing happened where the numbers failed
  ScreeningSheet screening;
  EnergyHistory energy;  // at the output times
  Numerics numerics;
  Reproducibility reproducibility;
  std::vector<Moment> moments;
  EnsembleSheet ensemble;
  /// Where the terrains of a free scene are in the pictures (m), [time][terrain]; empty where they stand
  /// still in them. Only in memory.
  std::vector<engine::Vec2> terrain_displacement;
};

}  // namespace dougong::app
