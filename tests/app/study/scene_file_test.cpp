#include "app/study/scene_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numbers>

#include "app/study/scene_build.h"
#include "app/study/scene_keys.h"
#include "engine/material_presets.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::string> errors(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    read_scene(text, "s.toml", overrides);
  } catch (const ScenarioError& error) {
    std::vector<std::string> lines;
    for (const LocatedMessage& message : error.messages()) lines.push_back(message.text());
    return lines;
  }
  return {};
}

engine::Scene scene_of(const SceneDescription& description) {
  BuiltScene built = build_scene(description);
  EXPECT_THAT(built.problems, IsEmpty());
  return std::move(built.scene);
}
engine::Scene scene_of(const std::string& text) {
  return scene_of(read_scene(text, "s.toml"));
}

const std::string ball = "[[body]]\nshape = \"circle\"\nradius = \"1 m\"\n";

const char* const everything = R"toml(
title = "all there is"
gravity = ["0.1 m/s2", "-1 g"]

[materials.basalt]
preset = "stone"
density = "2.9 t/m3"
friction = 0.7
restitution = 0.4

[materials."old oak"]
preset = "timber"
young_modulus = "9.3 GPa"
damping_ratio = 0.3

[[material_pair]]
a = "basalt"
b = "old oak"
friction = 0.33
restitution = "20 %"

[[body]]
name = "ball"
shape = "circle"
radius = "0.3 m"
position = ["1.1 m", "2.3 m"]
angle = "17 deg"
velocity = ["-3 m/s", "12.3 mm/s"]
spin = "33 rpm"
mass = "1.7 t"
inertia = "90 kg m2"
charge = "2.5e-6 C"
linear_drag = "3.1 N s/m"
quadratic_drag = "0.7 kg/m"
force = ["2 kN", "-0.5 N"]
material = "basalt"

[[body]]
name = "wedge"
shape = "triangle"
corners = [["0.1 m", "5 m"], ["1.3 m", "5.1 m"], ["70 cm", "6.2 m"]]
position = ["3 m", "0.7 m"]
angle = "0.1 rad"
thickness = "0.3 m"
material = "old oak"

[[body]]
shape = "rectangle"
width = "0.3 m"
height = "2.6 m"
position = ["-7 m", "1.3 m"]

[[body]]
name = "stone"
shape = "polygon"
corners = [["0 m", "0 m"], ["1 m", "0 m"], ["1.3 m", "0.9 m"], ["0.5 m", "1.7 m"], ["-0.2 m", "0.8 m"]]
position = ["9 m", "9 m"]

[[body]]
name = "hammer"
shape = "compound"
position = ["20 m", "5 m"]
angle = "-33 deg"
parts = [
  { shape = "rectangle", width = "0.1 m", height = "1 m" },
  { shape = "rectangle", width = "0.4 m", height = "0.2 m", position = ["0 m", "0.6 m"] },
  { shape = "circle", radius = "0.1 m", position = ["0.31 m", "0.6 m"] },
]

[[body]]
name = "shelf"
shape = "rectangle"
width = "1 m"
height = "0.5 m"
position = ["9.5 m", "8.75 m"]

[[terrain]]
name = "ground"
shape = "half-plane"
angle = "3 deg"
motion = { record = "wenchuan", component = "EW", pga = "0.35 g", high_pass = "0.2 Hz", vertical = true }

[[terrain]]
name = "hill"
shape = "polyline"
corners = [["-60 m", "0 m"], ["-50 m", "3 m"], ["-40 m", "1 m"]]
depth = "2 m"

[[terrain]]
shape = "rectangle"
width = "5 m"
height = "1 m"
position = ["40 m", "0 m"]
motion = { harmonic = { amplitude = "0.2 g", frequency = "1.7 Hz", direction = "30 deg" } }

[[terrain]]
shape = "circle"
radius = "1 m"
position = ["60 m", "0 m"]
motion = { velocity = ["1 m/s", "0 m/s"] }

[[terrain]]
shape = "triangle"
corners = [["80 m", "0 m"], ["81 m", "0 m"], ["80 m", "1 m"]]
motion = { table = "belt.csv" }

[fields]
gravitational_constant = "6.6743e-11 m3/(kg s2)"
coulomb_constant = "8.9875517923e9 N m2/C2"
softening = "1 mm"
opening_angle = 0.5
electric_field = ["3 V/m", "-1 kV/m"]

[[joint]]
kind = "pin"
a = "ball"
b = "wedge"
at = ["2 m", "3.1 m"]

[[joint]]
name = "rope"
kind = "distance"
a = "stone"
b = "ground"
anchor_a = ["0.1 m", "0.2 m"]
anchor_b = ["9 m", "1 m"]
stiffness = "3 MN/m"
damping = "1.5 kN s/m"
rest_length = "7 m"

[[bond]]
a = "stone"
b = "shelf"
start = ["9 m", "9 m"]
end = ["10 m", "9 m"]
tensile_strength = "2 MPa"
cohesion = "1.3 MPa"
compressive_strength = "7 MPa"
fracture_energy = "80 J/m2"
normal_stiffness = "20 GPa/m"

[contact]
tangential_ratio = 0.4

[solve]
duration = "3.3 s"
integrator = "rk4"
step = "0.013 ms"
settle = true

[output]
rate = "50 Hz"
bodies = ["ball", "hammer"]
quantities = ["position", "acceleration"]
pictures = 4
)toml";

// --- the same bits ------------------------------------------------------------------------------------

/// Every number of a scene, as bits: what must survive writing and reading.
class Bits {
 public:
  explicit Bits(const engine::Scene& scene) {
    add(scene.gravity);
    for (const auto& m : scene.materials)
      add(m.name),
          add({m.density, m.young_modulus, m.poisson_ratio, m.friction_coefficient, m.damping_ratio});
    for (const auto& p : scene.material_pairs)
      add(p.a), add(p.b), add(p.friction_coefficient), add(p.damping_ratio);
    for (const auto& b : scene.bodies) {
      add_placed(b);
      add(b.velocity), add(b.mass), add(b.inertia);
      add({b.spin, b.thickness, b.charge, b.linear_drag, b.quadratic_drag});
      add(b.applied_force);
    }
    for (const auto& t : scene.terrains) add_placed(t);
    for (const auto& j : scene.joints) {
      add(j.name), add(j.a), add(j.b), add(j.anchor_a), add(j.anchor_b), add(j.damping), add(j.rest_length);
      add({static_cast<double>(j.kind), j.stiffness, j.rotational_stiffness, j.damping_ratio});
    }
    for (const auto& b : scene.bonds) {
      add(b.name), add(b.a), add(b.b), add(b.start), add(b.end), add(b.normal_stiffness);
      add({b.tensile_strength, b.cohesion, b.friction_coefficient, b.fracture_energy, b.yield_strength,
           b.compressive_strength});
    }
    const engine::Fields& f = scene.fields;
    add({f.gravitational_constant, f.coulomb_constant, f.softening, f.opening_angle});
    add(f.electric_field), add(scene.contact.point_stiffness), add(scene.contact.tangential_ratio);
  }
  friend bool operator==(const Bits&, const Bits&) = default;
  std::size_t size() const { return bits_.size(); }

 private:
  void add(double value) { bits_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(std::initializer_list<double> values) {
    for (const double value : values) add(value);
  }
  void add(std::size_t value) { bits_.push_back(value); }
  void add(const std::string& text) { texts_.push_back(text); }
  void add(engine::Vec2 v) { add({v.x, v.y}); }
  void add(engine::Owner o) { add(o.index), add(o.terrain ? 1.0 : 0.0); }
  void add(const std::optional<double>& value) {
    add(value ? 1.0 : 0.0);
    add(value.value_or(0.0));
  }
  void add(const engine::Circle& circle) { add(circle.radius); }
  void add(const engine::ConvexPolygon& polygon) {
    for (const engine::Vec2 v : polygon.vertices()) add(v);
  }
  void add(const engine::HalfPlane&) {}
  void add(const engine::Compound& compound) {
    for (const engine::Part& part : compound.parts) {
      std::visit([&](const auto& shape) { add(shape); }, part.shape);
      add(part.position), add(part.angle);
    }
  }
  template <class Thing>
  void add_placed(const Thing& thing) {
    add(thing.name), add(thing.shape.index()), add(thing.material), add(thing.position), add(thing.angle);
    std::visit([&](const auto& shape) { add(shape); }, thing.shape);
  }

  std::vector<std::uint64_t> bits_;
  std::vector<std::string> texts_;
};

TEST(SceneFile, WrittenAndReadAgainGivesTheSameBits) {
  const SceneDescription first = read_scene(everything, "s.toml");
  const std::string text = to_toml(first);
  const SceneDescription second = read_scene(text, "written.toml");
  EXPECT_GT(Bits(scene_of(first)).size(), 150u);
  EXPECT_EQ(Bits(scene_of(first)), Bits(scene_of(second)));
  EXPECT_EQ(to_toml(second), text);
}

TEST(SceneFile, KeepsNumbersThatHaveNoShortDecimal) {
  SceneDescription d = read_scene(ball, "s.toml");
  d.bodies[0].shape.position = {1.0 / 3.0, -std::numbers::pi * 1e-13};
  d.bodies[0].shape.angle = std::nextafter(0.1, 1.0);
  d.bodies[0].velocity = {std::numeric_limits<double>::denorm_min(), -0.0};
  d.bodies[0].mass = 1e-30 / 7.0;
  d.bodies[0].inertia = 1e3 / 7.0;
  d.head.gravity = engine::Vec2{1e-300, 6.02e23};
  EXPECT_EQ(Bits(scene_of(d)), Bits(scene_of(to_toml(d))));
}

TEST(SceneFile, KeepsNamesOfAnySpelling) {
  SceneDescription d = read_scene(ball, "s.toml");
  d.bodies[0].name = "a \"quoted\" \\ name, with = and # and \t";
  d.materials.push_back({"gneiss é [x].y", "stone", {}, {}, {}, {}, {}, {}});
  d.bodies[0].material = "gneiss é [x].y";
  const SceneDescription again = read_scene(to_toml(d), "s.toml");
  EXPECT_EQ(again.bodies[0].name, d.bodies[0].name);
  EXPECT_EQ(scene_of(again).materials[0].name, "gneiss é [x].y");
}

// --- what it means -------------------------------------------------------------------------------------

TEST(SceneFile, ReadsUnits) {
  const engine::Scene scene = scene_of(everything);
  EXPECT_DOUBLE_EQ(scene.gravity.y, -9.80665);
  EXPECT_DOUBLE_EQ(scene.bodies[0].spin, 33.0 * 2.0 * std::numbers::pi / 60.0);
  EXPECT_DOUBLE_EQ(*scene.bodies[0].mass, 1700.0);
  EXPECT_DOUBLE_EQ(*scene.bodies[0].inertia, 90.0);
  EXPECT_DOUBLE_EQ(scene.bodies[0].charge, 2.5e-6);
  EXPECT_EQ(scene.bodies[0].applied_force, (engine::Vec2{2000.0, -0.5}));
  EXPECT_DOUBLE_EQ(scene.fields.electric_field.y, -1000.0);
  EXPECT_DOUBLE_EQ(scene.materials[0].density, 2900.0);
}

TEST(SceneFile, PlacesCornersInTheFrameOfTheBody) {
  const engine::Scene scene = scene_of(
      "[[body]]\nshape = \"triangle\"\ncorners = [[\"0 m\",\"0 m\"],[\"3 m\",\"0 m\"],[\"0 m\",\"3 m\"]]\n"
      "position = [\"10 m\", \"20 m\"]\nangle = \"90 deg\"\n");
  EXPECT_NEAR(scene.bodies[0].position.x, 9.0, 1e-14);
  EXPECT_NEAR(scene.bodies[0].position.y, 21.0, 1e-14);
}

TEST(SceneFile, GivesWhatIsNotSaidItsDefault) {
  const SceneDescription d = read_scene(ball, "s.toml");
  const engine::Scene scene = scene_of(d);
  EXPECT_EQ(scene.bodies[0].name, "body1");
  EXPECT_EQ(scene.materials[0].name, "concrete");
  EXPECT_EQ(scene.gravity, (engine::Vec2{0.0, -engine::standard_gravity}));
  EXPECT_EQ(d.solve.duration, 10.0);
}

TEST(SceneFile, TakesPresetsByNameAndCompletesThem) {
  const engine::Scene scene =
      scene_of("[materials.steel]\nfriction = 0.1\n" + ball + "material = \"glass\"\n");
  EXPECT_EQ(scene.materials[0].density, 7850.0) << "a material of a preset's name starts from it";
  EXPECT_EQ(scene.materials[0].friction_coefficient, 0.1);
  EXPECT_EQ(scene.materials[1].young_modulus, engine::find_material_preset("glass")->material.young_modulus);
}

TEST(SceneFile, TurnsRestitutionIntoADampingRatio) {
  const engine::Scene scene = scene_of("[materials.m]\nrestitution = 0.5\n" + ball + "material = \"m\"\n");
  EXPECT_NEAR(engine::restitution_for_damping_ratio(scene.materials[0].damping_ratio), 0.5, 1e-9);
}

TEST(SceneFile, SwitchesGravityOff) {
  EXPECT_EQ(scene_of("gravity = \"none\"\n" + ball).gravity, engine::Vec2{});
}

TEST(SceneFile, PutsAJointWhereTheSceneSays) {
  const engine::Scene scene = scene_of(
      ball +
      "position = [\"1 m\", \"2 m\"]\nangle = \"90 deg\"\n[[terrain]]\nname = \"g\"\nshape = "
      "\"half-plane\"\n[[joint]]\nkind = \"pin\"\na = \"body1\"\nb = \"g\"\nat = [\"1 m\", \"5 m\"]\n");
  EXPECT_NEAR(scene.joints[0].anchor_a.x, 3.0, 1e-15);
  EXPECT_NEAR(scene.joints[0].anchor_a.y, 0.0, 1e-15);
  EXPECT_EQ(scene.joints[0].anchor_b, (engine::Vec2{1.0, 5.0}));
  EXPECT_TRUE(scene.joints[0].b.terrain);
}

// --- mistakes --------------------------------------------------------------------------------------------

TEST(SceneErrors, AreAllCollectedWithTheirPlaces) {
  EXPECT_THAT(
      errors("[[body]]\nshape = \"circle\"\nradius = 3\nmas = \"1 kg\"\n[solve]\nduration = \"3 m\"\n"),
      ElementsAre(AllOf(HasSubstr("s.toml:3:10: body.radius: expected a length with its unit"),
                        HasSubstr("found the bare number 3")),
                  HasSubstr("s.toml:4:1: unknown key \"body.mas\"; did you mean \"mass\"?"),
                  AllOf(HasSubstr("s.toml:6:12: solve.duration"), HasSubstr("m is a unit of length"))));
}

struct Wrong {
  std::string text, message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.message;
}
class SceneMistakes : public testing::TestWithParam<Wrong> {};

TEST_P(SceneMistakes, AreNamed) {
  EXPECT_THAT(errors(GetParam().text), testing::Contains(HasSubstr(GetParam().message)));
}

const std::string joint = ball + "[[joint]]\nkind = \"pin\"\na = \"body1\"\n";
INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, SceneMistakes,
    testing::Values(
        Wrong{"[[bdy]]\n", "s.toml:1:3: unknown key \"bdy\"; did you mean \"body\"?"},
        Wrong{"", "s.toml: expected at least one [[body]]"},
        Wrong{"title = \"empty\"\n", "expected at least one [[body]]"},
        Wrong{"[body]\nshape = \"circle\"\n", "body: expected a list of tables [[body]]"},
        Wrong{"body = 3\n", "body: expected a list of tables"}, Wrong{"[[body]]\n", "expected a shape"},
        Wrong{"[[body]]\nshape = \"squircle\"\n",
              "expected one of circle, triangle, rectangle, polygon, compound, found \"squircle\""},
        Wrong{"[[body]]\nshape = \"half-plane\"\n", "expected one of circle"},
        Wrong{"[[body]]\nshape = \"circle\"\n", "a circle needs radius"},
        Wrong{"[[body]]\nshape = \"circle\"\nradius = \"-1 m\"\n", "expected a value above 0 m, found -1 m"},
        Wrong{"[[body]]\nshape = \"circle\"\nradius = \"nan m\"\n", "found \"nan m\""},
        Wrong{"[[body]]\nshape = \"circle\"\nradius = nan\n", "body.radius"},
        Wrong{"[[body]]\nshape = \"circle\"\nradius = \"1e400 m\"\n", "beyond what a double holds"},
        Wrong{ball + "width = \"1 m\"\n",
              "s.toml:4:9: body.width of body1: width does not belong to a circle"},
        Wrong{ball + "position = [\"1 m\"]\n", "expected two values"},
        Wrong{ball + "position = \"1 m\"\n", "expected a point"},
        Wrong{ball + "position = [1, 2]\n", "found the bare number 1"},
        Wrong{ball + "velocity = [\"1 m/s\", \"2 m\"]\n", "m is a unit of length"},
        Wrong{ball + "mass = \"0 kg\"\n", "above 0 kg"},
        Wrong{ball + "inertia = \"3 kg\"\n", "kg is a unit of mass"},
        Wrong{ball + "material = \"concret\"\n", "did you mean \"concrete\"?"},
        Wrong{ball + "name = 3\n", "expected a text in quotes"},
        Wrong{ball + "name = \"x\"\n" + ball + "name = \"x\"\n", "there already is a body \"x\""},
        Wrong{"[[body]]\nshape = \"triangle\"\ncorners = [[\"0 m\",\"0 m\"],[\"1 m\",\"1 m\"],[\"2 m\",\"2 "
              "m\"]]\n",
              "s.toml:3:11: body.corners of body1: polygon has no area"},
        Wrong{"[[body]]\nshape = \"triangle\"\ncorners = [[\"0 m\",\"0 m\"],[\"1 m\",\"1 m\"]]\n",
              "three corners, found 2"},
        Wrong{"[[body]]\nshape = \"polygon\"\ncorners = [[\"0 m\",\"0 m\"],[\"2 m\",\"0 m\"],[\"1 m\",\"0.1 "
              "m\"],[\"1 "
              "m\",\"2 m\"]]\n",
              "not convex"},
        Wrong{"[[body]]\nshape = \"compound\"\nparts = [{ shape = \"circle\", radius = \"1 m\" }, { shape = "
              "\"circle\", radius = \"1 m\" }]\n",
              "body.parts of body1"},
        Wrong{"[materials.m]\ndamping_ratio = 1\nrestitution = 0.5\n" + ball, "exclude each other"},
        Wrong{"[materials]\nm = 3\n" + ball, "materials.m: expected a table"},
        Wrong{"[materials.m]\npreset = \"steal\"\n" + ball, "did you mean \"steel\"?"},
        Wrong{ball + "[[terrain]]\nshape = \"half-plane\"\nmotion = {}\n", "expected exactly one of record"},
        Wrong{ball + "[[terrain]]\nshape = \"half-plane\"\nmotion = { recrd = \"kobe\" }\n",
              "did you mean \"record\"?"},
        Wrong{ball + "[[terrain]]\nshape = \"half-plane\"\nmotion = { record = \"a\", pga = \"1 g\", scale = "
                     "2 }\n",
              "pga and scale exclude each other"},
        Wrong{joint + "b = \"body1\"\n", "expected at, or anchor_a and anchor_b"},
        Wrong{ball + "[[joint]]\nkind = \"spring\"\n", "a spring needs its stiffness"},
        Wrong{joint + "b = \"g\"\nanchor_a = [\"0 m\", \"0 m\"]\nanchor_b = [\"0.5 m\", \"0 "
                      "m\"]\n[[terrain]]\nname = "
                      "\"g\"\nshape = \"half-plane\"\n",
              "joint.anchor_b of joint1: the anchors of a pin must be at one place, found them 0.5 m apart"},
        Wrong{joint + "b = \"body1\"\n", "a and b are the same"},
        Wrong{joint + "b = \"bdy1\"\n",
              "joint.b of joint1: there is no body or terrain \"bdy1\"; did you mean"},
        Wrong{joint, "expected the name of a body or terrain"},
        Wrong{ball + "[solve]\nintegrator = \"rk5\"\n", "did you mean \"rk4\"?"},
        Wrong{ball + "[solve]\nduration = \"0 s\"\n", "above 0 s"},
        Wrong{ball + "[solve]\nstep = \"1 ms\"\nstep_fraction = 0.5\n", "exclude each other"},
        Wrong{ball + "[output]\nbodies = [\"bal\"]\n", "output.bodies"},
        Wrong{ball + "[output]\nquantities = [\"sped\"]\n", "expected one of position"},
        Wrong{ball + "[output]\npictures = 2.5\n", "a whole number"}, Wrong{"this is no TOML", "s.toml:1:"}));

// What nothing reads because of what stands beside it.
const std::string moving = ball + "[[terrain]]\nshape = \"half-plane\"\n";
const std::string bonded =
    "[[body]]\nname = \"low\"\nshape = \"rectangle\"\nwidth = \"1 m\"\nheight = \"1 m\"\n"
    "[[body]]\nname = \"high\"\nshape = \"rectangle\"\nwidth = \"1 m\"\nheight = \"1 m\"\n"
    "position = [\"0 m\", \"1 m\"]\n[[bond]]\na = \"low\"\nb = \"high\"\n";
const std::string on_the_face = bonded + "start = [\"-0.5 m\", \"0.5 m\"]\nend = [\"0.5 m\", \"0.5 m\"]\n";
const std::string pinned = joint + "b = \"g\"\nat = [\"0 m\", \"0 m\"]\n";
const std::string wall = "[[terrain]]\nname = \"g\"\nshape = \"half-plane\"\n";
INSTANTIATE_TEST_SUITE_P(
    OfWhatNothingReads, SceneMistakes,
    testing::Values(
        Wrong{moving + "motion = { table = \"t.csv\", pga = \"0.3 g\" }\n",
              "s.toml:6:35: terrain.motion.pga of terrain1: belongs to a record"},
        Wrong{moving + "motion = { harmonic = { frequency = \"2 Hz\" }, component = \"EW\" }\n",
              "terrain.motion.component of terrain1: belongs to a record"},
        Wrong{moving + "motion = { velocity = [\"1 m/s\", \"0 m/s\"], filter = false }\n",
              "terrain.motion.filter of terrain1: belongs to a record"},
        Wrong{moving + "motion = { record = \"kobe\", filter = false, low_pass = \"20 Hz\" }\n",
              "terrain.motion.low_pass of terrain1: a corner of the filter, which is switched off"},
        Wrong{moving + "motion = { record = \"kobe\", count_scale = \"1/2\" }\n",
              "terrain.motion.count_scale of terrain1: needs units = \"counts\""},
        Wrong{pinned + "rest_length = \"1 m\"\n" + wall,
              "s.toml:9:15: joint.rest_length of joint1: does not belong to a pin"},
        Wrong{pinned + "rotational_stiffness = \"1 kN m/rad\"\n" + wall,
              "joint.rotational_stiffness of joint1: does not belong to a pin"},
        Wrong{on_the_face + "fracture_energy = \"10 J/m2\"\n",
              "bond.fracture_energy of bond1: needs a tensile_strength"},
        Wrong{on_the_face +
                  "fracture_energy = \"10 J/m2\"\ntensile_strength = \"2 MPa\"\nyield_strength = \"1 MPa\"\n",
              "bond.fracture_energy of bond1: a bond that yields"},
        Wrong{on_the_face + "tensile_strength = \"2 MPa\"\nyield_strength = \"3 MPa\"\n",
              "bond.yield_strength of bond1: expected less than the tensile strength of 2 MPa, found 3 MPa"},
        Wrong{on_the_face + "friction = 0.5\n", "bond.friction of bond1: needs a cohesion"},
        Wrong{bonded + "start = [\"-0.5 m\", \"3 m\"]\nend = [\"0.5 m\", \"3 m\"]\n",
              "bond.start of bond1: expected on the face of low, found 2.5 m from it"},
        Wrong{bonded + "start = [\"-0.5 m\", \"0.5 m\"]\nend = [\"1.5 m\", \"0.5 m\"]\n",
              "bond.end of bond1: expected on the face of high, found 1 m from it"},
        Wrong{"[[material_pair]]\na = \"steel\"\nb = \"steel\"\n" + ball,
              "material_pair.a: expected friction, damping_ratio"},
        Wrong{"[[material_pair]]\na = \"steel\"\nb = \"ptfe\"\nfriction = 0.1\n"
              "[[material_pair]]\na = \"ptfe\"\nb = \"steel\"\nfriction = 0.2\n" +
                  ball,
              "s.toml:6:5: material_pair.a: there already is a pair of ptfe and steel"},
        Wrong{ball + "[contact]\npoint_stiffness = \"1 MN/m\"\n[solve]\nintegrator = \"moreau-jean\"\n",
              "s.toml:5:19: contact.point_stiffness: of contact springs, which moreau-jean does not have"},
        Wrong{"gravity = \"none\"\n" + ball + "[solve]\nsettle = true\n",
              "solve.settle: bodies come to rest under gravity, found none"}));

TEST(SceneErrors, NameAFolderAndAMissingFileAndAHugeOne) {
  EXPECT_THROW(load_scene("/"), ScenarioError);
  EXPECT_THROW(load_scene("/nowhere/at/all.toml"), ScenarioError);
  const auto huge = std::filesystem::temp_directory_path() / fmt::format("huge-{}.toml", ::getpid());
  std::ofstream(huge) << "x";
  std::filesystem::resize_file(huge, std::uintmax_t{8} << 30);
  EXPECT_THROW(load_scene(huge), ScenarioError);
  std::filesystem::remove(huge);
}

// --- overrides -------------------------------------------------------------------------------------------

TEST(SceneOverrides, ReachThingsByNameAndByNumber) {
  const auto set = [](const char* text) { return std::vector<Override>{parse_override(text)}; };
  const std::string text = ball + "name = \"big ball\"\n" + ball;
  EXPECT_EQ(read_scene(text, "s", set("body.big ball.mass=3 t")).bodies[0].mass, 3000.0);
  EXPECT_EQ(read_scene(text, "s", set("body.2.radius=5 m")).bodies[1].shape.radius, 5.0);
  EXPECT_EQ(read_scene(text, "s", set("body.body2.position=[\"1 m\", \"2 m\"]")).bodies[1].shape.position.y,
            2.0);
  EXPECT_EQ(read_scene(text, "s", set("duration=3 s")).solve.duration, 3.0);
  EXPECT_EQ(read_scene(text, "s", set("step-fraction=0.25")).solve.step_fraction, 0.25);
  EXPECT_FALSE(read_scene(text, "s", set("gravity=none")).head.gravity);
  EXPECT_EQ(read_scene(text, "s", set("materials.concrete.friction=0.9")).materials[0].friction, 0.9);
  EXPECT_EQ(read_scene(text, "s", set("output.pictures=0")).output.pictures, 0.0);
}

TEST(SceneOverrides, ThatLeadNowhereAreErrors) {
  const auto said = [](const char* text) { return errors(ball, {parse_override(text)}); };
  EXPECT_THAT(said("body.nobody.mass=3 t"), ElementsAre(HasSubstr("there is no body \"nobody\"")));
  EXPECT_THAT(said("duratoin=3 s"), ElementsAre(HasSubstr("did you mean \"duration\"?")));
  EXPECT_THAT(said("body.body1.mass=3"), ElementsAre(HasSubstr("--set body.body1.mass=3: body.mass")));
  EXPECT_THAT(said("solve.duratoin=3 s"), ElementsAre(HasSubstr("did you mean \"duration\"?")));
  EXPECT_THAT(said("body.body1=3"), ElementsAre(HasSubstr("body.NAME.KEY")));
}

// --- the document ------------------------------------------------------------------------------------------

TEST(SceneDocument, ListsExactlyTheKeysThereAre) {
  std::vector<std::string> expected, found;
  for (const DocumentedKey& key : documented_scene_keys())
    expected.push_back(fmt::format("| `{}{}{}` | {} | `{}` | {} | {} |", key.section,
                                   key.section.empty() ? "" : ".", key.name, key.kind, key.standard,
                                   key.range, key.meaning));
  std::ifstream file(std::filesystem::path(__FILE__).parent_path() / "../../../docs/scene.md");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("| `") && std::ranges::count(line, '|') == 6) found.push_back(line);
  EXPECT_EQ(found, expected);
}

/// The blocks of TOML in the document.
std::vector<std::string> examples_of_the_document() {
  std::ifstream file(std::filesystem::path(__FILE__).parent_path() / "../../../docs/scene.md");
  std::vector<std::string> examples;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```toml") examples.emplace_back();
    if (inside && line != "```") examples.back() += line + "\n";
    inside = line == "```toml" || (inside && line != "```");
  }
  return examples;
}

TEST(SceneDocument, HasExamplesThatAreSound) {
  const auto examples = examples_of_the_document();
  EXPECT_GE(examples.size(), 2u);
  for (const std::string& text : examples) EXPECT_THAT(errors(text), IsEmpty()) << text;
}

TEST(SceneOrScenario, IsToldByItsSections) {
  EXPECT_TRUE(describes_a_scene(ball, "s"));
  EXPECT_FALSE(describes_a_scene("[record]\nname = \"wenchuan\"\n", "s"));
}

}  // namespace
}  // namespace dougong::app
