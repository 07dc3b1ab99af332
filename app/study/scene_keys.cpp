#include "app/study/scene_keys.h"

#include <algorithm>

#include "app/study/scenario_keys.h"

namespace dougong::app {
namespace {

using enum Dimension;

constexpr double endless = std::numeric_limits<double>::infinity();

template <class Owner>
using Place = Slot (*)(Owner&);

template <class Owner>
Key<Owner> text(const char* name, Place<Owner> slot, const char* meaning,
                std::vector<std::string> choices = {}) {
  return {{.name = name, .meaning = meaning, .choices = std::move(choices)}, slot};
}

template <class Owner>
Key<Owner> number(const char* name, Place<Owner> slot, Dimension dimension, double least, double most,
                  const char* meaning) {
  return {{name, meaning, dimension, least, most, {}}, slot};
}

/// Any finite value.
template <class Owner>
Key<Owner> value(const char* name, Place<Owner> slot, Dimension dimension, const char* meaning) {
  return number<Owner>(name, slot, dimension, -endless, endless, meaning);
}

std::vector<std::string> shapes_where(bool ShapeWord::*allowed) {
  std::vector<std::string> words;
  for (const ShapeWord& word : shape_words())
    if (word.*allowed) words.push_back(word.word);
  return words;
}

#define AT(Owner, place) [](Owner& o) -> Slot { return &(o.place); }

// --- shapes ----------------------------------------------------------------------------------------

template <class Owner>
void add_shape(std::vector<Key<Owner>>& keys, bool ShapeWord::*allowed) {
  const Key<Owner> more[] = {
      text<Owner>("shape", AT(Owner, shape.kind), "what it is; decides which of the sizes are given",
                  shapes_where(allowed)),
      number<Owner>("radius", AT(Owner, shape.radius), length, above_zero, endless, "of a circle"),
      number<Owner>("width", AT(Owner, shape.width), length, above_zero, endless,
                    "of a rectangle, along its own x axis"),
      number<Owner>("height", AT(Owner, shape.height), length, above_zero, endless,
                    "of a rectangle, along its own y axis"),
      value<Owner>("corners", AT(Owner, shape.corners), length,
                   "of a triangle or convex polygon, in either sense of rotation"),
      value<Owner>("position", AT(Owner, shape.position), length,
                   "where the origin of the shape's frame is: the centre of a circle or rectangle, the "
                   "origin of the corners or parts"),
      value<Owner>("angle", AT(Owner, shape.angle), angle, "how far that frame is turned, anticlockwise"),
  };
  keys.insert(keys.end(), std::begin(more), std::end(more));
}

std::vector<Key<PartChoice>> part_keys() {
  std::vector<Key<PartChoice>> keys;
  add_shape(keys, &ShapeWord::of_part);
  return keys;
}

std::vector<Key<BodyChoice>> body_keys() {
  using B = BodyChoice;
  std::vector<Key<B>> keys{text<B>("name", AT(B, name), "unique; empty: body and its number")};
  add_shape(keys, &ShapeWord::of_body);
  const Key<B> more[] = {
      text<B>("material", AT(B, material), "one of [materials], or a preset"),
      value<B>("velocity", AT(B, velocity), speed, "of the centroid at the start"),
      value<B>("spin", AT(B, spin), Dimension::spin, "at the start, anticlockwise"),
      number<B>("mass", AT(B, mass), Dimension::mass, above_zero, endless,
                "none: density times area times thickness"),
      number<B>("inertia", AT(B, inertia), moment_of_inertia, above_zero, endless,
                "about the centroid, as of a body with a bore; none: that of the shape with its mass"),
      number<B>("thickness", AT(B, thickness), length, above_zero, endless, "out of the plane"),
      value<B>("charge", AT(B, charge), Dimension::charge, "for fields.coulomb_constant and electric_field"),
      number<B>("linear_drag", AT(B, linear_drag), damping, 0, endless,
                "c of the force c v against the velocity"),
      number<B>("quadratic_drag", AT(B, quadratic_drag), Dimension::quadratic_drag, 0, endless,
                "c of the force c v2 against the velocity"),
      value<B>("force", AT(B, force), Dimension::force,
               "applied at the centroid, of unchanging size and direction"),
      {{.name = "collides", .meaning = "false: fields move it and nothing touches it", .choices = {}},
       AT(B, collides)},
  };
  keys.insert(keys.end(), std::begin(more), std::end(more));
  return keys;
}

std::vector<Key<TerrainChoice>> terrain_keys() {
  using T = TerrainChoice;
  std::vector<Key<T>> keys{text<T>("name", AT(T, name), "unique; empty: terrain and its number")};
  add_shape(keys, &ShapeWord::of_terrain);
  const Key<T> more[] = {
      number<T>("depth", AT(T, shape.depth), length, above_zero, endless,
                "of the ground under a polyline, whose points are its corners"),
      text<T>("material", AT(T, material), "one of [materials], or a preset"),
  };
  keys.insert(keys.end(), std::begin(more), std::end(more));
  return keys;
}

// --- materials -------------------------------------------------------------------------------------

std::vector<Key<MaterialChoice>> material_keys() {
  using M = MaterialChoice;
  return {
      text<M>(
          "preset", AT(M, preset),
          "where what is not given comes from: concrete, brick, stone, timber, steel, rubber, glass, ptfe; "
          "empty: the one of the material's own name, else concrete"),
      number<M>("density", AT(M, density), Dimension::density, above_zero, endless, "mass per volume"),
      number<M>("young_modulus", AT(M, young_modulus), pressure, above_zero, endless,
                "decides how stiff contacts are, and the step"),
      number<M>("poisson_ratio", AT(M, poisson_ratio), ratio, 0, 0.499, "decides the tangential stiffness"),
      number<M>("friction", AT(M, friction), ratio, 0, 1e3, "Coulomb's coefficient; of two the smaller one"),
      number<M>("damping_ratio", AT(M, damping_ratio), ratio, 0, 1e3, "of a contact point"),
      number<M>("restitution", AT(M, restitution), ratio, 0.001, 1,
                "of an impact, instead of damping_ratio: 1 bounces back at full speed"),
      number<M>(
          "rocking_restitution", AT(M, rocking_restitution), ratio, 0.001, 1,
          "measured spin after over before a rocking impact; none: what the contact law gives; of two the "
          "smaller one"),
  };
}

std::vector<Key<MaterialPairChoice>> pair_keys() {
  using P = MaterialPairChoice;
  return {
      text<P>("a", AT(P, a), "a material"),
      text<P>("b", AT(P, b), "another, or the same"),
      number<P>("friction", AT(P, friction), ratio, 0, 1e3, "between the two, instead of the smaller one"),
      number<P>("damping_ratio", AT(P, damping_ratio), ratio, 0, 1e3, "of their contact points"),
      number<P>("restitution", AT(P, restitution), ratio, 0.001, 1, "instead of damping_ratio"),
      number<P>("rocking_restitution", AT(P, rocking_restitution), ratio, 0.001, 1,
                "of one rocking on the other"),
  };
}

// --- motion ----------------------------------------------------------------------------------------

std::vector<Key<HarmonicChoice>> harmonic_keys() {
  using H = HarmonicChoice;
  return {
      value<H>("amplitude", AT(H, amplitude), acceleration,
               "A of the acceleration A sin(2 pi f t), from rest"),
      number<H>("frequency", AT(H, frequency), Dimension::frequency, above_zero, endless, "f"),
      value<H>("direction", AT(H, direction), angle, "anticlockwise from the horizontal"),
  };
}

std::vector<Key<MotionChoice>> motion_keys() {
  using M = MotionChoice;
  return {
      text<M>("record", AT(M, source), "an accelerogram: a name of the catalogue, or a file's path"),
      text<M>("component", AT(M, record.component), "that drives the ground to the side; empty: the file's"),
      text<M>("station", AT(M, record.station), "of a file that holds several"),
      text<M>("member", AT(M, record.member), "of an archive, by its name; empty: all of it"),
      text<M>("response", AT(M, record.response), "StationXML with the sensitivity of miniSEED counts"),
      {{.name = "vertical", .meaning = "the vertical component drives the ground too", .choices = {}},
       AT(M, record.vertical)},
      number<M>("pga", AT(M, record.pga), acceleration, above_zero, 1e3,
                "peak that the horizontal component is scaled to; none: as recorded"),
      number<M>("scale", AT(M, record.scale), ratio, -1e6, 1e6, "factor on the record, instead of pga"),
      text<M>("format", AT(M, record.format), "id of the file's format; empty: found from its content"),
      text<M>("units", AT(M, record.units), "of the values, for a file that does not say"),
      number<M>("interval", AT(M, record.interval), time, above_zero, 10,
                "between samples, for a file that does not say"),
      text<M>("count_scale", AT(M, record.count_scale), "gal per count, 3920/6182761, for a file in counts"),
      {{.name = "filter", .meaning = "band-pass the record without phase shift", .choices = {}},
       AT(M, conditioning.filter)},
      number<M>("high_pass", AT(M, conditioning.high_pass), frequency, above_zero, 1e3, "lower corner"),
      number<M>("low_pass", AT(M, conditioning.low_pass), frequency, above_zero, 1e3,
                "upper corner; none: 25 Hz, or none for a record that its publisher filtered"),
      text<M>("table", AT(M, table),
              "a CSV file instead: time (s), displacement x (m) and, if any, y (m), at equal intervals"),
      value<M>("velocity", AT(M, velocity), speed, "constant, instead"),
  };
}

// --- joints and bonds ------------------------------------------------------------------------------

std::vector<Key<JointChoice>> joint_keys() {
  using J = JointChoice;
  return {
      text<J>("name", AT(J, name), "empty: joint and its number"),
      text<J>("kind", AT(J, kind),
              "pin: the anchors coincide; weld: the angle stays too; distance: their distance stays; spring: "
              "spring and dashpot along their line",
              {"pin", "weld", "distance", "spring"}),
      text<J>("a", AT(J, a), "name of a body or terrain"),
      text<J>("b", AT(J, b), "name of another"),
      value<J>("at", AT(J, at), length, "where both anchors are at the start, in the scene"),
      value<J>("anchor_a", AT(J, anchor_a), length, "in the frame of a, from its centroid, instead of at"),
      value<J>("anchor_b", AT(J, anchor_b), length, "in the frame of b, from its centroid, instead of at"),
      number<J>(
          "stiffness", AT(J, stiffness), Dimension::stiffness, 0, endless,
          "of a spring, 0 for a dashpot alone; of the others above 0, or none: the Young's moduli times "
          "thickness, in series"),
      number<J>("rotational_stiffness", AT(J, rotational_stiffness), Dimension::rotational_stiffness,
                above_zero, endless, "of a weld; none: stiffness times width2/12 of the slimmer body"),
      number<J>("damping", AT(J, damping), Dimension::damping, 0, endless,
                "instead of damping_ratio; of a weld's turning times rotational_stiffness over stiffness"),
      number<J>("damping_ratio", AT(J, damping_ratio), ratio, 0, 1e3,
                "of the mass that the joint feels, and of the inertia that a weld's turning feels"),
      number<J>("rest_length", AT(J, rest_length), length, 0, endless,
                "of a distance or spring; none: that of the start"),
  };
}

std::vector<Key<BondChoice>> bond_keys() {
  using B = BondChoice;
  return {
      text<B>("name", AT(B, name), "empty: bond and its number"),
      text<B>("a", AT(B, a), "name of a body or terrain"),
      text<B>("b", AT(B, b), "name of another"),
      value<B>("start", AT(B, start), length, "one end of the bonded face, in the scene"),
      value<B>("end", AT(B, end), length, "its other end"),
      number<B>("normal_stiffness", AT(B, normal_stiffness), areal_stiffness, above_zero, endless,
                "none: from the heights and Young's moduli of the two"),
      number<B>("shear_stiffness", AT(B, shear_stiffness), areal_stiffness, above_zero, endless,
                "none: the normal one times G/E"),
      number<B>("tensile_strength", AT(B, tensile_strength), pressure, 0, endless, "none: never breaks"),
      number<B>("cohesion", AT(B, cohesion), pressure, 0, endless,
                "shear strength without normal stress; none: endless"),
      number<B>("friction", AT(B, friction), ratio, 0, 1e3,
                "of the bonded face; one that has cracked has its materials'"),
      number<B>("fracture_energy", AT(B, fracture_energy), Dimension::fracture_energy, 0, endless,
                "in tension; 0: breaks at once"),
      number<B>("yield_strength", AT(B, yield_strength), pressure, above_zero, endless,
                "ductile, in tension, if below the tensile strength; none: does not yield"),
      number<B>("compressive_strength", AT(B, compressive_strength), pressure, above_zero, endless,
                "at which a face without a crack closes plastically; none: does not crush"),
      number<B>("damping_ratio", AT(B, damping_ratio), ratio, 0, 1e3, "local"),
  };
}

std::vector<Key<StoreyChoice>> storey_keys() {
  using S = StoreyChoice;
  return {
      text<S>("name", AT(S, name), "empty: storey and its number"),
      number<S>("base", AT(S, base), length, -endless, endless, "elevation of the level below"),
      number<S>("height", AT(S, height), length, above_zero, endless, "to its own level"),
      text<S>("level", AT(S, level), "names of the bodies whose mean displacement is the level's"),
      text<S>("blocks", AT(S, blocks), "names of the other bodies of the storey"),
      {{.name = "on_ground",
        .meaning = "the first storey of a neighbour: not on the one before it",
        .choices = {}},
       AT(S, on_ground)},
  };
}

// --- what holds for the whole scene ----------------------------------------------------------------

std::vector<Key<SceneHead>> head_keys() {
  using H = SceneHead;
  return {
      text<H>("title", AT(H, title), "one line, for pictures and messages"),
      value<H>("gravity", AT(H, gravity), acceleration, "uniform, on every body; none: no gravity"),
  };
}

std::vector<Key<engine::Fields>> field_keys() {
  using F = engine::Fields;
  return {
      number<F>("gravitational_constant", AT(F, gravitational_constant), Dimension::gravitational_constant, 0,
                endless, "every body attracts every other; the real one is 6.6743e-11 m3/(kg s2)"),
      number<F>("coulomb_constant", AT(F, coulomb_constant), Dimension::coulomb_constant, 0, endless,
                "charges act on each other; the real one is 8.9875517923e9 N m2/C2"),
      number<F>("softening", AT(F, softening), length, 0, endless,
                "s of the potential 1/sqrt(r2 + s2), so that near bodies are not flung apart"),
      number<F>("opening_angle", AT(F, opening_angle), ratio, 0, 2,
                "of the Barnes-Hut tree; 0: every pair is summed"),
      value<F>("electric_field", AT(F, electric_field), Dimension::electric_field, "uniform"),
  };
}

std::vector<Key<engine::ContactOptions>> contact_keys() {
  using C = engine::ContactOptions;
  return {
      number<C>("point_stiffness", AT(C, point_stiffness), stiffness, above_zero, endless,
                "of every contact point; none: from Young's moduli and sizes"),
      number<C>("resting_damping_ratio", AT(C, resting_damping_ratio), ratio, 0, 1e3,
                "greatest damping ratio of a face at rest; corners that land have their materials'"),
      number<C>("tangential_ratio", AT(C, tangential_ratio), ratio, above_zero, 10,
                "tangential over normal stiffness; none: G/E"),
  };
}

std::vector<Key<SceneSolve>> solve_keys() {
  using S = SceneSolve;
  return {
      number<S>("duration", AT(S, duration), time, above_zero, 1e12, "simulated time"),
      text<S>("integrator", AT(S, integrator), "how the motion is integrated; automatic: by accuracy",
              integrator_choices()),
      text<S>("accuracy", AT(S, accuracy),
              "chooses integrator, step and tolerance by what the scene contains",
              {"draft", "standard", "reference"}),
      number<S>("step_fraction", AT(S, step_fraction), ratio, 1e-4, 0.999,
                "time step as a part of the stability bound, instead of accuracy's"),
      number<S>("step", AT(S, step), time, above_zero, endless,
                "time step, instead of both; refused above the stability bound"),
      number<S>("tolerance", AT(S, tolerance), ratio, 1e-15, 1,
                "of an integrator that chooses its own step; with an automatic one instead of accuracy"),
      number<S>(
          "threads", AT(S, threads), count, 1, 256,
          "threads that share every step, worth it above some thousand bodies; the results are the same"),
      {{.name = "settle", .meaning = "come to rest under gravity before the motion", .choices = {}},
       AT(S, settle)},
  };
}

std::vector<Key<SceneOutput>> output_keys() {
  using O = SceneOutput;
  return {
      number<O>("rate", AT(O, rate), frequency, above_zero, 1e9, "output times a second"),
      text<O>("directory", AT(O, directory), "where the results are written"),
      text<O>("bodies", AT(O, bodies), "whose motion is kept, by name; empty: all"),
      text<O>("quantities", AT(O, quantities), "what is kept of it",
              {"position", "velocity", "acceleration"}),
      number<O>("pictures", AT(O, pictures), count, 0, 8, "in the film strip; 0: none"),
      {{.name = "film", .meaning = "a film, where ffmpeg is installed", .choices = {}}, AT(O, film)},
  };
}

#undef AT

template <class Owner>
void document(const std::string& section, std::vector<DocumentedKey>& all) {
  for (const Key<Owner>& key : keys_of<Owner>())
    all.push_back({section, key.name, kind_of(key), default_of(key), range_of(key), key.meaning});
}

}  // namespace

std::span<const ShapeWord> shape_words() {
  static const std::vector<ShapeWord> words{
      {"circle", true, true, true, {"radius"}, {}},
      {"triangle", true, true, true, {"corners"}, {}},
      {"rectangle", true, true, true, {"width", "height"}, {}},
      {"polygon", true, true, true, {"corners"}, {}},
      {"compound", true, false, false, {"parts"}, {}},
      {"half-plane", false, true, false, {}, {}},
      {"polyline", false, true, false, {"corners"}, {"depth"}},
  };
  return words;
}

const ShapeWord* find_shape_word(const std::string& word) {
  const auto it = std::ranges::find(shape_words(), word, &ShapeWord::word);
  return it == shape_words().end() ? nullptr : &*it;
}

#define KEYS_OF(Owner, make)                            \
  template <>                                           \
  std::span<const Key<Owner>> keys_of<Owner>() {        \
    static const std::vector<Key<Owner>> keys = make(); \
    return keys;                                        \
  }
KEYS_OF(SceneHead, head_keys)
KEYS_OF(MaterialChoice, material_keys)
KEYS_OF(MaterialPairChoice, pair_keys)
KEYS_OF(BodyChoice, body_keys)
KEYS_OF(PartChoice, part_keys)
KEYS_OF(TerrainChoice, terrain_keys)
KEYS_OF(MotionChoice, motion_keys)
KEYS_OF(HarmonicChoice, harmonic_keys)
KEYS_OF(JointChoice, joint_keys)
KEYS_OF(BondChoice, bond_keys)
KEYS_OF(StoreyChoice, storey_keys)
KEYS_OF(engine::Fields, field_keys)
KEYS_OF(engine::ContactOptions, contact_keys)
KEYS_OF(SceneSolve, solve_keys)
KEYS_OF(SceneOutput, output_keys)
#undef KEYS_OF

std::vector<DocumentedKey> documented_scene_keys() {
  std::vector<DocumentedKey> all;
  document<SceneHead>("", all);
  document<MaterialChoice>("materials.NAME", all);
  document<MaterialPairChoice>("material_pair", all);
  document<BodyChoice>("body", all);
  document<PartChoice>("body.parts", all);
  document<TerrainChoice>("terrain", all);
  document<MotionChoice>("terrain.motion", all);
  document<HarmonicChoice>("terrain.motion.harmonic", all);
  document<engine::Fields>("fields", all);
  document<JointChoice>("joint", all);
  document<BondChoice>("bond", all);
  document<StoreyChoice>("storey", all);
  document<engine::ContactOptions>("contact", all);
  document<SceneSolve>("solve", all);
  document<SceneOutput>("output", all);
  return all;
}

}  // namespace dougong::app
