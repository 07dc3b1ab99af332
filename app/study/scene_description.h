// A free scene as its file describes it: plain data, before shapes are built and records are read. SI units
// and radians.
//
// scene_file.h reads it from TOML and writes it back; scene_build.h makes an engine::Scene of it. Because a
// scene is always built from its description, a written file that is read again gives the same bits.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/study/scenario.h"
#include "engine/scene.h"

namespace dougong::app {

struct MaterialChoice {
  std::string name;
  std::string preset;  // what is not given comes from it; empty: that of its name, else concrete
  std::optional<double> density, young_modulus, poisson_ratio, friction, damping_ratio;
  std::optional<double> restitution;  // instead of damping_ratio
  std::optional<double> rocking_restitution = std::nullopt;
};

struct MaterialPairChoice {
  std::string a, b;
  std::optional<double> friction, damping_ratio;
  std::optional<double> restitution;  // instead of damping_ratio
  std::optional<double> rocking_restitution = std::nullopt;
};

struct PartChoice;

/// Sizes of a shape in its own frame, and where that frame is. Corners and points are given in the frame.
struct ShapeChoice {
  std::string kind;
  std::optional<double> radius, width, height, depth;  // m
  std::vector<engine::Vec2> corners;                   // m; of a polyline its points
  std::vector<PartChoice> parts;                       // of a compound
  engine::Vec2 position;                               // m, of the frame's origin
  double angle = 0.0;                                  // rad
};

struct PartChoice {
  ShapeChoice shape;
};

struct BodyChoice {
  std::string name;
  ShapeChoice shape;
  std::string material = "concrete";
  engine::Vec2 velocity;  // m/s
  double spin = 0.0;      // rad/s
  std::optional<double> mass, inertia;
  double thickness = 1.0;
  double charge = 0.0;
  double linear_drag = 0.0, quadratic_drag = 0.0;
  engine::Vec2 force;  // N
  bool collides = true;
};

struct HarmonicChoice {
  double amplitude = 0.0;  // m/s2
  double frequency = 0.0;  // Hz
  double direction = 0.0;  // rad, from the horizontal
};

/// How a terrain moves: exactly one of record, table, harmonic and velocity.
struct MotionChoice {
  std::string source;   // a record: its name in the catalogue, or its file
  RecordChoice record;  // what else is said about the record; file and name stay empty
  Conditioning conditioning;
  std::string table;  // a CSV file of displacement
  std::optional<HarmonicChoice> harmonic;
  std::optional<engine::Vec2> velocity;  // m/s, constant
};

struct TerrainChoice {
  std::string name;
  ShapeChoice shape;
  std::string material = "concrete";
  std::optional<MotionChoice> motion;
};

struct JointChoice {
  std::string name;
  std::string kind;
  std::string a, b;                                // names of bodies or terrains
  std::optional<engine::Vec2> at;                  // m, both anchors, where the scene describes it
  std::optional<engine::Vec2> anchor_a, anchor_b;  // m, in the frames of a and b, instead
  std::optional<double> stiffness, rotational_stiffness, damping, damping_ratio, rest_length;
};

struct BondChoice {
  std::string name;
  std::string a, b;
  engine::Vec2 start, end;  // m
  std::optional<double> normal_stiffness, shear_stiffness, tensile_strength, cohesion, yield_strength,
      compressive_strength;
  double friction = engine::Bond{}.friction_coefficient;
  double fracture_energy = engine::Bond{}.fracture_energy;
  double damping_ratio = engine::Bond{}.damping_ratio;
};

/// A storey of a building by hand (structures/building.h).
struct StoreyChoice {
  std::string name;
  double base = 0.0, height = 0.0;  // m
  std::vector<std::string> level;   // names of the blocks that are its level
  std::vector<std::string> blocks;  // and of its other blocks
  bool on_ground = false;
};

/// The integrator that accuracy chooses (engine/accuracy.h).
struct SceneSolve : IntegrationChoice {
  double duration = 10.0;  // s
  bool settle = false;
};

struct SceneOutput {
  double rate = 100.0;  // Hz
  std::string directory = "dougong-out";
  std::vector<std::string> bodies;  // empty: all
  std::vector<std::string> quantities{"position", "velocity"};
  double pictures = 6;  // in the film strip
  bool film = false;
};

/// What holds once for a scene: keys outside any table.
struct SceneHead {
  std::string title;
  /// m/s2; unset: none.
  std::optional<engine::Vec2> gravity = engine::Vec2{0.0, -engine::standard_gravity};
};

struct SceneDescription {
  SceneHead head;
  std::vector<MaterialChoice> materials;
  std::vector<MaterialPairChoice> material_pairs;
  std::vector<BodyChoice> bodies;
  std::vector<TerrainChoice> terrains;
  std::vector<JointChoice> joints;
  std::vector<BondChoice> bonds;
  std::vector<StoreyChoice> storeys;
  engine::Fields fields;
  engine::ContactOptions contact;
  SceneSolve solve;
  SceneOutput output;
};

}  // namespace dougong::app
