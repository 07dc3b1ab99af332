// Comparisons C05 (single-degree systems) and C06 (five-storey frame) under the recording of El Centro 1940,
// and the five-storey frame against superposition of its modes under a synthetic motion.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/engine/reference.h"
#include "tests/oracles/synthetic_record.h"
#include "tests/scenes/el_centro.h"

namespace dougong {
namespace {

using scenes::five_percent, scenes::five_storeys;
using testing::expect_relative;

const std::filesystem::path recording =
    std::filesystem::path(DOUGONG_REAL_RECORDS) / "peer-at2" / "elCentro.AT2";

TEST(ElCentro, MovesSingleDegreeSystemsAsTheTableSays) {
  if (!std::filesystem::exists(recording)) GTEST_SKIP() << "recording not available: " << recording;
  const scenes::RecordedMotion motion = scenes::el_centro(recording, scenes::gravity_in_inches);
  for (const scenes::SingleDegreeCase& c : scenes::single_degree_cases) {
    const auto history =
        scenes::by_engine(c.level(), {c.ratio}, motion.acceleration, motion.interval, motion.interval);
    expect_relative("C05",
                    "T " + testing::text(c.period) + " s, " + testing::text(100 * c.ratio) + " %: peak (in)",
                    c.exact, scenes::peaks_of(history, c.level(), 1.0).roof / 0.0254, 3e-3);
  }
}

TEST(ElCentro, MovesAFiveStoreyFrameAsTheTableSays) {
  if (!std::filesystem::exists(recording)) GTEST_SKIP() << "recording not available: " << recording;
  const scenes::RecordedMotion motion = scenes::el_centro(recording, scenes::gravity_in_metres);
  const auto history =
      scenes::by_engine(five_storeys, five_percent, motion.acceleration, motion.interval, 0.002);
  const auto peaks = scenes::peaks_of(history, five_storeys, 4.0);
  expect_relative("C06", "roof displacement (cm)", 17.396, 100 * peaks.roof, 5e-3);
  expect_relative("C06", "base shear (kN)", 323.18, peaks.base_shear / 1e3, 5e-3);
  expect_relative("C06", "top-storey shear (kN)", 155.53, peaks.top_shear / 1e3, 5e-3);
  expect_relative("C06", "base moment (kN m)", 3814.5, peaks.base_moment / 1e3, 5e-3);
  for (std::size_t i = 0; i < 5; ++i)
    expect_relative("C06", "drift of storey " + std::to_string(i + 1) + " (mm)",
                    scenes::five_storey_drifts[i], 1e3 * peaks.drift[i], 5e-3);
}

// The whole history, at every output.
TEST(BondedFrame, FollowsTheSuperpositionOfItsModes) {
  const double interval = 0.01;
  const auto acceleration = oracles::SyntheticMotion(2008, 1.0).samples(interval);
  const auto exact = scenes::by_superposition(five_storeys, five_percent, acceleration, interval, 4),
             measured = scenes::by_engine(five_storeys, five_percent, acceleration, interval, interval);
  double worst = 0.0, greatest = 0.0;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < measured.displacement[i].size(); ++k) {
      const double reference = exact.displacement[i].at(4 * k);
      greatest = std::max(greatest, std::abs(reference));
      worst = std::max(worst, std::abs(measured.displacement[i][k] - reference));
    }
  testing::report("C06", "five bonded storeys against their modes, worst over greatest", 0.0,
                  worst / greatest, worst / greatest, 1e-3);
}

}  // namespace
}  // namespace dougong
