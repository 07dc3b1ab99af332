#include "app/study/scenario.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "app/study/scenario_keys.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr double g = 9.80665;

std::vector<std::string> errors(const std::string& text, const std::vector<Override>& overrides = {},
                                RecordRule rule = RecordRule::optional) {
  try {
    read_scenario(text, "study.toml", overrides, rule);
  } catch (const ScenarioError& error) {
    std::vector<std::string> lines;
    for (const LocatedMessage& message : error.messages()) lines.push_back(message.text());
    return lines;
  }
  return {};
}

Scenario read(const std::string& text, const std::vector<Override>& overrides = {}) {
  return read_scenario(text, "study.toml", overrides, RecordRule::optional);
}

std::vector<Override> set(std::initializer_list<const char*> changes) {
  std::vector<Override> overrides;
  for (const char* change : changes) overrides.push_back(parse_override(change));
  return overrides;
}

const char* const complete = R"(
[layout]
name = "brick-wall"
courses = 6
bricks_per_course = 9
levels = 3
brick_length = "0.4 m"
head_joint = "2 mm"
friction = 0.7

[record]
file = "records/a.EW"
component = "EW"
vertical = true
pga = "0.4 g"

[conditioning]
high_pass = "0.05 Hz"
low_pass = "none"
taper = "10 %"
baseline = "velocity-parabola"
filter_order = 2

[solve]
integrator = "rk4"
step = "0.05 ms"
duration = "30 s"
settle = false

[loss]
turn = "60 deg"

[verdict]
energy_error = 0.02

[output]
rate = "200 Hz"
directory = "out/a"
)";

TEST(Scenario, IsReadWithUnitsToSi) {
  const Scenario s = read(complete);
  EXPECT_EQ(s.layout.name, "brick-wall");
  EXPECT_EQ(s.layout.parameters.at("courses"), 6.0);
  EXPECT_EQ(s.layout.parameters.at("brick_length"), 0.4);
  EXPECT_EQ(s.layout.parameters.at("head_joint"), 0.002);
  EXPECT_EQ(s.record.file, "records/a.EW");
  EXPECT_EQ(s.record.component, "EW");
  EXPECT_TRUE(s.record.vertical);
  EXPECT_DOUBLE_EQ(s.record.pga.value(), 0.4 * g);
  EXPECT_EQ(s.conditioning.high_pass, 0.05);
  EXPECT_EQ(s.conditioning.low_pass, std::nullopt);
  EXPECT_EQ(s.conditioning.taper, 0.1);
  EXPECT_EQ(s.conditioning.filter_order, 2.0);
  EXPECT_EQ(s.solve.integrator, "rk4");
  EXPECT_EQ(s.solve.step, 0.05e-3);
  EXPECT_EQ(s.solve.duration, 30.0);
  EXPECT_FALSE(s.solve.settle);
  EXPECT_DOUBLE_EQ(s.loss.turn, std::numbers::pi / 3.0);
  EXPECT_EQ(s.verdict.energy_error, 0.02);
  EXPECT_EQ(s.output.rate, 200.0);
  EXPECT_EQ(s.output.directory, "out/a");
}

TEST(Scenario, CompletesTheLayoutsParameters) {
  const Scenario s = read("[layout]\nname = \"column\"\ndrums = 3\n");
  EXPECT_EQ(s.layout.parameters.size(), structures::find_layout("column").parameters.size());
  EXPECT_EQ(s.layout.parameters.at("drums"), 3.0);
  EXPECT_EQ(s.layout.parameters.at("width"), 1.0);
}

TEST(Scenario, IsTheDefaultsWhenNothingIsSaid) {
  const Scenario s = read("");
  EXPECT_EQ(s.layout.name, "four-storey");
  EXPECT_EQ(s.output.rate, 100.0);
  EXPECT_TRUE(s.solve.settle);
  EXPECT_EQ(s.record.pga, std::nullopt);
}

TEST(Scenario, IsUnchangedByWritingAndReading) {
  for (const char* text : {complete, ""}) {
    const std::string written = to_toml(read(text));
    const Scenario again = read(written);
    EXPECT_EQ(to_toml(again), written);
    EXPECT_EQ(again.layout, read(text).layout);
    for (const ScenarioKey& key : scenario_keys())
      EXPECT_EQ(toml_value(key, again), toml_value(key, read(text))) << key.name;
  }
}

TEST(Scenario, IsWrittenCompletely) {
  const std::string written = to_toml(Scenario{});
  for (const ScenarioKey& key : scenario_keys())
    EXPECT_THAT(written, HasSubstr(fmt::format("\n{} = ", key.leaf()))) << key.name;
  EXPECT_THAT(written, HasSubstr("\nleft_column_width = \"0.3 m\"\n"));
  EXPECT_THAT(written, HasSubstr("\npga = \"none\"\n"));
}

TEST(Scenario, MayBeWrittenWithTheMeanings) {
  const std::string written = to_toml(Scenario{}, Comments::meanings);
  EXPECT_THAT(written,
              HasSubstr("rate = \"100 Hz\"  # output times a second: of the histories, peaks and verdict\n"));
  EXPECT_EQ(to_toml(read(written)), to_toml(Scenario{}));
}

TEST(Scenario, KeepsAnyTextThroughWriting) {
  Scenario s;
  s.record.file = "a \"b\"\\c\t\x01 \xc3\xa9";
  EXPECT_EQ(read(to_toml(s)).record.file, s.record.file);
}

TEST(ScenarioErrors, NameTheNearestKeyAndThePlace) {
  EXPECT_THAT(errors("[record]\npgaa = \"0.4 g\"\n"),
              ElementsAre("study.toml:2:1: unknown key \"record.pgaa\"; did you mean \"record.pga\"?"));
  EXPECT_THAT(errors("[recrod]\n\n  pga = \"0.4 g\"\n"),
              ElementsAre("study.toml:3:3: unknown key \"recrod.pga\"; did you mean \"record.pga\"?"));
  EXPECT_THAT(errors("[layout]\nstorey = 4\n"),
              ElementsAre("study.toml:2:1: unknown key \"layout.storey\"; did you mean \"layout.storeys\"?"));
}

TEST(ScenarioErrors, ListTheParametersWhenNoneIsNear) {
  EXPECT_THAT(errors("[layout]\nname = \"column\"\nbasement = 4\n"),
              ElementsAre(HasSubstr("unknown key \"layout.basement\"; layout column has drums, width")));
}

TEST(ScenarioLayouts, TakeTextAndWriteItBack) {
  const Scenario s = read("[layout]\nname = \"pattern-wall\"\npattern = \"11, h1h\"\n");
  EXPECT_EQ(s.layout.parameters.at("pattern"), "11, h1h");
  EXPECT_EQ(read(to_toml(s)).layout, s.layout);
  EXPECT_THAT(errors("[layout]\nname = \"pattern-wall\"\npattern = 11\n"),
              ElementsAre(HasSubstr("study.toml:3:11: layout.pattern: expected text, in quotes")));
  EXPECT_THAT(
      errors("[layout]\nname = \"pattern-wall\"\npattern = \"11, 1\"\n"),
      ElementsAre(AllOf(StartsWith("study.toml:3:11: pattern: "), HasSubstr("found 1 blocks in course 2"))));
}

TEST(ScenarioErrors, RefuseABareNumberWhereAUnitIsNeeded) {
  EXPECT_THAT(errors("[record]\npga = 0.4\n"),
              ElementsAre(AllOf(StartsWith("study.toml:2:7: record.pga: "), HasSubstr("bare number 0.4"),
                                HasSubstr("g, m/s2"))));
  EXPECT_THAT(errors("[layout]\ncolumn_height = 3\n"), ElementsAre(HasSubstr("layout.column_height")));
  EXPECT_THAT(errors("[output]\nrate = 100\n"), ElementsAre(HasSubstr("Hz")));
}

TEST(ScenarioErrors, RefuseAUnitOfAnotherDimension) {
  EXPECT_THAT(errors("[solve]\nduration = \"3 m\"\n"), ElementsAre(HasSubstr("m is a unit of length")));
}

TEST(ScenarioErrors, RefuseValuesOfTheWrongKind) {
  EXPECT_THAT(errors("[solve]\nsettle = \"yes\"\n"),
              ElementsAre(HasSubstr("expected true or false, found \"yes\"")));
  EXPECT_THAT(errors("[record]\nfile = 3\n"), ElementsAre(HasSubstr("expected a text in quotes, found 3")));
  EXPECT_THAT(errors("[record]\npga = [1, 2]\n"), ElementsAre(HasSubstr("found a TOML array")));
  EXPECT_THAT(errors("[layout]\nstoreys = \"4\"\n"), ElementsAre(HasSubstr("without quotes")));
  EXPECT_THAT(errors("[layout]\nstoreys = 4.5\n"),
              ElementsAre(HasSubstr("expected a whole number, found 4.5")));
  EXPECT_THAT(errors("solve = 3\n"), ElementsAre(HasSubstr("unknown key \"solve\"")));
}

TEST(ScenarioErrors, RefuseChoicesThatDoNotExist) {
  EXPECT_THAT(errors("[solve]\nintegrator = \"rk5\"\n"),
              ElementsAre(AllOf(HasSubstr("velocity-verlet"), HasSubstr("did you mean \"rk4\"?"))));
}

TEST(ScenarioErrors, RefuseValuesOutOfRange) {
  EXPECT_THAT(errors("[conditioning]\ntaper = 0.7\n"),
              ElementsAre("study.toml:2:9: conditioning.taper: expected a value from 0 to 0.5, found 0.7"));
  EXPECT_THAT(errors("[layout]\nstoreys = 0\n"),
              ElementsAre("study.toml:2:11: storeys: expected a whole number from 1 to 100, found 0"));
  EXPECT_THAT(errors("[verdict]\nlean = -1\n"), ElementsAre(HasSubstr("of at least 0")));
}

TEST(ScenarioErrors, FindParametersThatDoNotFitEachOther) {
  EXPECT_THAT(
      errors("[layout]\nslab_length = \"8 m\"\n"),
      ElementsAre("study.toml:2:15: slab_length: expected at least the column spacing, 10 m, found 8 m"));
}

TEST(ScenarioErrors, NameTheNearestLayout) {
  EXPECT_THAT(
      errors("[layout]\nname = \"brick-wal\"\ncourses = 6\n"),
      ElementsAre(AllOf(StartsWith("study.toml:2:8: layout: "), HasSubstr("did you mean \"brick-wall\"?"))));
}

TEST(ScenarioErrors, AreAllCollectedInTheOrderOfTheFile) {
  EXPECT_THAT(errors("[solve]\nduration = \"x\"\n[record]\npga = 0.4\nfiel = \"a\"\n", set({"rate=3"})),
              ElementsAre(StartsWith("study.toml:2:"), StartsWith("study.toml:4:"),
                          StartsWith("study.toml:5:"), StartsWith("--set rate=3: ")));
}

TEST(ScenarioErrors, LocateABrokenFile) {
  EXPECT_THAT(errors("[layout]\nname = \n"), ElementsAre(StartsWith("study.toml:2:")));
}

TEST(ScenarioErrors, AskForARecord) {
  EXPECT_THAT(errors("", {}, RecordRule::required), ElementsAre(StartsWith("study.toml: no record")));
  EXPECT_THAT(errors("[record]\nname = \"x\"\n", {}, RecordRule::required), SizeIs(0));
  EXPECT_THROW(scenario_from({}), ScenarioError);
}

TEST(ScenarioErrors, RefuseTwoThatExcludeEachOther) {
  EXPECT_THAT(errors("[record]\nfile = \"a\"\nname = \"b\"\n"), ElementsAre(HasSubstr("exclude each other")));
  EXPECT_THAT(errors("[record]\npga = \"1 g\"\nscale = 2\n"), ElementsAre(HasSubstr("exclude each other")));
}

TEST(ScenarioErrors, RefuseACornerOfAFilterThatIsSwitchedOff) {
  const std::string off = "[record]\nname = \"kobe\"\n[conditioning]\nfilter = false\n";
  EXPECT_THAT(errors(off + "low_pass = \"20 Hz\"\n"),
              ElementsAre(HasSubstr("conditioning.low_pass: of the filter, which is switched off")));
  EXPECT_THAT(errors(off + "filter_order = 6\n"), ElementsAre(HasSubstr("conditioning.filter_order")));
  EXPECT_THAT(errors(off + "high_pass = \"0.1 Hz\"\nlow_pass = \"none\"\n"), IsEmpty());
}

TEST(ScenarioErrors, NameAFileThatIsNotThere) {
  EXPECT_THROW(load_scenario("no/such/study.toml"), ScenarioError);
}

TEST(Overrides, WinOverTheFile) {
  const Scenario s = read(complete, set({"record.pga=0.6 g", "solve.settle=true", "layout.courses=9"}));
  EXPECT_DOUBLE_EQ(s.record.pga.value(), 0.6 * g);
  EXPECT_TRUE(s.solve.settle);
  EXPECT_EQ(s.layout.parameters.at("courses"), 9.0);
}

TEST(Overrides, TakeTheLastWord) {
  const Scenario s =
      read("", set({"pga=0.5 g", "storeys=6", "left-column-width=0.4 m", "layout=four-storey-strong"}));
  EXPECT_DOUBLE_EQ(s.record.pga.value(), 0.5 * g);
  EXPECT_EQ(s.layout.name, "four-storey-strong");
  EXPECT_EQ(s.layout.parameters.at("storeys"), 6.0);
  EXPECT_EQ(s.layout.parameters.at("left_column_width"), 0.4);
}

TEST(Overrides, TakeValuesAsTomlOrAsTyped) {
  for (const char* change : {"pga=0.5 g", "pga=\"0.5 g\"", "pga = '0.5 g'"})
    EXPECT_DOUBLE_EQ(read("", set({change})).record.pga.value(), 0.5 * g) << change;
  EXPECT_EQ(read("", set({"taper=10 %"})).conditioning.taper, 0.1);
  EXPECT_EQ(read("", set({"taper=0.1"})).conditioning.taper, 0.1);
  EXPECT_EQ(read("", set({"record.name=2008-05-12"})).record.name, "2008-05-12");
  EXPECT_EQ(read("", set({"record.file=a=b.txt"})).record.file, "a=b.txt");
  EXPECT_EQ(read(complete, set({"pga=none"})).record.pga, std::nullopt);
}

TEST(Overrides, DropWhatTheyExclude) {
  const Scenario s = read(complete, set({"record.name=syn1", "scale=2"}));
  EXPECT_EQ(s.record.file, "");
  EXPECT_EQ(s.record.name, "syn1");
  EXPECT_EQ(s.record.pga, std::nullopt);
  EXPECT_EQ(s.record.scale, 2.0);
}

TEST(Overrides, SayWhatIsAmbiguous) {
  EXPECT_THAT(errors("", set({"name=x"})), ElementsAre("--set name=x: \"name\" may be layout.name or on.name "
                                                       "or beside.name or record.name; write it in full"));
  EXPECT_THAT(errors("", set({"interval=1 s"})),
              ElementsAre(HasSubstr("record.interval or conditioning.interval")));
}

TEST(Overrides, NameTheNearestKey) {
  EXPECT_THAT(errors("", set({"stories=6"})), ElementsAre(HasSubstr("did you mean \"layout.storeys\"?")));
  EXPECT_THAT(errors("", set({"record.fiel=6"})), ElementsAre(HasSubstr("did you mean \"record.file\"?")));
}

TEST(Overrides, AreCalledWhatTheUserTyped) {
  const Override flag{"pga", "0.4", "--pga"};
  EXPECT_THAT(errors("", {flag}), ElementsAre(StartsWith("--pga 0.4: record.pga: ")));
}

TEST(Overrides, NeedAnEqualsSign) {
  EXPECT_THROW(parse_override("storeys"), ScenarioError);
  EXPECT_THROW(parse_override("=6"), ScenarioError);
}

TEST(Overrides, OfOneLayoutDoNotSuitAnother) {
  EXPECT_THAT(errors("[layout]\nstoreys = 4\n", set({"layout=brick-wall"})),
              ElementsAre(HasSubstr("unknown key \"layout.storeys\"")));
}

TEST(ScenarioKeys, AreUniqueAndInSections) {
  std::set<std::string> names;
  for (const ScenarioKey& key : scenario_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_EQ(std::ranges::count(key.name, '.'), 1) << key.name;
    EXPECT_FALSE(key.meaning.empty()) << key.name;
  }
}

TEST(ScenarioKeys, HaveDefaultsThatAreAllowed) {
  EXPECT_NO_THROW(read(to_toml(Scenario{})));
}

TEST(ScenarioKeys, OfLayoutsDoNotHideOthers) {
  for (const auto& layout : structures::layouts())
    for (const auto& parameter : layout.parameters)
      for (const ScenarioKey& key : scenario_keys()) EXPECT_NE(key.leaf(), parameter.name) << layout.name;
}

/// The table rows of a document, in order.
std::vector<std::string> rows_of(const std::string& document) {
  const auto path = std::filesystem::path(__FILE__).parent_path() / "../../../docs" / document;
  std::ifstream file(path);
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("| `")) rows.push_back(line);
  return rows;
}

TEST(ScenarioDocument, ListsExactlyTheKeysThereAre) {
  std::vector<std::string> expected;
  for (const ScenarioKey& key : scenario_keys())
    expected.push_back(
        fmt::format("| `{}` | {} | `{}` | {} |", key.name, kind_of(key), default_of(key), key.meaning));
  EXPECT_EQ(rows_of("scenario.md"), expected);
}

}  // namespace
}  // namespace dougong::app
