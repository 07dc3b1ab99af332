#include "structures/layouts/dampers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/drive.h"
#include "tests/engine/reference.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

const std::string frame = "timber-frame";

/// A frame of one storey and one bay that does not damp its sway by itself: rigid posts in springy joints.
Building plain(ParameterMap values) {
  values.insert({{"storeys", 1}, {"bays", 1}, {"joint_damping_ratio", 0.0}, {"floor_load", 20e3}});
  Building building = build_layout(frame, values);
  building.scene.gravity = {};
  return building;
}

/// Extremes of a level's sway after it was let go with that speed (m/s).
std::vector<double> extremes(Built& built, double speed, double duration) {
  const std::size_t beam = index_of(built.building, "S1.beam1");
  const auto modes = built.modes();
  const double at_beam = modes.front().shape[beam];
  for (std::size_t i = 0; i < modes.front().shape.size(); ++i)
    built.state.v()[i] = speed * modes.front().shape[i] / at_beam;
  const double start = built.state.q()[beam];
  std::vector<double> sway, peaks;
  engine::DriveOptions options;
  options.end_time = duration;
  options.output_interval = built.first_period() / 200.0;
  engine::drive(built.model, built.state, options, [&](const engine::Sample& sample) {
    sway.push_back(sample.state.q()[beam] - start);
    return engine::Wish::go_on;
  });
  for (std::size_t i = 1; i + 1 < sway.size(); ++i)
    if (std::abs(sway[i]) >= std::abs(sway[i - 1]) && std::abs(sway[i]) > std::abs(sway[i + 1]))
      peaks.push_back(std::abs(sway[i]));
  return peaks;
}

// zeta = c cos2(a)/(2 m w) for a rigid frame whose dashpot joins the ground to the far end of the beam.
TEST(ViscousDamper, DampsAsItsInclinationSays) {
  const double c = 2e4;
  Built built(plain({{"damper", word(frame, "damper", "viscous")}, {"damper_coefficient", c}}));
  const Built bare(plain({}));
  const double omega = 2.0 * std::numbers::pi / bare.first_period();
  EXPECT_NEAR(built.first_period(), bare.first_period(), 1e-9) << "a dashpot has no stiffness";
  const double stiffness = 1.0 / bare.flexibility({index_of(bare.building, "S1.beam1")});
  const engine::Joint& dashpot = built.building.scene.joints.back();
  const engine::Vec2 head = built.building.scene.bodies[dashpot.b.index].position + dashpot.anchor_b;
  const engine::Vec2 foot = built.building.scene.terrains[0].position + dashpot.anchor_a;
  const engine::Vec2 along = head - foot;
  // The beam's end goes up with the face of its post, by half a post width times the post's turn.
  const double rise = 0.5 * 0.18 / head.y;
  const double cosine = (along.x + along.y * rise) / engine::norm(along);
  const double expected = c * cosine * cosine * omega / (2.0 * stiffness);
  const std::vector<double> peaks = extremes(built, 0.05, 4.0 * bare.first_period());
  ASSERT_GE(peaks.size(), 6u);
  const double decrement = std::log(peaks[0] / peaks[4]) / 2.0;
  dougong::testing::expect_relative("layout", "damping of a viscous damper", expected,
                                    decrement / std::hypot(2.0 * std::numbers::pi, decrement), 0.03);
}

// Each half cycle a slipping brace takes 2 F/(K + K_f) off the amplitude of the sway while it slips: here the
// brace is far stiffer than the frame, so 2 F/K.
TEST(FrictionDamper, TakesTheSameOffEveryCycle) {
  const double force = 200.0;
  const Built bare(plain({}));
  const double stiffness = 1.0 / bare.flexibility({index_of(bare.building, "S1.beam1")});
  Built built(plain({{"damper", word(frame, "damper", "friction")},
                     {"damper_slip_force", force},
                     {"brace_stiffness", 5e8}}));
  const double omega = 2.0 * std::numbers::pi / bare.first_period(), step = 2.0 * force / stiffness;
  const std::vector<double> peaks = extremes(built, 8.0 * step * omega, 2.0 * bare.first_period());
  ASSERT_GE(peaks.size(), 3u);
  for (std::size_t i = 0; i + 1 < 3; ++i)
    dougong::testing::expect_relative("layout", "loss of amplitude by a friction damper", step,
                                      peaks[i] - peaks[i + 1], 0.1);
}

// Two degrees of freedom: the frame's mass and stiffness in its mode, and the tuned mass on its roof.
TEST(TunedMass, SplitsThePeriodOfItsFrame) {
  const std::string concrete = "concrete-frame";
  const ParameterMap values{{"storeys", 1}, {"bays", 1}};
  Built bare(concrete, values);
  bare.settle();
  const engine::Mode mode = bare.modes().front();
  const double period = mode.period();
  ParameterMap with = values;
  with["damper"] = word(concrete, "damper", "tuned-mass");
  with["tuned_period"] = period;
  Built built(concrete, with);
  expect_no_findings(built.building);
  expect_settles(built, 5e-3);
  // Generalised mass of the frame where the tuned mass stands.
  double total = 0.0;
  for (std::size_t i = 0; i < bare.model.body_count; ++i) total += bare.model.mass[i];
  const std::size_t roof = index_of(bare.building, "S1.beam1.3");
  const double ratio = 0.05 * total * mode.shape[roof] * mode.shape[roof];
  auto modes = built.modes();
  ASSERT_GE(modes.size(), 2u);
  for (const auto& [index, sign] : {std::pair<std::size_t, double>{0, -1.0}, {1, 1.0}}) {
    // r of w2 = w0^2 (1 + mu/2 -+ sqrt(mu + mu2/4)) for equal frequencies.
    const double factor = 1.0 + 0.5 * ratio + sign * std::sqrt(ratio + 0.25 * ratio * ratio);
    dougong::testing::expect_relative("layout", "tuned mass, period " + std::to_string(index + 1),
                                      period / std::sqrt(factor), modes[index].period(), 0.01);
  }
}

TEST(Dampers, GoIntoEveryLayout) {
  for (const Layout& layout : layouts())
    for (const char* kind : {"viscous", "friction", "tuned-mass"}) {
      const ParameterMap values{{"damper", word(layout.name, "damper", kind)}};
      const std::string refused = refusal(layout.name, values);
      if (refused != "accepted") {
        EXPECT_THAT(refused, ::testing::HasSubstr("damper: expected")) << layout.name;
        continue;
      }
      for (const Finding& finding : check_model(build_layout(layout.name, values)))
        ADD_FAILURE() << layout.name << " " << kind << ": " << finding.message;
    }
}

}  // namespace
}  // namespace dougong::structures
