// Validation case X10: bodies that overlap at the start part no faster than their springs can throw them.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/engine/reference.h"
#include "tests/scenes/discs.h"

namespace dougong::engine {
namespace {

using scenes::block;
using scenes::run_for;
using scenes::Running;
using testing::expect_absolute;
using testing::expect_relative;
using testing::report;
using testing::text;

Scene floating(double young_modulus, double damping_ratio) {
  Scene s = scenes::scene(0.6, young_modulus, damping_ratio);
  s.gravity = {};
  return s;
}

DriveOptions run_with(double step_fraction) {
  DriveOptions options = run_for(0.1, 1e-3);
  options.step_fraction = step_fraction;
  return options;
}

double separation_speed(const Running& r) {
  return norm(r.velocity(1) - r.velocity(0));
}

// Two blocks of half sizes b, h face to face: columns in series, k = 2 b/(2 h/E).
void check_faces(double b, double h, double young_modulus, double overlap, double damping_ratio,
                 double step_fraction) {
  Scene s = floating(young_modulus, damping_ratio);
  s.bodies = {block(b, h, {0.0, 0.0}), block(b, h, {0.0, 2.0 * h - overlap})};
  s.bodies[1].mass = 7200.0 * 4.0 * b * h;
  Running r(s);
  const double k = b * young_modulus / h, m1 = r.model.mass[0], m2 = r.model.mass[1];
  const double greatest = overlap * std::sqrt(k * (m1 + m2) / (m1 * m2));
  EXPECT_EQ(r.run(run_with(step_fraction)).outcome, Outcome::completed);
  const std::string name = "faces, overlap " + text(1e6 * overlap) + " um, xi=" + text(damping_ratio) + ", " +
                           text(step_fraction) + " of the bound: ";
  const double part = separation_speed(r) / greatest;
  const double made = r.energies().kinetic / (0.5 * k * overlap * overlap);
  report("X10", name + "speed over delta sqrt(k/m), at most 1", 1.0, part, part, 1.0 + 1e-3);
  report("X10", name + "kinetic energy over k delta^2/2, at most 1", 1.0, made, made, 1.0 + 1e-3);
  if (damping_ratio == 0.0 && step_fraction < 0.1)
    expect_relative("X10", name + "the same, without loss", 1.0, part, 0.005);
}

TEST(InitialOverlap, OfFacesThrowsThemNoFasterThanTheirSprings) {
  for (const double overlap : {1e-6, 1e-3, 0.03})
    for (const double damping_ratio : {0.0, 1.0})
      for (const double fraction : {0.5, 0.05}) check_faces(0.5, 0.2, 30e9, overlap, damping_ratio, fraction);
}
TEST(InitialOverlap, OfOtherFacesDoesSoToo) {
  for (const double overlap : {1e-5, 0.01}) check_faces(0.1, 0.05, 1e8, overlap, 0.0, 0.05);
}

// Corner in face, corner in corner, disc in disc, disc in face: the springs hold what they hold.
void check_no_gain(const std::string& name, Body below, Body above, double damping_ratio,
                   double step_fraction) {
  Scene s = floating(1e9, damping_ratio);
  s.bodies = {std::move(below), std::move(above)};
  Running r(s);
  const double stored = r.energies().elastic, balance = r.energies().balance();
  ASSERT_GT(stored, 0.0) << name;
  double fastest = 0.0, worst = 0.0;
  const RunOutcome run = r.run(run_with(step_fraction), [&](const Sample&) {
    const Energies e = r.energies();
    fastest = std::max(fastest, e.kinetic), worst = std::max(worst, std::abs(e.balance() - balance));
    return Wish::go_on;
  });
  EXPECT_EQ(run.outcome, Outcome::completed) << name << run.detail;
  const std::string label = name + " xi=" + text(damping_ratio) + ", " + text(step_fraction) + ": ";
  report("X10", label + "kinetic over stored energy, at most 1", 1.0, fastest / stored, fastest / stored,
         1.0 + 1e-3);
  expect_absolute("X10", label + "energy error over stored", 0.0, worst / stored,
                  step_fraction < 0.1 ? 1e-3 : 0.05);
}

TEST(InitialOverlap, MakesNoEnergyWhateverTouches) {
  const double quarter = 0.25 * std::numbers::pi;
  for (const auto& [xi, fraction] : {std::pair{0.0, 0.5}, {0.0, 0.05}, {1.0, 0.5}, {1.0, 0.05}}) {
    check_no_gain("corner in face", block(0.5, 0.2, {}), block(0.1, 0.1, {0.1, 0.32}, quarter), xi, fraction);
    check_no_gain("corner in corner", block(0.2, 0.2, {}, quarter), block(0.2, 0.2, {0.01, 0.54}, quarter),
                  xi, fraction);
    check_no_gain("corner beside corner", block(0.2, 0.2, {}), block(0.2, 0.2, {0.39, 0.385}), xi, fraction);
    check_no_gain("disc in disc", scenes::disc(0.2, {}), scenes::disc(0.1, {0.0, 0.27}), xi, fraction);
    check_no_gain("disc in face", block(0.5, 0.2, {}), scenes::disc(0.1, {0.1, 0.28}), xi, fraction);
  }
}

}  // namespace
}  // namespace dougong::engine
