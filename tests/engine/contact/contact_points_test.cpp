#include "engine/contact/contact_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/state.h"
#include "tests/engine/collision/scenes.h"
#include "tests/scenes/running.h"

namespace dougong::engine {
namespace {

using scenes::Running;

// Bricks and discs pushed a little into one another, all in motion, nothing held.
Scene cluster(unsigned seed, double friction, double damping_ratio) {
  std::mt19937 random(seed);
  Scene s = scenes::scene(friction, 1e9, damping_ratio);
  s.gravity = {};
  for (int i = 0; i < 12; ++i) {
    const Vec2 place{0.39 * (i % 4), 0.195 * (i / 4)};
    const bool disc = i == 5 || i == 6;
    s.bodies.push_back(
        disc ? testing::body_of(make_circle(0.11), place, 0.3)
             : testing::body_of(make_rectangle(0.4, 0.2), place, testing::uniform(random, -0.01, 0.01)));
    s.bodies.back().velocity = {testing::uniform(random, -1, 1), testing::uniform(random, -1, 1)};
    s.bodies.back().spin = testing::uniform(random, -2, 2);
  }
  return s;
}

struct Loads {
  std::vector<PairLoad> pairs;
  std::vector<Vec2> forces;
  std::vector<double> torques;
};

Loads loads_of(const Running& r) {
  ContactPoints points = r.state.contacts.points;
  Loads l{std::vector<PairLoad>(points.load_count()), std::vector<Vec2>(r.model.size()),
          std::vector<double>(r.model.size())};
  contact_forces(points, frames_of(r.model, r.state), false, l.pairs);
  r.state.contacts.gather(l.pairs, l.forces, l.torques);
  return l;
}

TEST(ContactForces, LeaveTheMomentaOfAnIsolatedClusterAlone) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Running r(cluster(seed, 0.6, 0.5));
    const Loads l = loads_of(r);
    const auto frames = frames_of(r.model, r.state);
    Vec2 force;
    double moment = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < r.model.size(); ++i) {
      force += l.forces[i];
      moment += cross(frames[i].position(), l.forces[i]) + l.torques[i];
      scale += norm(l.forces[i]);
    }
    ASSERT_GT(scale, 1e3);
    EXPECT_LT(norm(force), 1e-12 * scale);
    EXPECT_LT(std::abs(moment), 1e-12 * scale);
  }
}

// What a contact pushes along the edge because its length goes with the position; friction has no part in it.
double end_force(const Running& r, std::size_t i) {
  const ContactPoints& points = r.state.contacts.points;
  const PointGeometry g = geometry_of(points, i, frames_of(r.model, r.state));
  const double overlap = std::max(0.0, g.overlap), slope = bearing_share(points.bearing(i), g.position).slope;
  return 0.5 * slope * points.stiffness(i).normal * overlap * overlap;
}

TEST(ContactForces, AreNeverTensileAndObeyCoulomb) {
  for (const double friction : {0.0, 0.3, 0.8})
    for (const unsigned seed : {4u, 5u, 6u}) {
      const Running r(cluster(seed, friction, 1.0));
      int touching = 0;
      const auto forces = scenes::point_forces(r.model, r.state);
      for (std::size_t i = 0; i < forces.size(); ++i) {
        EXPECT_GE(forces[i].normal, -1e-9 * std::abs(forces[i].tangential));
        EXPECT_LE(std::abs(forces[i].tangential + end_force(r, i)),
                  friction * forces[i].normal * (1.0 + 1e-12) + 1e-9);
        touching += forces[i].normal > 0.0;
      }
      EXPECT_GT(touching, 5);
    }
}

double stored(const Running& r) {
  const StoredEnergy e = stored_energy(r.state.contacts.points, frames_of(r.model, r.state));
  return e.normal + e.tangential;
}

// Elastic only: no dashpot, and more friction than any spring can use. The poses move on from where the
// springs were relaxed, so that all of them hold slip.
TEST(ContactForces, AreMinusTheGradientOfTheStoredEnergy) {
  Scene s = cluster(7, 1e6, 0.0);
  for (Body& body : s.bodies) {
    body.velocity = {}, body.spin = 0.0;
    body.shape = make_rectangle(0.4, 0.2);
  }
  s.bodies[11].shape = make_circle(0.12);
  s.bodies[11].position = {0.39 * 3, 0.41};
  Running r(s);
  scenes::touch(r);
  std::mt19937 random(8);
  for (double& q : r.state.q()) q += testing::uniform(random, -2e-4, 2e-4);
  const Loads l = loads_of(r);
  const std::size_t n = r.bodies();
  double scale = 0.0;
  for (const Vec2 f : l.forces) scale = std::max(scale, norm(f));
  for (std::size_t k = 0; k < 3 * n; ++k) {
    const double step = 1e-7, here = r.state.q()[k];
    r.state.q()[k] = here + step;
    const double above = stored(r);
    r.state.q()[k] = here - step;
    const double below = stored(r);
    r.state.q()[k] = here;
    const double force = k < n ? l.forces[k].x : (k < 2 * n ? l.forces[k - n].y : l.torques[k - 2 * n]);
    EXPECT_NEAR(force, -(above - below) / (2.0 * step), 1e-5 * scale) << k;
  }
}

// A contact that keeps its poses takes no work; one that slides takes friction times distance.
TEST(ContactForces, TakeTheWorkOfFrictionOnly) {
  Scene s = scenes::block_on_ground(0.5, 0.1, 0.4, 1e9);
  s.bodies[0].position.y -= 1e-5;
  s.bodies[0].velocity = {2.0, 0.0};
  Running r(s);
  ContactPoints& points = r.state.contacts.points;
  std::vector<PairLoad> loads(points.load_count());
  const ContactTotals totals = contact_forces(points, frames_of(r.model, r.state), true, loads);
  double normal = 0.0;
  for (const PairLoad& load : loads) normal += load.fy;
  EXPECT_NEAR(totals.tangential_power, 0.4 * normal * 2.0, 1e-9 * normal);
  EXPECT_NEAR(totals.damping_power, 0.0, 1e-9 * normal);
  EXPECT_NEAR(totals.deepest_ratio, 1e-5 / 0.2, 1e-10);
}

TEST(ContactForces, AreTheSameAtRestAndInAMovingFrame) {
  Scene still = cluster(9, 0.5, 1.0), moving = cluster(9, 0.5, 1.0);
  for (Body& body : moving.bodies) body.velocity += Vec2{16.0, -8.0};
  const Loads a = loads_of(Running(still)), b = loads_of(Running(moving));
  for (std::size_t i = 0; i < a.forces.size(); ++i)
    EXPECT_LT(norm(a.forces[i] - b.forces[i]), 1e-10 * (1.0 + norm(a.forces[i])));
}

// The first moment of a spring: relaxed wherever the bodies first meet.
TEST(SlipAnchor, StartsRelaxed) {
  Running r(cluster(10, 0.6, 0.0));
  std::fill(r.state.v().begin(), r.state.v().end(), 0.0);
  scenes::touch(r);
  const auto forces = scenes::point_forces(r.model, r.state);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_NEAR(forces[i].tangential + end_force(r, i), 0.0, 1e-6 * (1.0 + forces[i].normal));
}

TEST(SlipAnchor, StaysWhileTheSpringHoldsLessThanFrictionAllows) {
  Scene s = scenes::block_on_ground(0.5, 0.1, 0.4, 1e9);
  s.bodies[0].position.y -= 1e-4;
  Running r(s);
  scenes::touch(r);
  r.state.q()[0] += 1e-6;
  const double held = scenes::point_forces(r.model, r.state)[0].tangential;
  ASSERT_GT(std::abs(held), 1.0);
  for (int i = 0; i < 1000; ++i) scenes::touch(r);
  EXPECT_NEAR(scenes::point_forces(r.model, r.state)[0].tangential, held, 1e-9 * std::abs(held));
  r.state.q()[0] += 1e-3;  // more than mu N / kt
  scenes::touch(r);
  r.state.q()[0] -= 1e-6;  // so the spring is below the limit again, and by kt times that
  const auto f = scenes::point_forces(r.model, r.state)[0];
  const double kt = r.state.contacts.points.stiffness(0).tangential;
  EXPECT_NEAR(std::abs(f.tangential), 0.4 * f.normal - kt * 1e-6, 1e-6 * f.normal);
}

TEST(SlipAnchor, SurvivesAFreshSearchForContacts) {
  Scene s = scenes::block_on_ground(0.5, 0.1, 0.4, 1e9);
  s.bodies[0].position.y -= 1e-4;
  Running r(s);
  scenes::touch(r);
  r.state.q()[0] += 2e-5;
  const double before = scenes::point_forces(r.model, r.state)[0].tangential;
  ASSERT_GT(std::abs(before), 1.0);
  r.state.q()[1] -= 3e-3;  // far enough for a new manifold, and there and back again
  EXPECT_FALSE(r.state.contacts.update(r.model, frames_of(r.model, r.state)));
  r.state.q()[1] += 3e-3;
  r.state.contacts.update(r.model, frames_of(r.model, r.state));
  EXPECT_NEAR(scenes::point_forces(r.model, r.state)[0].tangential, before, 1e-9 * std::abs(before));
}

// A disc that rolls without slip on a floor keeps its spring relaxed; one that only turns winds it up.
TEST(SlipAnchor, OfARollingDiscStaysRelaxed) {
  for (const bool on_disc : {false, true}) {
    Scene s = scenes::scene(1e3, 1e9, 0.0);
    s.gravity = {};
    if (on_disc)
      s.bodies.push_back(testing::body_of(make_circle(0.3), {0.0, -0.299}, 0.0));
    else
      s.terrains.push_back(scenes::ground());
    s.bodies.push_back(testing::body_of(make_circle(0.3), {0.0, 0.3 - 1e-3}, 0.0));
    Running r(s);
    scenes::touch(r);
    const std::size_t n = r.bodies(), top = n - 1;
    const double phi = 1e-5;  // of roll
    if (on_disc) {
      const double distance = 0.299 + 0.299;
      r.state.q()[top] -= distance * std::sin(phi);
      r.state.q()[n + top] -= distance * (1.0 - std::cos(phi));
      r.state.q()[2 * n + top] += distance * phi / 0.3;
    } else {
      r.state.q()[top] -= 0.3 * phi;
      r.state.q()[2 * n + top] += phi;
    }
    const auto rolled = scenes::point_forces(r.model, r.state);
    r.state.q()[2 * n + top] += phi;
    const auto turned_only = scenes::point_forces(r.model, r.state);
    EXPECT_LT(std::abs(rolled[0].tangential), 1e-3 * std::abs(turned_only[0].tangential)) << on_disc;
    EXPECT_GT(std::abs(turned_only[0].tangential), 1.0) << on_disc;
  }
}

}  // namespace
}  // namespace dougong::engine
