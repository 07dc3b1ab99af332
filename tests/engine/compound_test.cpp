// Compound bodies, half-planes and ground lines: they weigh, stand, slide and roll as the shapes they
// replace.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "engine/settle.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::run_for;
using scenes::Running;
using ::testing::HasSubstr;

Part rectangle_part(double width, double height, Vec2 position, double angle = 0.0) {
  return {make_rectangle(width, height), position, angle};
}

Body body_of(const PlacedCompound& placed, Vec2 position) {
  Body body;
  body.name = "compound";
  body.shape = placed.compound;
  body.position = position;
  return body;
}

Terrain plane(double slope = 0.0) {
  Terrain terrain;
  terrain.name = "plane";
  terrain.shape = HalfPlane{};
  terrain.angle = slope;
  return terrain;
}

TEST(Compound, OfTwoHalvesHasTheMassOfTheWhole) {
  const auto halves =
      make_compound({rectangle_part(0.4, 0.6, {5.0, 7.0}), rectangle_part(0.8, 0.6, {5.6, 7.0})});
  const MassProperties got = mass_properties(halves.compound, 2400.0, 0.5);
  const MassProperties whole = mass_properties(make_rectangle(1.2, 0.6), 2400.0, 0.5);
  EXPECT_NEAR(got.mass, whole.mass, 1e-12 * whole.mass);
  EXPECT_NEAR(got.inertia, whole.inertia, 1e-12 * whole.inertia);
  EXPECT_NEAR(halves.centroid.x, 5.4, 1e-14);
  EXPECT_NEAR(bounding_radius(halves.compound), std::hypot(0.6, 0.3), 0.1);
}

// An L of two bars, by hand: areas 0.8 and 0.4 at (1, 0.2) and (0.2, 0.9).
TEST(Compound, OfAnEllHasItsCentroidAndInertia) {
  const auto ell =
      make_compound({rectangle_part(2.0, 0.4, {1.0, 0.2}), rectangle_part(0.4, 1.0, {0.2, 0.9})});
  const Vec2 centroid{(0.8 * 1.0 + 0.4 * 0.2) / 1.2, (0.8 * 0.2 + 0.4 * 0.9) / 1.2};
  EXPECT_NEAR(norm(ell.centroid - centroid), 0.0, 1e-14);
  const auto moment = [&](double w, double h, Vec2 at) {
    return w * h * ((w * w + h * h) / 12.0 + dot(at - centroid, at - centroid));
  };
  EXPECT_NEAR(area_properties(ell.compound).second_moment,
              moment(2.0, 0.4, {1.0, 0.2}) + moment(0.4, 1.0, {0.2, 0.9}), 1e-13);
}

TEST(Compound, RefusesPartsThatOverlap) {
  const auto refused = [](std::vector<Part> parts) {
    try {
      make_compound(std::move(parts));
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refused({rectangle_part(1, 1, {0, 0}), rectangle_part(1, 1, {0.9, 0})}),
              HasSubstr("parts 1 and 2"));
  EXPECT_THAT(refused({rectangle_part(1, 1, {0, 0}), {make_circle(0.5), {0.9, 0.0}, 0.0}}),
              HasSubstr("overlap"));
  EXPECT_EQ(refused({rectangle_part(1, 1, {0, 0}), {make_circle(0.5), {0.86, 0.86}, 0.0}}), "accepted");
  EXPECT_EQ(refused({{make_circle(0.5), {0, 0}, 0.0}, {make_circle(0.5), {1.0, 0.0}, 0.0}}), "accepted");
  EXPECT_THAT(refused({}), HasSubstr("at least one part"));
}

TEST(Compound, HidesTheEdgesBetweenItsParts) {
  const auto halves = make_compound({rectangle_part(1, 1, {0, 0}), rectangle_part(1, 1, {1, 0})});
  int inner = 0;
  for (const Collider& piece : colliders_of(halves.compound, 0))
    for (std::size_t e = 0; e < 4; ++e) inner += std::get<ConvexPolygon>(piece.shape).is_inner(e);
  EXPECT_EQ(inner, 2);
}

// A dumb-bell of two discs and a bar, rolling free of forces: one rigid body.
TEST(Compound, MovesAsOneBody) {
  Scene s;
  s.gravity = {};
  const auto bell = make_compound({{make_circle(0.2), {-0.5, 0.0}, 0.0},
                                   rectangle_part(0.6, 0.1, {0.0, 0.0}),
                                   {make_circle(0.2), {0.5, 0.0}, 0.0}});
  s.bodies.push_back(body_of(bell, {1.0, 2.0}));
  s.bodies[0].velocity = {0.3, -0.1};
  s.bodies[0].spin = 2.0;
  Running r(s);
  r.run(run_for(1.0));
  EXPECT_NEAR(r.position().x, 1.3, 1e-12);
  EXPECT_NEAR(r.angle(), 2.0, 1e-12);
}

// A table of a top and two legs settles with its weight on four corners, each leg sharing half.
TEST(Compound, StandsOnItsLegs) {
  Scene s = scenes::scene(0.6, 1e9);
  const auto table =
      make_compound({rectangle_part(2.0, 0.2, {0.0, 0.9}), rectangle_part(0.2, 0.8, {-0.8, 0.4}),
                     rectangle_part(0.2, 0.8, {0.8, 0.4})});
  s.bodies.push_back(body_of(table, table.centroid));
  s.terrains.push_back(plane());
  Running r(s);
  ASSERT_TRUE(settle(r.model, r.state).settled);
  double left = 0.0, right = 0.0;
  for (const auto& f : scenes::point_forces(r.model, r.state)) (f.place.x < 0.0 ? left : right) += f.normal;
  const double weight = r.model.mass[0] * 9.81;
  EXPECT_NEAR(left / weight, 0.5, 1e-4);
  EXPECT_NEAR(right / weight, 0.5, 1e-4);
  EXPECT_NEAR(r.angle(), 0.0, 1e-8);
}

TEST(HalfPlane, CarriesABlockAsALongRectangleDoes) {
  for (const double slope : {0.0, 0.3}) {
    Scene with_plane = scenes::scene(0.2), with_ground = scenes::scene(0.2);
    with_plane.bodies.push_back(scenes::block(0.5, 0.2, rotated({0.0, 0.2}, slope), slope));
    with_ground.bodies = with_plane.bodies;
    with_plane.terrains.push_back(plane(slope));
    with_ground.terrains.push_back(scenes::ground(200.0, {}, slope));
    Running a(with_plane), b(with_ground);
    a.run(run_for(1.0)), b.run(run_for(1.0));
    EXPECT_NEAR(norm(a.position() - b.position()), 0.0, 1e-9) << slope;
    EXPECT_NEAR(a.angle(), b.angle(), 1e-9) << slope;
  }
}

TEST(HalfPlane, StopsWhateverComesFromAnywhere) {
  Scene s = scenes::scene(0.5, 1e9);
  Body disc;
  disc.name = "disc";
  disc.shape = make_circle(0.3);
  disc.position = {-1e4, 5.0};
  s.bodies.push_back(disc);
  s.bodies.push_back(scenes::block(0.2, 0.4, {1e4, 20.0}, 0.7));
  s.terrains.push_back(plane());
  Running r(s);
  r.run(run_for(6.0, 0.1));
  EXPECT_NEAR(r.position(0).y, 0.3, 1e-3);
  EXPECT_LT(r.position(1).y, 0.46);
  EXPECT_GT(r.position(1).y, 0.19);
}

TEST(HalfPlane, CannotBeABody) {
  Scene s;
  s.bodies.push_back({});
  s.bodies[0].name = "sea";
  s.bodies[0].shape = HalfPlane{};
  EXPECT_THROW(compile(s), std::invalid_argument);
}

Terrain ground_line(std::span<const Vec2> points) {
  const PlacedCompound line = make_polyline_ground(points, 1.0);
  Terrain terrain;
  terrain.name = "ground line";
  terrain.shape = line.compound;
  terrain.position = line.centroid;
  return terrain;
}

// The seams of a flat ground line are no steps: a block slides over them as over one long ground.
TEST(GroundLine, HasNoStepsAtItsSeams) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 40; ++i) points.push_back({-2.0 + 0.13 * i, 0.0});
  Scene seams = scenes::scene(0.3, 1e9), smooth = scenes::scene(0.3, 1e9);
  seams.bodies.push_back(scenes::block(0.25, 0.1, {-1.2, 0.1}));
  smooth.bodies = seams.bodies;
  seams.terrains.push_back(ground_line(points));
  smooth.terrains.push_back(plane());
  Running a(seams), b(smooth);
  ASSERT_TRUE(settle(a.model, a.state).settled);
  ASSERT_TRUE(settle(b.model, b.state).settled);
  a.state.v()[0] = b.state.v()[0] = 2.5;
  a.run(run_for(1.5));
  b.run(run_for(1.5));
  EXPECT_NEAR(a.position().x, b.position().x, 0.01 * (b.position().x + 1.2));
  EXPECT_NEAR(a.velocity().x, 0.0, 1e-6);
  EXPECT_NEAR(a.angle(), 0.0, 1e-5);
}

TEST(GroundLine, LetsADiscRollThroughAValley) {
  std::vector<Vec2> points;
  for (int i = -30; i <= 30; ++i) points.push_back({0.1 * i, 0.05 * 0.01 * i * i});
  Scene s = scenes::scene(0.8, 1e9);
  Body disc;
  disc.name = "disc";
  disc.shape = make_circle(0.4);
  disc.position = {-2.0, 0.2 + 0.42};
  s.bodies.push_back(disc);
  s.terrains.push_back(ground_line(points));
  Running r(s);
  double leftmost = 0.0, rightmost = 0.0;
  r.run(run_for(12.0), [&](const Sample& sample) {
    const double x = r.model.origin.x + sample.state.q()[0];
    leftmost = std::min(leftmost, x), rightmost = std::max(rightmost, x);
    return Wish::go_on;
  });
  EXPECT_GT(rightmost, 1.2) << "climbs the other side";
  EXPECT_LT(rightmost, 2.0);
  EXPECT_GT(leftmost, -2.1);
  EXPECT_GT(r.position().y, 0.35);
}

// Without friction only the landings on the new slope take speed: of the part across it, twice at most.
void expect_speed_after_kink(double slope) {
  const Vec2 down{std::cos(slope), -std::sin(slope)}, up{std::sin(slope), std::cos(slope)};
  const Vec2 points[] = {-10.0 * down, {0.0, 0.0}, {10.0, 0.0}};
  Scene s = scenes::scene(0.0, 3e9);
  s.bodies.push_back(scenes::block(0.2, 0.1, 0.1 * up - 3.0 * down, -slope));
  s.bodies[0].velocity = 3.0 * down;
  s.terrains.push_back(ground_line(points));
  Running r(s);
  r.run(run_for(1.5));
  const double before = std::sqrt(9.0 + 2.0 * norm(s.gravity) * 3.0 * std::sin(slope));
  EXPECT_LE(r.velocity().x, before) << slope;
  EXPECT_GE(r.velocity().x, before * std::cos(slope) * std::cos(slope)) << slope;
  EXPECT_NEAR(r.angle(), 0.0, 1e-5) << slope;
}

TEST(GroundLine, LetsABlockSlideThroughAConcaveKink) {
  for (const double slope : {0.05, 0.17, 0.35}) expect_speed_after_kink(slope);
}

TEST(GroundLine, RefusesPointsThatTurnBack) {
  const Vec2 back[] = {{0, 0}, {1, 0}, {0.5, 0.2}};
  EXPECT_THROW(make_polyline_ground(back, 1.0), std::invalid_argument);
  EXPECT_THROW(make_polyline_ground(std::span(back, 1), 1.0), std::invalid_argument);
  EXPECT_THROW(make_polyline_ground(std::span(back, 2), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace dougong::engine
