// From where a relative path in a scenario file is meant.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/study/scenario.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

class ScenarioPaths : public testing::Test {
 protected:
  fs::path scenario_with(const std::string& file) const {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder = fs::path(testing::TempDir()) / "dougong-scenario-paths" / test->name();
    fs::create_directories(folder);
    std::ofstream(folder / "study.toml") << "[record]\nfile = \"" << file << "\"\n";
    return folder / "study.toml";
  }
};

TEST_F(ScenarioPaths, ARelativeRecordLiesBesideTheScenario) {
  const fs::path scenario = scenario_with("records/a.AT2");
  EXPECT_EQ(load_scenario(scenario).record.file, (scenario.parent_path() / "records/a.AT2").string());
}

TEST_F(ScenarioPaths, AnAbsoluteRecordStaysWhereItIs) {
  EXPECT_EQ(load_scenario(scenario_with("/somewhere/a.AT2")).record.file, "/somewhere/a.AT2");
}

TEST_F(ScenarioPaths, ARecordOfTheCommandLineIsMeantFromTheWorkingFolder) {
  const Override typed{"record.file", "b.AT2", "--record"};
  EXPECT_EQ(load_scenario(scenario_with("a.AT2"), {typed}).record.file, "b.AT2");
}

TEST_F(ScenarioPaths, TheFolderItselfIsNoScenario) {
  EXPECT_THROW(load_scenario(fs::path(testing::TempDir())), ScenarioError);
}

}  // namespace
}  // namespace dougong::app
