#include "structures/layouts/isolation.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "structures/layouts/fittings.h"
#include "tests/engine/reference.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

double isolation(const std::string& chosen) {
  return word("column", "isolation", chosen);
}

/// Case B05: three storeys of 30 t on springs of 8e7 N/m that only sway.
Building shear_building() {
  const ParameterValues values = complete_parameters(find_layout("column"), {{"ground_width", 40.0}});
  Building building = on_ground("concrete", values);
  for (int storey = 1; storey <= 3; ++storey) {
    const std::string name = "S" + std::to_string(storey);
    const std::size_t floor = add_rectangle(building, values, name, 0.0, storey - 1.0, 4.0, 1.0);
    building.scene.bodies[floor].mass = 3e4;
    engine::Joint joint =
        joint_at(building, name, engine::JointKind::weld, floor == 0 ? ground() : block(floor - 1),
                 block(floor), {0.0, storey - 1.0}, {0.0, storey - 1.0}, 8e7);
    joint.rotational_stiffness = 1e16;
    building.scene.joints.push_back(joint);
    building.storeys.push_back({name, storey - 1.0, 1.0, {floor}, {floor}});
  }
  return building;
}

TEST(Isolation, HasThePeriodsOfB05) {
  const auto fixed = weightless(shear_building()).modes();
  const double fixed_periods[] = {0.2734, 0.097574, 0.067524};
  for (std::size_t i = 0; i < 3; ++i)
    dougong::testing::expect_relative("B05", "layout, fixed T" + std::to_string(i + 1), fixed_periods[i],
                                      fixed.at(i).period(), 1e-3);

  // A raft of 30 t: 4.6 m by 0.4 m by 1 m of a fitting density; M counts it, so T is that of four masses.
  const double density = 3e4 / (4.6 * 0.4);
  ParameterMap asked{{"isolation", isolation("linear")}, {"density", density}, {"ground_width", 40.0}};
  Building building = shear_building();
  building.scene.materials.front().density = density;
  Built isolated_building(isolated(std::move(building), complete_parameters(find_layout("column"), asked)));
  EXPECT_NEAR(mass_of(isolated_building.building, 3), 3e4, 1.0);
  expect_settles(isolated_building, 0.05);  // the springs of its storeys are as soft upright
  const double periods[] = {2.5095, 0.15845, 0.085999, 0.065846};
  const auto modes = isolated_building.modes();
  for (std::size_t i = 0; i < 4; ++i)
    dougong::testing::expect_relative("B05", "layout, isolated T" + std::to_string(i + 1), periods[i],
                                      modes.at(i).period(), 0.02);
}

TEST(Isolation, OfARigidBlockIsItsPeriod) {
  for (const double period : {0.8, 2.5}) {
    Built built(
        "column",
        {{"drums", 1}, {"width", 3.0}, {"isolation", isolation("linear")}, {"isolation_period", period}});
    expect_settles(built, 1e-3);
    dougong::testing::expect_relative("B05", "rigid block on linear isolators", period, built.first_period(),
                                      0.005);
  }
}

TEST(Isolation, OfAPendulumIsThatOfItsRadius) {
  Built built("column", {{"drums", 1},
                         {"width", 3.0},
                         {"isolation", isolation("friction-pendulum")},
                         {"isolation_friction", 0.0},
                         {"pendulum_radius", 2.0}});
  expect_settles(built, 1e-3);
  dougong::testing::expect_relative("layout", "friction pendulum of 2 m",
                                    2.0 * std::numbers::pi * std::sqrt(2.0 / engine::standard_gravity),
                                    built.first_period(), 0.005);
}

/// A sin(2 pi f t) of acceleration, from rest.
class Shaking final : public engine::PrescribedMotion {
 public:
  Shaking(double amplitude, double frequency) : a_(amplitude), w_(2.0 * std::numbers::pi * frequency) {}
  engine::MotionSample at(double t) const override {
    return {{a_ / w_ * (t - std::sin(w_ * t) / w_), 0.0},
            {a_ / w_ * (1.0 - std::cos(w_ * t)), 0.0},
            {a_ * std::sin(w_ * t), 0.0}};
  }

 private:
  double a_, w_;
};

/// Greatest absolute acceleration of a rigid block on such isolators, over g.
double passed_on(ParameterMap values, double amplitude, double frequency) {
  values.insert({{"drums", 1}, {"width", 3.0}, {"resting_damping_ratio", 0.5}});
  Building building = build_layout("column", values);
  building.scene.terrains.front().motion = std::make_shared<Shaking>(amplitude, frequency);
  Built built(std::move(building));
  built.settle();
  engine::DriveOptions options;
  options.end_time = 3.0;
  double greatest = 0.0;
  engine::drive(built.model, built.state, options, [&](const engine::Sample& sample) {
    greatest = std::max(greatest, std::abs(sample.accelerations[0]));
    return engine::Wish::go_on;
  });
  return greatest / engine::standard_gravity;
}

// What slides passes on no more than its friction.
TEST(Isolation, OfSlidersPassesOnTheirFriction) {
  const double g = engine::standard_gravity;
  EXPECT_NEAR(passed_on({{"isolation", isolation("sliding")}, {"isolation_friction", 0.08}}, 0.4 * g, 2.0),
              0.08, 0.004);
  EXPECT_NEAR(passed_on({}, 0.4 * g, 2.0), 0.4, 0.02) << "on the ground itself";
}

// Every layout of the table can be put on every kind of isolators.
TEST(Isolation, GoesUnderEveryLayout) {
  for (const Layout& layout : layouts())
    for (const char* kind : {"linear", "friction-pendulum", "sliding"}) {
      const Building building = build_layout(layout.name, {{"isolation", isolation(kind)}});
      for (const Finding& finding : check_model(building))
        ADD_FAILURE() << layout.name << " " << kind << ": " << finding.message;
      EXPECT_EQ(building.storeys.front().name, "raft");
      EXPECT_EQ(building.scene.terrains.size(), 1u) << layout.name;
    }
}

TEST(Isolation, NeedsAGroundAsWideAsItsRaft) {
  EXPECT_THAT(refusal("column", {{"isolation", isolation("linear")}, {"ground_width", 1.2}}),
              ::testing::HasSubstr("ground_width"));
}

}  // namespace
}  // namespace dougong::structures
