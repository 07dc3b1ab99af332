// Modes of a building by its scenario: a cantilever of bonded blocks (B01), and what the masses add up to.
#include "app/study/modes_study.h"

#include <gmock/gmock.h>

#include "tests/engine/reference.h"

namespace dougong::app {
namespace {

Scenario scenario_of(const std::vector<std::pair<std::string, std::string>>& values) {
  std::vector<Override> overrides;
  for (const auto& [key, value] : values) overrides.push_back({key, value, "test"});
  return scenario_from(overrides, RecordRule::optional);
}

// 10 blocks of 1 x 1 m, E 25 GPa, 2400 kg/m3. The table knows no gravity, which softens f1 by less than 0.1
// %.
TEST(ModesOfABuilding, AreThoseOfTheCantileverOfB01) {
  const ModesResult r = modes_of(scenario_of({{"layout.name", "brick-wall"},
                                              {"courses", "10"},
                                              {"bricks_per_course", "1"},
                                              {"levels", "1"},
                                              {"brick_length", "1 m"},
                                              {"brick_height", "1 m"},
                                              {"bond_pattern", "stack"},
                                              {"joints", "mortar"},
                                              {"mortar_thickness", "0 m"},
                                              {"young_modulus", "25 GPa"},
                                              {"density", "2400 kg/m3"},
                                              {"tensile_strength", "1 MPa"}}),
                                 8);
  ASSERT_TRUE(r.settle.settled);
  std::vector<double> frequencies;
  double mass = 0.0;
  for (const engine::Mode& mode : r.modes) {
    mass += mode.participation;
    if (mode.participation > 1e-6) frequencies.push_back(1.0 / mode.period());
  }
  ASSERT_GE(frequencies.size(), 2u);
  EXPECT_GT(mass, 0.8);
  EXPECT_LE(mass, 1.0 + 1e-9);
  dougong::testing::expect_relative("B01", "through a scenario f1", 5.151685, frequencies[0], 2e-3);
  dougong::testing::expect_relative("B01", "through a scenario f2", 30.64264, frequencies[1], 2e-3);
}

TEST(ModesOfABuilding, OfWhatHangsInTheAirAreRefused) {
  EXPECT_THROW(modes_of(scenario_of({{"layout.name", "masonry-house"},
                                     {"on.name", "equipment"},
                                     {"on.floor_thickness", "0 m"},
                                     {"on.item_height", "2.7 m"},
                                     {"on.item_width", "1 m"}}),
                        3),
               ModelError);
}

}  // namespace
}  // namespace dougong::app
