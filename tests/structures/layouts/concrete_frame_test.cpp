#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "tests/engine/reference.h"
#include "tests/structures/layouts/built.h"

namespace dougong::structures {
namespace {

using ::testing::HasSubstr;

const std::string frame = "concrete-frame";

/// A portal whose columns of height h carry a beam, pushed at one end of it: half of the load sways both
/// nodes (sway, turn, the columns' change of length), half pulls them apart. Members bend, shear and stretch.
struct Portal {
  double h, span, column, beam, thickness, modulus, shear_modulus;  // m, Pa; infinite: no shear

  double inertia(double depth) const { return thickness * depth * depth * depth / 12.0; }
  double shear_number(double depth, double length) const {
    return 12.0 * modulus * inertia(depth) /
           (5.0 / 6.0 * shear_modulus * thickness * depth * length * length);
  }
  double stiffness() const {
    const double ei = modulus * inertia(column), f = shear_number(column, h);
    const double kb = 6.0 * modulus * inertia(beam) / ((1.0 + shear_number(beam, span)) * span);
    Eigen::Matrix3d k;  // u, turn, lengthening of one column
    k << 2 * 12 * ei / ((1 + f) * h * h * h), -2 * 6 * ei / ((1 + f) * h * h), 0,                    //
        -2 * 6 * ei / ((1 + f) * h * h), 2 * (4 + f) * ei / ((1 + f) * h) + 2 * kb, -4 * kb / span,  //
        0, -4 * kb / span, 2 * modulus * thickness * column / h + 8 * kb / (span * span);
    const double sway = k.ldlt().solve(Eigen::Vector3d(1.0, 0.0, 0.0)).x();
    // The half of the load that pulls the nodes apart stretches the beam.
    Eigen::Matrix2d spread;
    spread << 12 * ei / ((1 + f) * h * h * h) + 2 * modulus * thickness * beam / span,
        -6 * ei / ((1 + f) * h * h),  //
        -6 * ei / ((1 + f) * h * h), (4 + f) * ei / ((1 + f) * h) + 2 * modulus * inertia(beam) / span;
    return 1.0 / (sway + spread.ldlt().solve(Eigen::Vector2d(0.5, 0.0)).x());
  }
};

constexpr double relief = 0.002;  // of the layout, m

/// Case B03, h to the beam's axis.
Built portal(double blocks_per_column, double blocks_per_beam) {
  return weightless(build_layout(frame, {{"storeys", 1},
                                         {"bays", 1},
                                         {"storey_height", 3.0 + 0.25 + relief},
                                         {"bay_width", 6.0},
                                         {"blocks_per_column", blocks_per_column},
                                         {"blocks_per_beam", blocks_per_beam},
                                         {"cracked_stiffness", 1.0}}));
}

double sway_stiffness(const Built& built) {
  return 1.0 / built.flexibility({index_of(built.building, "S1.node1")});
}

TEST(ConcreteFrame, SwaysAsThePortalOfB03) {
  const double endless = std::numeric_limits<double>::infinity();
  const Portal bending{3.0, 6.0, 0.4, 0.5, 0.4, 30e9, endless};
  dougong::testing::expect_relative("B03", "oracle, with axial strain", 3.910644e7, bending.stiffness(),
                                    1e-4);
  // With the columns' shear, which the table of B03 leaves out and the faces have.
  Portal shearing = bending;
  shearing.shear_modulus = 30e9 / 2.4;
  dougong::testing::expect_relative("B03", "layout, 5 blocks a column", shearing.stiffness(),
                                    sway_stiffness(portal(5, 6)), 0.03);
  dougong::testing::expect_relative("B03", "layout, 12 blocks a column", shearing.stiffness(),
                                    sway_stiffness(portal(12, 20)), 0.02);
}

// Sway of a mass on two columns: the beam and its floor, the nodes and a third or so of the columns.
TEST(ConcreteFrame, HasThePeriodOfItsMassOnItsStiffness) {
  const Building building = build_layout(frame, {{"storeys", 1}, {"bays", 1}});
  double level = 0.0, columns = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i)
    (building.scene.bodies[i].name.find("column") == std::string::npos ? level : columns) +=
        mass_of(building, i);
  const Built built = weightless(building);
  const double mass = level + 0.35 * columns;  // between 13/35, clamped at both ends, and 33/140 at one
  dougong::testing::expect_relative("layout", "period of a one-storey frame",
                                    2.0 * std::numbers::pi * std::sqrt(mass / sway_stiffness(built)),
                                    built.first_period(), 0.02);
}

TEST(ConcreteFrame, CarriesItsFloors) {
  const Building building = build_layout(frame, {{"floor_load", 10e3}, {"frame_spacing", 4.0}});
  double mass = 0.0;
  for (std::size_t i = 0; i < building.scene.bodies.size(); ++i) mass += mass_of(building, i);
  const Building bare = build_layout(frame, {{"floor_load", 0.0}});
  double own = 0.0;
  for (std::size_t i = 0; i < bare.scene.bodies.size(); ++i) own += mass_of(bare, i);
  EXPECT_NEAR((mass - own) * engine::standard_gravity, 10e3 * 4.0 * 3 * 2 * (5.0 - 0.4), 1.0);
}

class FrameOptions : public ::testing::TestWithParam<std::pair<std::string, std::string>> {};

INSTANTIATE_TEST_SUITE_P(Words, FrameOptions,
                         ::testing::Values(std::pair{"weakness", "none"},
                                           std::pair{"weakness", "first-storey"},
                                           std::pair{"weakness", "columns"}, std::pair{"weakness", "beams"},
                                           std::pair{"infill", "all-storeys"},
                                           std::pair{"infill", "above-first"},
                                           std::pair{"bracing", "diagonal"}, std::pair{"bracing", "cross"},
                                           std::pair{"shear_wall", "one-bay"}));

TEST_P(FrameOptions, StandUnderTheirWeightWithoutYielding) {
  const auto& [parameter, chosen] = GetParam();
  Built built(frame, {{"storeys", 2}, {parameter, word(frame, parameter, chosen)}});
  expect_no_findings(built.building);
  expect_settles(built, 5e-3);
  for (const engine::BondHistory& history : built.state.bonds.history) EXPECT_EQ(history.plastic, 0.0);
}

// Each of them stiffens the frame; a soft first storey undoes most of what infill does.
TEST(ConcreteFrame, IsStiffenedByWhatFillsItsBays) {
  const auto period = [](const ParameterMap& values) {
    return weightless(build_layout(frame, values)).first_period();
  };
  const double bare = period({});
  const double infilled = period({{"infill", word(frame, "infill", "all-storeys")}});
  const double soft = period({{"infill", word(frame, "infill", "above-first")}});
  const double braced = period({{"bracing", word(frame, "bracing", "cross")}});
  const double walled = period({{"shear_wall", word(frame, "shear_wall", "one-bay")}});
  EXPECT_LT(infilled, 0.6 * bare);
  EXPECT_LT(soft, bare);
  EXPECT_GT(soft, 1.3 * infilled);
  EXPECT_LT(braced, 0.8 * bare);
  EXPECT_LT(walled, 0.5 * bare);
}

TEST(ConcreteFrame, YieldsWhereItsReinforcementSays) {
  const ParameterMap values{{"storeys", 1}, {"bays", 1}, {"column_reinforcement", 0.02}};
  const Building building = build_layout(frame, values);
  double yield = 0.0;
  for (const engine::Bond& bond : building.scene.bonds)
    if (bond.name.find("column") != std::string::npos) {
      EXPECT_DOUBLE_EQ(bond.yield_strength, 0.8 * 0.02 * 500e6) << bond.name;
      yield = bond.yield_strength;
    } else {
      EXPECT_DOUBLE_EQ(bond.yield_strength, 0.8 * 0.015 * 500e6) << bond.name;
    }
  EXPECT_GT(yield, 0.0);
  const ParameterMap weak{{"weakness", word(frame, "weakness", "columns")}, {"weakness_ratio", 0.5}};
  for (const engine::Bond& bond : build_layout(frame, weak).scene.bonds)
    if (bond.name.find("column") != std::string::npos) {
      EXPECT_DOUBLE_EQ(bond.yield_strength, 0.5 * 0.8 * 0.015 * 500e6) << bond.name;
    }
}

TEST(ConcreteFrame, RefusesWhatDoesNotFit) {
  EXPECT_THAT(refusal(frame, {{"bay_width", 0.4}}), HasSubstr("at least the column width"));
  EXPECT_THAT(refusal(frame, {{"beam_depth", 3.15}}), HasSubstr("storey_height"));
  EXPECT_THAT(refusal(frame, {{"first_storey_height", 0.3}}), HasSubstr("first_storey_height"));
  EXPECT_THAT(refusal(frame, {{"bays", 8}}), HasSubstr("ground_width"));
  EXPECT_THAT(refusal(frame, {{"shear_wall", 1.0}, {"bracing", 1.0}}), HasSubstr("beside a shear wall"));
}

}  // namespace
}  // namespace dougong::structures
