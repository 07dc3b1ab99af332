#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/architecture/includes.h"

namespace dougong::architecture {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Sources project_sources() {
  namespace fs = std::filesystem;
  const fs::path root = DOUGONG_SOURCE_DIR;
  Sources sources;
  for (const char* folder : {"app", "engine", "seismic", "structures", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      sources[entry.path().lexically_relative(root).generic_string()] = text.str();
    }
  }
  return sources;
}

const Sources& project() {
  static const Sources sources = project_sources();
  return sources;
}

// The project as it is.

TEST(Project, IncludesFollowTheHouse) {
  EXPECT_THAT(wrong_directions(project()), IsEmpty());
}

TEST(Project, IncludesStartAtTheRoot) {
  EXPECT_THAT(includes_not_from_the_root(project()), IsEmpty());
}

TEST(Project, HasNoIncludeCycle) {
  EXPECT_THAT(include_cycles(project()), IsEmpty());
}

TEST(Project, HeadersAreIncludedOnce) {
  EXPECT_THAT(headers_without_pragma_once(project()), IsEmpty());
}

TEST(Project, SourcesIncludeTheirOwnHeaderFirst) {
  EXPECT_THAT(sources_without_own_header_first(project()), IsEmpty());
}

TEST(Project, WasFound) {
  EXPECT_GT(project().size(), 100u);
  EXPECT_TRUE(project().contains("engine/model.h"));
}

// The check sees what it is there to see.

std::vector<std::string> directions_of(const std::string& path, const std::string& included) {
  return wrong_directions({{path, "#pragma once\n#include \"" + included + "\"\n"}});
}

TEST(IncludeCheck, SeesEveryForbiddenDirection) {
  const std::pair<const char*, const char*> forbidden[] = {
      {"engine/model.h", "seismic/record.h"},        {"engine/model.h", "structures/building.h"},
      {"engine/model.cpp", "app/study/scenario.h"},  {"seismic/record.h", "engine/model.h"},
      {"seismic/record.h", "structures/building.h"}, {"structures/verdict.h", "seismic/record.h"},
      {"structures/loss.cpp", "app/study/run.h"},    {"app/study/run.h", "app/report/report.h"},
      {"app/report/page.h", "app/cli/terminal.h"},   {"app/study/run.cpp", "app/cli/terminal.h"},
      {"engine/model.cpp", "tests/scenes/blocks.h"}, {"app/cli/program.cpp", "tests/scenes/blocks.h"},
      {"engine/model.cpp", "../seismic/record.h"},
  };
  for (const auto& [path, included] : forbidden)
    EXPECT_THAT(directions_of(path, included), ElementsAre(HasSubstr(included))) << path;
}

TEST(IncludeCheck, LetsTheAllowedDirectionsPass) {
  const std::pair<const char*, const char*> allowed[] = {
      {"engine/drive.cpp", "engine/integrators/table.h"},
      {"seismic/motions/ground_motion.h", "engine/motion.h"},
      {"seismic/record.h", "engine/vec2.h"},
      {"structures/building.h", "engine/scene.h"},
      {"app/study/prepare.h", "structures/building.h"},
      {"app/report/page.h", "app/study/run_result.h"},
      {"app/cli/program.cpp", "app/report/gnuplot.h"},
      {"app/report/page.cpp", "report_css.h"},
      {"tests/engine/drive_test.cpp", "engine/drive.h"},
  };
  for (const auto& [path, included] : allowed) EXPECT_THAT(directions_of(path, included), IsEmpty()) << path;
}

TEST(IncludeCheck, SeesAFileOutsideTheHouse) {
  EXPECT_THAT(wrong_directions({{"tools/script.cpp", ""}}), ElementsAre(HasSubstr("tools/script.cpp")));
  EXPECT_THAT(wrong_directions({{"app/web/server.cpp", ""}}), ElementsAre(HasSubstr("app/web/server.cpp")));
}

TEST(IncludeCheck, ReadsIncludesAsTheCompilerDoes) {
  EXPECT_THAT(includes_of("#include \"a.h\"\n  # include\t\"b/c.h\"  // why\n#include <d.h>\n"),
              ElementsAre("a.h", "b/c.h"));
  EXPECT_THAT(
      includes_of("// #include \"a.h\"\n/* #include \"b.h\"\n#include \"c.h\"\n*/ #include \"d.h\"\n"),
      ElementsAre("d.h"));
  EXPECT_THAT(includes_of("int n;\r\n#include \"a.h\"\r\n"), ElementsAre("a.h"));
  EXPECT_THAT(includes_of("#include \"unfinished\n/* open"), IsEmpty());
}

TEST(IncludeCheck, SeesCyclesOfAnyLength) {
  EXPECT_THAT(include_cycles({{"a.h", "#include \"a.h\"\n"}}), ElementsAre("a.h -> a.h"));
  EXPECT_THAT(include_cycles({{"a.h", "#include \"b.h\"\n"},
                              {"b.h", "#include \"c.h\"\n"},
                              {"c.h", "#include \"b.h\"\n#include <vector>\n"}}),
              ElementsAre("b.h -> c.h -> b.h"));
}

TEST(IncludeCheck, TakesADiamondForNoCycle) {
  EXPECT_THAT(include_cycles({{"a.h", "#include \"b.h\"\n#include \"c.h\"\n"},
                              {"b.h", "#include \"d.h\"\n"},
                              {"c.h", "#include \"d.h\"\n"},
                              {"d.h", ""}}),
              IsEmpty());
}

TEST(IncludeCheck, SeesAMissingPragmaOnce) {
  EXPECT_THAT(headers_without_pragma_once({{"a.h", "// #pragma once\nint a;\n"}}), ElementsAre("a.h"));
  EXPECT_THAT(headers_without_pragma_once({{"a.h", "// What it is.\n#pragma once\n"}, {"b.cpp", ""}}),
              IsEmpty());
}

TEST(IncludeCheck, SeesAnOwnHeaderThatIsNotFirst) {
  const auto check = [](const std::string& source) {
    return sources_without_own_header_first({{"engine/a.h", ""}, {"engine/a.cpp", source}});
  };
  EXPECT_THAT(check("#include <cmath>\n\n#include \"engine/a.h\"\n"), ElementsAre(HasSubstr("engine/a.h")));
  EXPECT_THAT(check("#include \"engine/b.h\"\n#include \"engine/a.h\"\n"),
              ElementsAre(HasSubstr("engine/a.h")));
  EXPECT_THAT(check("int a;\n"), ElementsAre(HasSubstr("engine/a.h")));
  EXPECT_THAT(check("// What it does.\n#include \"engine/a.h\"\n\n#include <cmath>\n"), IsEmpty());
}

TEST(IncludeCheck, SeesAPathThatDoesNotStartAtTheRoot) {
  const auto check = [](const std::string& included) {
    return includes_not_from_the_root(
        {{"engine/a.h", "#include \"" + included + "\"\n"}, {"engine/b.h", ""}, {"engine/contact/c.h", ""}});
  };
  EXPECT_THAT(check("engine/b.h"), IsEmpty());
  EXPECT_THAT(check("generated.h"), IsEmpty());
  EXPECT_THAT(check("b.h"), ElementsAre(HasSubstr("b.h")));
  EXPECT_THAT(check("contact/c.h"), ElementsAre(HasSubstr("contact/c.h")));
  EXPECT_THAT(check("engine/gone.h"), ElementsAre(HasSubstr("engine/gone.h")));
}

}  // namespace
}  // namespace dougong::architecture
