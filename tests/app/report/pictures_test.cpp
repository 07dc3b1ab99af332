// The drawn buildings: sizes, and that blocks are where they should be in the colour they should have.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "app/report/camera.h"
#include "app/report/film.h"
#include "app/report/film_instruments.h"
#include "app/report/image.h"
#include "app/report/lettering.h"
#include "app/report/model_svg.h"
#include "app/report/raster.h"
#include "app/report/scene.h"
#include "fixtures.h"

namespace dougong::app {
namespace {

using engine::Vec2;

Colour colour_at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
}

testing::Matcher<Colour> near(Colour c) {
  return testing::AllOf(testing::Field(&Colour::red, testing::DoubleNear(c.red, 0.02)),
                        testing::Field(&Colour::green, testing::DoubleNear(c.green, 0.02)),
                        testing::Field(&Colour::blue, testing::DoubleNear(c.blue, 0.02)));
}

bool same(Colour a, Colour b) {
  return std::abs(a.red - b.red) < 0.02 && std::abs(a.green - b.green) < 0.02 &&
         std::abs(a.blue - b.blue) < 0.02;
}

std::size_t count_of(const Image& image, Colour colour) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += same(colour_at(image, x, y), colour) ? 1 : 0;
  }
  return count;
}

TEST(Raster, FillsWhereThePolygonIsAndSmoothsItsEdge) {
  Drawing drawing;
  drawing.polygon({{10, 10}, {30.5, 10}, {30.5, 20}, {10, 20}}, ink::black);
  const Image image = drawing.render(50, 40);
  EXPECT_THAT(colour_at(image, 15, 40 - 15), near(ink::black));  // y up
  EXPECT_THAT(colour_at(image, 15, 15), near(ink::white));
  EXPECT_NEAR(colour_at(image, 30, 25).red, 0.5, 0.07);  // half covered
}

TEST(Raster, OutlinesLieOnTheEdge) {
  Drawing drawing;
  drawing.outline({{10, 10}, {30, 10}, {30, 30}, {10, 30}}, 2.0, ink::black);
  const Image image = drawing.render(40, 40);
  EXPECT_THAT(colour_at(image, 9, 20), near(ink::black));
  EXPECT_THAT(colour_at(image, 10, 20), near(ink::black));
  EXPECT_THAT(colour_at(image, 20, 20), near(ink::white));
}

TEST(Picture, PngComesBack) {
  Image image(7, 5, ink::terrain);
  image.fill_rectangle(2, 1, 3, 2, ink::lost);
  const Image back = image_of(png_of(image));
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.rgb, image.rgb);
}

TEST(Lettering, DrawsInkWithinItsWidth) {
  const Lettering letters(20);
  Image image(200, 40);
  letters.draw(image, "Drift θ 汶", 10, 28, ink::black);
  EXPECT_GT(count_of(image, ink::black), 40u);
  EXPECT_LT(letters.width(letters.cut("a long line of text that cannot fit", 100)), 101);
  EXPECT_GT(letters.wrapped("first loss of support", 80).size(), 1u);
}

TEST(Scene, HasTheAskedSizeAndBlocksInTheirColour) {
  const RunResult run = fixtures::survived();
  const auto frames = frames_of(run);
  const SceneView view = view_of(run, frames);
  const Image start = draw_scene(run, frames.front(), view);
  EXPECT_EQ(start.width, 1440);
  const Colour still = mixed(viridis(1.0), ink::white, 0.22);
  EXPECT_GT(count_of(start, still), 20000u);                            // at rest: all of them
  EXPECT_LT(count_of(draw_scene(run, frames[3], view), still), 5000u);  // at the peak: the legend only
  EXPECT_GT(count_of(start, ink::terrain), 20000u);
}

TEST(Scene, TheCameraFramesTheDebrisAndIgnoresWhatFlewAway) {
  RunResult run = fixtures::collapsed();
  const Box before = run_bounds(run, {0}, 1.0), all = run_bounds(run, {0, 1500}, 1.0);
  EXPECT_LT(all.low.x, before.low.x);
  run.trajectory.poses[3 * 1500 * run.trajectory.blocks] = 1e9;
  run.trajectory.poses[3 * 1500 * run.trajectory.blocks + 3] = NAN;
  EXPECT_LT(run_bounds(run, {0, 1500}, 1.0).width(), 60.0);
  EXPECT_GT(draw_scene(run, 1500).width, 0);
}

TEST(Scene, SmallMotionIsMagnifiedAndLargeMotionIsNot) {
  const RunResult small = fixtures::survived(), large = fixtures::collapsed();
  EXPECT_GT(view_of(small, frames_of(small)).magnification, 1.0);
  EXPECT_EQ(view_of(large, frames_of(large)).magnification, 1.0);
}

TEST(Scene, PosesAreRelativeToTheMovingGround) {
  structures::Trajectory t;
  t.times = {0.0, 1.0};
  t.blocks = 1;
  t.poses = {1.0, 2.0, 0.0, 1.5, 2.0, 0.1};
  t.ground_displacement = {{0.0, 0.0}, {0.4, 0.0}};
  EXPECT_NEAR(moved(t, 1, 0), 0.1, 1e-12);
  const Pose pose = pose_at(t, 1, 0, 10.0);
  EXPECT_NEAR(pose.position.x, 2.0, 1e-12);
  EXPECT_NEAR(pose.angle, 1.0, 1e-12);
}

TEST(Scene, FramesAreSixToEightMomentsInOrder) {
  RunResult run = fixtures::collapsed();
  for (int i = 0; i < 20; ++i) run.moments.push_back({1.0 + i, "more"});
  const auto frames = frames_of(run);
  EXPECT_EQ(frames.size(), 8u);
  EXPECT_EQ(frames.front().step, 0u);
  EXPECT_EQ(frames.back().step + 1, run.trajectory.times.size());
  EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end(),
                             [](const Frame& a, const Frame& b) { return a.step < b.step; }));
  EXPECT_TRUE(frames_of({}).empty());
}

TEST(Film, HasFiftyFramesASecondAtTrueSpeedAndMoreWhenSlowed) {
  const RunResult run = fixtures::collapsed();  // 30 s
  EXPECT_EQ(film_frames(run, {}).size(), 1501u);
  EXPECT_EQ(film_frames(run, {.slow = 4.0}).size(), 6001u);
  EXPECT_NEAR(film_frames(run, {}).at(100).time, 2.0, 1e-9);
  EXPECT_NEAR(film_frames(run, {.slow = 4.0}).at(400).time, 2.0, 1e-9);
  EXPECT_TRUE(film_frames({}, {}).empty());
}

TEST(Film, SaysWhatHappensWhileItIsNews) {
  const RunResult run = fixtures::collapsed();
  const auto frames = film_frames(run, {});
  EXPECT_EQ(frames.at(480).caption, "first slip");  // 9.6 s
  EXPECT_EQ(frames.at(535).caption, "");            // 10.7 s
  EXPECT_EQ(film_frames(run, {.slow = 2.0}).at(960).caption, "first slip; 2 times slowed");
  EXPECT_EQ(film_frames(run, {.slow = 0.25}).at(120).caption, "first slip; 4 times faster");
}

/// Pixels of a colour below a line.
std::size_t count_of(const Image& image, Colour colour, int from) {
  const Image one(1, 1, colour);
  std::size_t count = 0;
  for (int y = from; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      count += std::equal(image.at(x, y), image.at(x, y) + 3, one.at(0, 0));
  return count;
}

TEST(Film, ACursorRunsAlongTheMotionAndBarsShowTheDrifts) {
  const RunResult run = fixtures::collapsed();
  const auto frames = film_frames(run, {.frames_a_second = 1.0});
  const SceneView view = film_view(run, frames);
  const Image start = film_image(run, frames.front(), view), end = film_image(run, frames.back(), view);
  EXPECT_EQ(start.width % 2 + start.height % 2, 0);
  EXPECT_EQ(start.width, 960);
  const int strip = start.height - motion_strip_height;
  const auto cursor = [&](const Image& image, int from, int to) {
    const Image one(1, 1, ink::lost);
    for (int x = from; x < to; ++x)
      if (std::equal(one.at(0, 0), one.at(0, 0) + 3, image.at(x, strip + 30))) return true;
    return false;
  };
  EXPECT_TRUE(cursor(start, 0, 30));
  EXPECT_FALSE(cursor(start, 900, 960));
  EXPECT_TRUE(cursor(end, 900, 960));
  EXPECT_GT(count_of(start, category(0), strip), 500u);  // the trace
  EXPECT_EQ(film_image(run, frames.at(5), view).height, start.height);
}

TEST(Film, OfAFreeSceneHasNoInstruments) {
  RunResult run = fixtures::survived();
  run.model.free_scene = true;
  EXPECT_FALSE(has_instruments(run));
  EXPECT_TRUE(has_instruments(fixtures::survived()));
  EXPECT_FALSE(has_instruments(fixtures::motionless()));
}

TEST(Model, AThousandBricksReadAsAWall) {
  const RunResult run = fixtures::brick_wall();
  const Image image = draw_model(run.model);
  const Colour first_storey = mixed(category(0), ink::white, 0.66);
  EXPECT_GT(count_of(image, first_storey), 5000u);
  const std::string svg = model_svg(run.model);
  EXPECT_LT(svg.size(), 400'000u);
  EXPECT_THAT(svg, testing::HasSubstr("c49.19"));
}

TEST(Model, AnEmptyModelAndACircleCanBeDrawn) {
  ModelSheet model;
  EXPECT_GT(draw_model(model).width, 0);
  model.blocks.push_back({"wheel", {}, 0.5, {0.0, 0.5}, 0.0, 100.0, 0, ""});
  EXPECT_GT(count_of(draw_model(model), mixed(category(0), ink::white, 0.66)), 5000u);
}

}  // namespace
}  // namespace dougong::app
