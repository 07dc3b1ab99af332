// Comparisons C07 (Newmark's examples), C08 (seven-storey steel frame) and M03 (laboratory frame with a
// damping ratio for every mode).
#include <gtest/gtest.h>

#include <cmath>

#include "engine/modes.h"
#include "tests/engine/reference.h"
#include "tests/scenes/laboratory_frame.h"
#include "tests/scenes/newmark_example.h"
#include "tests/scenes/running.h"
#include "tests/scenes/steel_frame_response.h"

namespace dougong::engine {
namespace {

using scenes::Running;
using testing::expect_relative;

// --- C07

void check_newmark(const std::string& name, const scenes::NewmarkExample& example,
                   const std::vector<double>& published, const std::string& integrator,
                   double step_fraction) {
  const std::vector<double> found = example.displacements(integrator, step_fraction, 10);
  ASSERT_EQ(found.size(), published.size() + 1);
  double worst = 0.0;
  for (std::size_t k = 0; k < published.size(); ++k)
    worst = std::max(worst, std::abs(found[k + 1] - published[k]));
  testing::report("C07", name + ", " + integrator + ": worst of ten (in)", 0.0, worst, worst, 3e-4);
}

TEST(NewmarkExamples, AreReachedByEveryIntegrator) {
  for (const char* integrator : {"velocity-verlet", "leapfrog", "rk4"}) {
    check_newmark("linear", {}, scenes::newmark_linear, integrator, 0.5);
    check_newmark("elastoplastic", {0.75}, scenes::newmark_plastic, integrator, 0.2);
  }
}

// --- C08

TEST(SteelFrame, HasThePublishedPeriods) {
  const std::vector<double> periods = scenes::periods_of(scenes::SteelFrame(12));
  const double published[] = {1.2732, 0.4313, 0.2420, 0.1602, 0.1190, 0.0951, 0.0795};
  ASSERT_EQ(periods.size(), std::size(published));
  for (std::size_t i = 0; i < std::size(published); ++i)
    expect_relative("C08", "period " + std::to_string(i + 1) + " (s)", published[i], periods[i], 0.02);
}

TEST(SteelFrame, SwaysAsPublished) {
  const scenes::Sway sway = scenes::sway_of(scenes::SteelFrame(12));
  expect_relative("C08", "roof displacement (in)", 1.45076, sway.roof, 0.02);
  expect_relative("C08", "axial force of the left column (kip)", 69.99, sway.axial, 0.02);
  expect_relative("C08", "moment at its foot (kip in)", 2324.68, sway.moment, 0.02);
}

// --- M03

TEST(LaboratoryFrame, HasTheMeasuredFrequenciesAndModes) {
  const Running r(scenes::shear_building_scene(scenes::laboratory_levels(), nullptr));
  const auto modes = horizontal_modes(r.model, r.state, 3);
  ASSERT_EQ(modes.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    const scenes::PublishedMode& published = scenes::laboratory_modes[j];
    const std::string mode = "mode " + std::to_string(j + 1);
    expect_relative("M03", mode + " (rad/s)", published.frequency,
                    std::sqrt(modes[j].angular_frequency_squared), 1e-3);
    const double sign = modes[j].shape[0] < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 3; ++i)
      testing::expect_absolute("M03", mode + ", floor " + std::to_string(i + 1), published.shape[i],
                               sign * modes[j].shape[i], 0.01 * 0.5451);
  }
}

TEST(LaboratoryFrame, DecaysWithTheMeasuredRatioOfEveryMode) {
  for (std::size_t j = 0; j < 3; ++j)
    expect_relative("M03", "damping ratio of mode " + std::to_string(j + 1),
                    scenes::laboratory_modes[j].ratio, scenes::decay_of_mode(j).ratio, 0.01);
}

}  // namespace
}  // namespace dougong::engine
