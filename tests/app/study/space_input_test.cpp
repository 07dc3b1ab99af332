#include "app/study/space_input.h"

#include <gmock/gmock.h>

#include <sstream>

#include "app/study/scene_build.h"
#include "seismic/input_error.h"

namespace dougong::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

SpaceInput read(const std::string& text, const SpaceRules& rules = {}) {
  std::istringstream in(text);
  SpaceWords words(in, "in.space", nullptr);
  return read_space(words, rules);
}

std::string error(const std::string& text, const SpaceRules& rules = {}) {
  try {
    read(text, rules);
  } catch (const seismic::InputError& wrong) {
    return wrong.what();
  }
  return "nothing wrong";
}

const std::string ball = "cir 0  1 2  3  50  4 5  0.5\n";

TEST(SpaceInput, ReadsACircle) {
  const SceneDescription d = read(ball + "finish\n10\n").description;
  ASSERT_THAT(d.bodies, SizeIs(1));
  const engine::Body body = build_scene(d).scene.bodies[0];
  EXPECT_EQ(body.velocity, (engine::Vec2{1, 2}));
  EXPECT_EQ(body.spin, 3.0);
  EXPECT_EQ(body.mass, 50.0);
  EXPECT_EQ(body.position, (engine::Vec2{4, 5}));
  EXPECT_EQ(std::get<engine::Circle>(body.shape).radius, 0.5);
}

TEST(SpaceInput, ReadsEveryMessage) {
  const SpaceInput input = read(
      "tri 1e-6 0 0 0 10  0 0 3 0 0 3\n"
      "rect 0 0 0 0 10  2 1  5 6  0.5\n"
      "tercir 0 -5 1\n"
      "tertri -9 0 -8 0 -9 1\n"
      "terrect 18 1 0 -0.5 0.1\n"
      "plane 0 0 1 0\n"
      "save scene.toml\n"
      "finish 25\n");
  const engine::Scene scene = build_scene(input.description).scene;
  ASSERT_THAT(scene.bodies, SizeIs(2));
  ASSERT_THAT(scene.terrains, SizeIs(4));
  EXPECT_EQ(scene.bodies[0].position, (engine::Vec2{1, 1}));
  EXPECT_EQ(scene.bodies[0].charge, 1e-6);
  EXPECT_EQ(scene.bodies[1].angle, 0.5);
  EXPECT_DOUBLE_EQ(engine::area_properties(scene.bodies[1].shape).area, 2.0);
  EXPECT_EQ(scene.terrains[2].angle, 0.1);
  EXPECT_TRUE(std::holds_alternative<engine::HalfPlane>(scene.terrains[3].shape));
  EXPECT_EQ(input.save_paths, std::vector<std::string>{"scene.toml"});
  EXPECT_EQ(input.divisor, 25.0);
}

TEST(SpaceInput, DoesNotCareHowValuesAreSpreadOverLines) {
  const auto a = read(ball + "finish 10").description,
             b = read("\n# a ball\ncir\n0\n1\n2 3 # spin\n\n50\r\n4 5\n0.5 finish\n10").description;
  EXPECT_EQ(a.bodies[0].shape.position, b.bodies[0].shape.position);
  EXPECT_EQ(a.bodies[0].shape.radius, b.bodies[0].shape.radius);
  EXPECT_EQ(a.bodies[0].velocity, b.bodies[0].velocity);
}

TEST(SpaceInput, MakesThePlaneSolidBelowItsLineWhicheverPointComesFirst) {
  for (const char* points : {"0 1 2 3", "2 3 0 1"}) {
    const auto d = read(ball + "plane " + points + " finish 10").description;
    const engine::Terrain ground = build_scene(d).scene.terrains[0];
    const engine::Vec2 up = engine::rotated({0, 1}, ground.angle);
    EXPECT_GT(up.y, 0.0);
    EXPECT_NEAR(engine::dot(engine::Vec2{2, 3} - ground.position, up), 0.0, 1e-15);
    EXPECT_NEAR(engine::dot(engine::Vec2{0, 1} - ground.position, up), 0.0, 1e-15);
  }
}

TEST(SpaceInput, LetsStarsAttractEachOtherWithoutUniformGravity) {
  const auto d = read("star 0 0 1e12 0 0 star 10 0 1 0 3 finish 10").description;
  EXPECT_FALSE(d.head.gravity);
  EXPECT_EQ(d.fields.gravitational_constant, 6.67430e-11);
  EXPECT_EQ(d.bodies[1].velocity, (engine::Vec2{0, 3}));
  EXPECT_LT(*d.bodies[0].shape.radius, 0.1);
}

TEST(SpaceInput, IsOfConcreteWithAFrictionOfAHalfUnlessSaidOtherwise) {
  const auto usual = build_scene(read(ball + "finish 10").description).scene.materials[0];
  EXPECT_EQ(usual.young_modulus, 30e9);
  EXPECT_EQ(usual.friction_coefficient, 0.5);
  const auto steel =
      build_scene(read(ball + "finish 10", {false, "steel", {}}).description).scene.materials[0];
  EXPECT_EQ(steel.young_modulus, 210e9);
  EXPECT_THROW(read(ball, {false, "mithril", {}}), ScenarioError);
}

TEST(SpaceInput, TakesARecordAfterFinish) {
  const auto d = read(ball + "plane 0 0 1 0 tercir 0 0 1 finish kobe 10", {true, "", {}}).description;
  EXPECT_EQ(d.terrains[0].motion->source, "kobe");
  EXPECT_EQ(d.terrains[1].motion->source, "kobe");
}

struct Wrong {
  std::string text, message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.text;
}
class SpaceMistakes : public testing::TestWithParam<Wrong> {};
TEST_P(SpaceMistakes, AreNamedWithTheirLine) {
  EXPECT_THAT(error(GetParam().text), HasSubstr(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, SpaceMistakes,
    testing::Values(
        Wrong{"", "in.space: expected message, found the end of the input"},
        Wrong{"circ 0\n", "in.space:1: expected a message (cir, tri"},
        Wrong{"circ 0\n", "did you mean \"cir\"?"},
        Wrong{"\n\ncir 0 x", "in.space:3: expected velocity x (m/s) of cir as a number, found \"x\""},
        Wrong{"cir 0 1 2", "expected spin (rad/s) of cir, found the end of the input"},
        Wrong{"cir 0 1 2 3 50 4 5 -1", "radius (m) of cir above zero, found -1"},
        Wrong{"cir 0 1 2 3 0", "mass (kg) of cir above zero"}, Wrong{"cir nan", "found \"nan\""},
        Wrong{"cir inf", "found \"inf\""}, Wrong{"cir 1e999", "found \"1e999\""},
        Wrong{"cir \"0.3 m\"", "as a number"},
        Wrong{"tertri 0 0 1 1 2 2 ", "three corners of tertri that are not on one line"},
        Wrong{"plane 1 1 1 1", "two different points"},
        Wrong{"terrect 1 -1", "width (m) of terrect above zero"},
        Wrong{"finish", "at least one body before finish"},
        Wrong{"cir 0 0 0 0 1 0 0 1 finish", "expected n: the step is 0.01 s / n"},
        Wrong{"cir 0 0 0 0 1 0 0 1 finish 0", "above zero, found 0"},
        Wrong{"cir 0 0 0 0 1 0 0 1 finish -10", "above zero"},
        Wrong{"cir 0 0 0 0 1 0 0 1 finish\n10\ncir", "in.space:3: expected nothing after n, found \"cir\""},
        Wrong{"cir 0 0 0 0 1 0 0 1 save", "expected file of save, found the end"}));

TEST(SpaceInput, ThatEndsTooSoonSaysWhatWasExpected) {
  EXPECT_THAT(error("cir 0 1 2 3\n"),
              AllOf(HasSubstr("mass (kg) of cir"), HasSubstr("the end of the input")));
}

TEST(SpaceInput, NeedsTerrainForARecord) {
  EXPECT_THAT(error(ball + "finish kobe 10", {true, "", {}}), HasSubstr("terrain that the record can shake"));
}

// --- the keyboard ------------------------------------------------------------------------------------------

struct Talk {
  SpaceInput input;
  std::string said;
};
Talk talk(const std::string& typed, const SpaceRules& rules = {}) {
  std::istringstream in(typed);
  std::ostringstream out;
  SpaceWords words(in, "keyboard", &out);
  SpaceInput input = read_space(words, rules);
  return {std::move(input), out.str()};
}

TEST(SpaceKeyboard, ExplainsWhatIsAskedFor) {
  const Talk t = talk("cir\n0\n1 2\n3\n50\n4 5\n0.5\nfinish\n10\n");
  EXPECT_THAT(t.said, AllOf(HasSubstr("message: "), HasSubstr("charge (C) of cir: "),
                            HasSubstr("velocity x (m/s) of cir: "), HasSubstr("radius (m) of cir: "),
                            HasSubstr("n: the step is 0.01 s / n, usually 10: ")));
}

TEST(SpaceKeyboard, AsksForAWrongValueAgainWithTheReason) {
  const Talk t = talk("crc\ncir 0 1 2 3 heavy\n-50\n50\n4 5 -1\n0.5\nfinish ten\n10\n");
  EXPECT_EQ(t.input.description.bodies[0].mass, 50.0);
  EXPECT_EQ(t.input.description.bodies[0].shape.radius, 0.5);
  EXPECT_THAT(t.said, AllOf(HasSubstr("did you mean \"cir\"?"), HasSubstr("as a number, found \"heavy\""),
                            HasSubstr("mass (kg) of cir above zero, found -50"), HasSubstr("found \"ten\"")));
}

TEST(SpaceKeyboard, AsksForCollinearCornersAgain) {
  const Talk t = talk("tri 0 0 0 0 1  0 0 1 1 2 2\n0 0 1 0 0 1\nfinish 10\n");
  EXPECT_THAT(t.input.description.bodies[0].shape.corners, SizeIs(3));
  EXPECT_THAT(t.said, HasSubstr("not on one line"));
}

TEST(SpaceKeyboard, AsksForARecordThatIsNotThereAgain) {
  const SpaceRules rules{true, "", [](const MotionChoice& choice) {
                           if (choice.source != "wenchuan")
                             throw seismic::InputError("record", 0, "a shipped record: wenchuan",
                                                       choice.source);
                         }};
  const Talk t = talk(ball + "plane 0 0 1 0 finish\nkobe\nwenchuan\n10\n", rules);
  EXPECT_EQ(t.input.description.terrains[0].motion->source, "wenchuan");
  EXPECT_THAT(t.said, HasSubstr("expected a shipped record: wenchuan, found kobe"));
  EXPECT_THAT(error(ball + "plane 0 0 1 0 finish kobe", rules), HasSubstr("a shipped record"));
}

}  // namespace
}  // namespace dougong::app
