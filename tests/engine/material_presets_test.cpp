#include "engine/material_presets.h"

#include <gtest/gtest.h>

#include <set>

namespace dougong::engine {
namespace {

TEST(MaterialPresets, AreSoundAndSayWhereTheyComeFrom) {
  std::set<std::string> names;
  for (const MaterialPreset& preset : material_presets()) {
    const Material& m = preset.material;
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_FALSE(preset.source.empty()) << m.name;
    EXPECT_GT(m.density, 100.0) << m.name;
    EXPECT_GT(m.young_modulus, 1e6) << m.name;
    EXPECT_GE(m.poisson_ratio, 0.0) << m.name;
    EXPECT_LT(m.poisson_ratio, 0.5) << m.name;
    EXPECT_GT(m.friction_coefficient, 0.0) << m.name;
  }
  for (const char* name : {"concrete", "brick", "stone", "timber", "steel", "rubber", "glass", "ptfe"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(MaterialPresets, BeginWithTheDefaultMaterial) {
  EXPECT_EQ(material_presets().front().material.name, Material{}.name);
  EXPECT_EQ(find_material_preset("concrete")->material.density, Material{}.density);
  EXPECT_EQ(find_material_preset("mithril"), nullptr);
}

TEST(MaterialPresets, BounceAsTheirRestitutionSays) {
  EXPECT_NEAR(restitution_for_damping_ratio(find_material_preset("steel")->material.damping_ratio), 0.6,
              1e-6);
}

}  // namespace
}  // namespace dougong::engine
