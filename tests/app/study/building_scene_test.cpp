// Layouts written as scene files and read back, and buildings by hand.
#include "app/study/building_scene.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "app/study/import_outlines.h"
#include "app/study/scenario.h"
#include "app/study/scene_file.h"
#include "structures/layouts/layout.h"
#include "structures/model_check.h"

namespace dougong::app {
namespace {

using ::testing::HasSubstr;

class EveryLayoutAsAScene : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryLayoutAsAScene, ::testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& layout : structures::layouts()) names.push_back(layout.name);
                           return names;
                         }()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(EveryLayoutAsAScene, ComesBack) {
  const structures::Building before = structures::build_layout(GetParam());
  const structures::Building after =
      building_of(read_scene(to_toml(description_of(before)), "exported.toml"), "exported.toml");
  ASSERT_EQ(after.scene.bodies.size(), before.scene.bodies.size());
  for (std::size_t i = 0; i < before.scene.bodies.size(); ++i) {
    const engine::Body &a = before.scene.bodies[i], &b = after.scene.bodies[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_NEAR(a.position.x, b.position.x, 1e-12);
    EXPECT_NEAR(a.position.y, b.position.y, 1e-12);
    EXPECT_EQ(a.mass, b.mass);
    EXPECT_EQ(before.scene.materials[a.material].young_modulus,
              after.scene.materials[b.material].young_modulus);
  }
  ASSERT_EQ(after.scene.bonds.size(), before.scene.bonds.size());
  for (std::size_t i = 0; i < before.scene.bonds.size(); ++i) {
    EXPECT_EQ(after.scene.bonds[i].normal_stiffness, before.scene.bonds[i].normal_stiffness);
    EXPECT_EQ(after.scene.bonds[i].yield_strength, before.scene.bonds[i].yield_strength);
  }
  EXPECT_EQ(after.scene.joints.size(), before.scene.joints.size());
  ASSERT_EQ(after.storeys.size(), before.storeys.size());
  for (std::size_t i = 0; i < before.storeys.size(); ++i) {
    EXPECT_EQ(after.storeys[i].name, before.storeys[i].name);
    EXPECT_EQ(after.storeys[i].level_blocks, before.storeys[i].level_blocks);
    EXPECT_EQ(after.storeys[i].storey_blocks.size(), before.storeys[i].storey_blocks.size());
  }
  for (const structures::Finding& finding : structures::check_model(after)) ADD_FAILURE() << finding.message;
}

TEST(LayoutAsAScene, KeepsIsolatorsAndDampers) {
  const auto word = [](const char* parameter, const char* chosen) {
    return structures::value_of_word(*structures::find_layout("concrete-frame").parameter(parameter), chosen);
  };
  for (const char* damper : {"viscous", "friction", "tuned-mass"}) {
    const structures::Building before = structures::build_layout(
        "concrete-frame",
        {{"isolation", word("isolation", "friction-pendulum")}, {"damper", word("damper", damper)}});
    const structures::Building after = building_of(read_scene(to_toml(description_of(before)), "x"), "x");
    ASSERT_EQ(after.scene.joints.size(), before.scene.joints.size());
    for (std::size_t i = 0; i < before.scene.joints.size(); ++i) {
      EXPECT_EQ(after.scene.joints[i].stiffness, before.scene.joints[i].stiffness);
      EXPECT_EQ(after.scene.joints[i].damping, before.scene.joints[i].damping);
    }
    ASSERT_EQ(after.scene.material_pairs.size(), 1u);
    EXPECT_EQ(after.scene.material_pairs[0].friction_coefficient, 0.05);
  }
}

const std::string by_hand = R"(title = "two stones"
[[body]]
name = "lower"
shape = "rectangle"
width = "1 m"
height = "1 m"
position = ["0 m", "0.5 m"]
[[body]]
name = "upper"
shape = "rectangle"
width = "1 m"
height = "1 m"
position = ["0 m", "1.5 m"]
[[terrain]]
name = "ground"
shape = "rectangle"
width = "10 m"
height = "1 m"
position = ["0 m", "-0.5 m"]
)";

std::string with_storeys(const std::string& level) {
  return by_hand + "[[storey]]\nname = \"S1\"\nbase = \"0 m\"\nheight = \"2 m\"\nlevel = [\"" + level +
         "\"]\nblocks = [\"lower\"]\n";
}

std::string errors_of(const std::string& text) {
  try {
    building_of(read_scene(text, "hand.toml"), "hand.toml");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "none";
}

TEST(BuildingByHand, HasTheStoreysThatItLists) {
  const structures::Building building =
      building_of(read_scene(with_storeys("upper"), "hand.toml"), "hand.toml");
  EXPECT_EQ(building.layout, "two stones");
  ASSERT_EQ(building.storeys.size(), 1u);
  EXPECT_EQ(building.storeys[0].level_blocks, std::vector<std::size_t>{1});
  EXPECT_EQ(building.storeys[0].storey_blocks, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(building.storeys[0].height, 2.0);
}

TEST(BuildingByHand, RefusesWhatIsNoBuilding) {
  EXPECT_THAT(errors_of(by_hand), HasSubstr("hand.toml: expected [[storey]]"));
  EXPECT_THAT(errors_of(with_storeys("uper")),
              HasSubstr("there is no body \"uper\"; did you mean \"upper\"?"));
  EXPECT_THAT(errors_of(with_storeys("lower")), HasSubstr("body lower is in a storey already"));
  std::string moving = with_storeys("upper");
  moving.replace(moving.find("height = \"1 m\"\n"), 15, "height = \"1 m\"\nspin = \"1 rad/s\"\n");
  EXPECT_THAT(errors_of(moving), HasSubstr("body lower moves at the start"));
}

TEST(BuildingByHand, StandsOnAHalfPlane) {
  std::string text = with_storeys("upper");
  const std::size_t at = text.find("shape = \"rectangle\"", text.find("[[terrain]]"));
  text.replace(at, text.find("[[storey]]") - at, "shape = \"half-plane\"\n");
  EXPECT_TRUE(structures::check_model(building_of(read_scene(text, "x"), "x")).empty());
}

class ImportedFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / name;
    std::ofstream(path) << text;
    return path;
  }
  static std::string message(const std::function<void()>& act) {
    try {
      act();
    } catch (const ScenarioError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(ImportedFile, IsTakenByAScenarioInsteadOfALayout) {
  const auto path = write("two-stones.toml", with_storeys("upper"));
  const auto scenario_path = write("study.toml", "[layout]\nfile = \"two-stones.toml\"\n");
  const Scenario scenario = load_scenario(scenario_path, {}, RecordRule::optional);
  EXPECT_EQ(building_of(scenario).scene.bodies.size(), 2u);
  const Scenario again = read_scenario(to_toml(scenario), "again", {}, RecordRule::optional);
  EXPECT_EQ(again.layout.file, scenario.layout.file);
  const auto both = [&] {
    read_scenario("[layout]\nname = \"column\"\nfile = \"" + path.string() + "\"\n", "both", {},
                  RecordRule::optional);
  };
  EXPECT_THAT(message(both), HasSubstr("exclude each other"));
  const auto drums = [&] {
    read_scenario("[layout]\nfile = \"" + path.string() + "\"\nstoreys = 3\n", "drums", {},
                  RecordRule::optional);
  };
  EXPECT_THAT(message(drums), HasSubstr("layout.storeys: of a layout that layout.name does not name"));
}

// A statue on a floor and a neighbour: sections with parameters of their own.
TEST(ComposedScenario, ComesBackWithWhatStandsOnAndBesideIt) {
  const std::string text =
      "[layout]\nname = \"masonry-house\"\nties = \"every-floor\"\n"
      "[on]\nname = \"equipment\"\nitem = \"statue\"\nitem_height = \"1.1 m\"\nfloor_thickness = \"0 m\"\n"
      "[beside]\nname = \"column\"\ndrums = 3\ngap = \"0.2 m\"\n";
  const Scenario scenario = read_scenario(text, "study", {}, RecordRule::optional);
  const structures::Building building = building_of(scenario);
  EXPECT_EQ(building.parameters.at("on.item"), "statue");
  EXPECT_EQ(building.parameters.at("beside.drums"), "3");
  EXPECT_EQ(building.storeys.size(), 3u + 3u);
  const Scenario again = read_scenario(to_toml(scenario), "again", {}, RecordRule::optional);
  EXPECT_EQ(again.on.parameters, scenario.on.parameters);
  EXPECT_EQ(again.beside.parameters, scenario.beside.parameters);
  EXPECT_EQ(again.beside.gap, 0.2);
}

std::string scenario_errors(const std::string& text) {
  try {
    read_scenario(text, "study", {}, RecordRule::optional);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "none";
}

TEST(ComposedScenario, SaysWhereItsMistakesAre) {
  EXPECT_THAT(scenario_errors("[on]\nitem = \"statue\"\n"),
              HasSubstr("on.item: of a layout that on.name does not name"));
  EXPECT_THAT(scenario_errors("[on]\nname = \"equipmen\"\n"), HasSubstr("did you mean \"equipment\"?"));
  EXPECT_THAT(scenario_errors("[on]\nname = \"equipment\"\nitem = \"statu\"\n"),
              HasSubstr("study:3:8: item: expected one of cabinet, rack, statue, found \"statu\"; did you "
                        "mean \"statue\"?"));
  EXPECT_THAT(scenario_errors("[on]\nname = \"column\"\nlevel = 9\n"),
              HasSubstr("study:3:9: on.level: expected a level from 1 to 4, found 9"));
  EXPECT_THAT(scenario_errors("[beside]\nname = \"column\"\nthick = 1\n"),
              HasSubstr("unknown key \"beside.thick\""));
  EXPECT_THAT(scenario_errors("[layout]\nisolation = 2\n"), HasSubstr("in quotes"));
}

const std::string table =
    "block,storey,x (mm),y (mm)\n"
    "a,S1,0,0\na,S1,1000,0\na,S1,1000,500\na,S1,0,500\n"
    "b,S2,200,500\nb,S2,800,500\nb,S2,500,1500\n";

TEST_F(ImportedFile, OfOutlinesInCsvIsABuilding) {
  const auto path = write("outlines.csv", table);
  const SceneDescription d = building_from(read_csv_outlines(path), path.string(), "stone");
  const structures::Building building = building_of(d, path.string());
  ASSERT_EQ(building.scene.bodies.size(), 2u);
  EXPECT_EQ(building.storeys[0].name, "S1");
  EXPECT_NEAR(building.storeys[0].height, 0.5, 1e-12);
  EXPECT_NEAR(building.storeys[1].height, 1.0, 1e-12);
  EXPECT_NEAR(engine::area_properties(building.scene.bodies[1].shape).area, 0.3, 1e-12);
  EXPECT_TRUE(structures::check_model(building).empty());
}

TEST_F(ImportedFile, SaysWhereItsMistakesAre) {
  const auto errors = [&](const std::string& text) {
    const auto path = write("bad.csv", text);
    return message([&] { building_from(read_csv_outlines(path), "bad.csv", "stone"); });
  };
  EXPECT_THAT(errors("x,y\n"), HasSubstr("bad.csv:1: expected the heading"));
  EXPECT_THAT(errors("block,storey,x,y\n"), HasSubstr("expected \"x (m)\""));
  EXPECT_THAT(errors("block,storey,x (m),y (m)\na,S1,0\n"),
              HasSubstr("bad.csv:2: expected 4 values, found 3"));
  EXPECT_THAT(errors("block,storey,x (m),y (m)\na,S1,0,high\n"), HasSubstr("found \"high\""));
  EXPECT_THAT(errors("block,storey,x (m),y (m)\na,S1,0,0\na,S2,0,1\n"), HasSubstr("block a is in storey S1"));
  EXPECT_THAT(errors("block,storey,x (m),y (m)\na,S1,0,0\na,S1,1,1\n"), HasSubstr("outline a of S1"));
  EXPECT_THAT(errors("block,storey,x (m),y (m)\n"), HasSubstr("expected closed outlines"));
}

// R12 and newer polylines, one left open, and a line that is no outline.
const std::string drawing = R"(0
SECTION
2
ENTITIES
0
POLYLINE
8
S1
66
1
70
1
0
VERTEX
8
S1
10
0.0
20
0.0
0
VERTEX
8
S1
10
2000.0
20
0.0
0
VERTEX
8
S1
10
2000.0
20
1000.0
0
VERTEX
8
S1
10
0.0
20
1000.0
0
SEQEND
0
LINE
8
S1
10
0.0
20
0.0
11
1.0
21
1.0
0
LWPOLYLINE
8
S2
90
3
70
1
10
500.0
20
1000.0
10
1500.0
20
1000.0
10
1000.0
20
2500.0
0
LWPOLYLINE
8
S2
90
2
70
0
10
0.0
20
0.0
10
1.0
20
1.0
0
ENDSEC
0
EOF
)";

TEST_F(ImportedFile, OfPolylinesInDxfIsABuilding) {
  const auto path = write("outlines.dxf", drawing);
  const Outlines outlines = read_dxf_outlines(path, 0.001);
  ASSERT_EQ(outlines.closed.size(), 2u);
  EXPECT_EQ(outlines.left_out, 2u);
  const structures::Building building =
      building_of(building_from(outlines, path.string(), "brick"), path.string());
  EXPECT_EQ(building.scene.bodies[0].name, "S1.1");
  EXPECT_NEAR(engine::area_properties(building.scene.bodies[0].shape).area, 2.0, 1e-9);
  EXPECT_NEAR(engine::area_properties(building.scene.bodies[1].shape).area, 0.75, 1e-9);
  EXPECT_EQ(building.storeys[1].name, "S2");
  EXPECT_NEAR(building.storeys[1].height, 1.5, 1e-9);
  EXPECT_TRUE(structures::check_model(building).empty());
}

TEST_F(ImportedFile, RefusesArcsAndWhatIsNoDxf) {
  std::string curved = drawing;
  curved.insert(curved.find("0\nVERTEX\n8\nS1\n10\n2000.0"), "42\n0.5\n");
  const auto arc = write("arc.dxf", curved);
  EXPECT_THAT(message([&] { read_dxf_outlines(arc, 1.0); }), HasSubstr("expected straight segments"));
  const auto none = write("none.dxf", "this is no drawing\n");
  EXPECT_THAT(message([&] { building_from(read_dxf_outlines(none, 1.0), "none.dxf", "brick"); }),
              HasSubstr("none.dxf: expected"));
}

}  // namespace
}  // namespace dougong::app
