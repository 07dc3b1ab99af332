// Comparison C09: a block under a sinusoidal force, Potra, Anitescu, Gavrea and Trinkle, Int. J. Numer. Meth.
// Engng 66 (2006) 1079-1124. docs/comparisons/c09-stick-slip.md.
#include "tests/scenes/stick_slip.h"

#include <gtest/gtest.h>

#include "tests/engine/reference.h"

namespace dougong::engine {
namespace {

using scenes::StickSlip;
using testing::expect_absolute;
using testing::expect_relative;
using testing::text;

constexpr double place_tolerance = 0.005, time_tolerance = 1e-3;  // -, s

/// Greatest movement between the end of one slip and the start of the next.
double creep(const scenes::StickSlipHistory& h) {
  double greatest = 0.0;
  for (std::size_t i = 0; i + 1 < h.slips.size(); ++i)
    greatest = std::max(greatest, std::abs(h.slips[i + 1].from - h.slips[i].to));
  return greatest;
}

void check(const StickSlip& c) {
  const oracles::HarmonicSlider exact = c.exact();
  const scenes::StickSlipHistory h = scenes::measured(c);
  ASSERT_EQ(h.slips.size(), exact.slips().size());
  for (std::size_t i = 0; i < h.slips.size(); ++i) {
    const oracles::Slip& reference = exact.slips()[i];
    const scenes::MeasuredSlip& slip = h.slips[i];
    const std::string name = "m=" + text(c.mass) + " slip " + std::to_string(i + 1) + " ";
    EXPECT_EQ(slip.sense, reference.sense) << name;
    expect_absolute("C09", name + "starts", reference.start, slip.start, time_tolerance);
    expect_absolute("C09", name + "stops", reference.end, slip.end, time_tolerance);
    expect_relative("C09", name + "ends at", exact.displacement(reference.end), slip.to, place_tolerance);
    expect_relative("C09", name + "peak speed", exact.peak_speed(reference), slip.peak_speed,
                    place_tolerance);
  }
  expect_absolute("C09", "m=" + text(c.mass) + " creep while it sticks", 0.0, creep(h), 1e-6);
}

const StickSlip published{1.0, 0.8, 8.0, 1.0};

// The closed form as tabulated, digit by digit.
TEST(StickSlip, HasTheClosedFormOfTheTable) {
  const oracles::HarmonicSlider exact = published.exact();
  const struct {
    double start, end, to;  // s, s, m
  } table[] = {{0.0, 0.338608, 4.34857e-3},
               {2.946347, 3.532835, -8.69717e-3},
               {6.087939, 6.674427, 4.34857e-3},
               {9.229532, 9.816020, -8.69717e-3}};
  ASSERT_EQ(exact.slips().size(), std::size(table));
  for (std::size_t i = 0; i < std::size(table); ++i) {
    EXPECT_NEAR(exact.slips()[i].start, table[i].start, 1e-6);
    EXPECT_NEAR(exact.slips()[i].end, table[i].end, 1e-6);
    EXPECT_NEAR(exact.displacement(table[i].end), table[i].to, 1e-8);
  }
  EXPECT_NEAR(exact.peak_speed(exact.slips()[0]), 0.0197723, 1e-7);
  EXPECT_NEAR(exact.peak_speed(exact.slips()[1]), 0.0395447, 1e-7);
}

TEST(StickSlip, IsThatOfThePublishedBlock) {
  StickSlip three_slips = published;
  three_slips.until = 7.0;
  check(three_slips);
}
TEST(StickSlip, IsTheClosedFormForAnotherBlockToo) {
  StickSlip other{3.0, 0.35, 12.0, 2.5};
  other.until = 4.5;
  check(other);
}

}  // namespace
}  // namespace dougong::engine
