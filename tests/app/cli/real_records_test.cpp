// Real recordings through the whole program. They are not part of the project (their owners forbid
// redistribution): the tests are skipped where they are absent.
#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;

struct Recording {
  std::string file;
  std::vector<std::string> info_flags, run_flags;
  std::size_t npts;
  double dt, pga;  // s, g without sign; the peak of a dimensionless shape is 1
  std::string component;
  bool dimensionless = false;
};

void PrintTo(const Recording& recording, std::ostream* out) {
  *out << recording.file;
}

// From the samples of the files, counted and measured by hand.
const Recording el_centro{"peer-at2/elCentro.AT2", {}, {}, 1559, 0.02, 0.318820, ""};
const Recording tohoku{
    "kiknet/TKYH121103111446.NS2", {}, {"--set", "vertical=true"}, 30000, 0.01, 0.160279, "NS2"};
const Recording wenchuan{"rec/EQWenchuan.rec", {}, {"--pga", "0.3 g"}, 19500, 0.01, 1.0, "", true};
const Recording duzce{"peer-at2/RSN1616_DUZCE_362-N.AT2", {}, {}, 4316, 0.01, 0.044148, ""};
const Recording northridge{
    "plain-text/Northridge.dat", {"--units", "g"}, {"--set", "units=g"}, 3989, 0.01, 0.568300, ""};

class RealRecord : public ProgramTest {
 protected:
  static std::string path_of(const Recording& recording) {
    return std::filesystem::weakly_canonical(std::filesystem::path(DOUGONG_REAL_RECORDS) / recording.file)
        .string();
  }
  json info(const Recording& recording) const {
    std::vector<std::string> arguments{"record", "info", path_of(recording), "--json"};
    arguments.insert(arguments.end(), recording.info_flags.begin(), recording.info_flags.end());
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out);
  }
};

#define SKIP_WITHOUT(recording)                     \
  if (!std::filesystem::exists(path_of(recording))) \
  GTEST_SKIP() << "recording not available: " << path_of(recording)

json chosen(const json& info) {
  for (const json& component : info.at("components"))
    if (component.at("chosen").get<bool>()) return component;
  return {};
}

class RealRecordInfo : public RealRecord, public testing::WithParamInterface<Recording> {};

TEST_P(RealRecordInfo, GivesSamplesIntervalAndPeakOfTheFile) {
  const Recording& recording = GetParam();
  SKIP_WITHOUT(recording);
  const json component = chosen(info(recording));
  EXPECT_EQ(component.at("npts"), recording.npts);
  EXPECT_DOUBLE_EQ(component.at("dt_s"), recording.dt);
  const double peak = component.at(recording.dimensionless ? "pga_m_s2" : "pga_g");
  EXPECT_NEAR(peak, recording.pga, 1e-6 * recording.pga + 5e-7);
  EXPECT_EQ(component.at("dimensionless"), recording.dimensionless);
  if (!recording.component.empty()) {
    EXPECT_EQ(component.at("component"), recording.component);
  }
}
INSTANTIATE_TEST_SUITE_P(Files, RealRecordInfo,
                         testing::Values(el_centro, tohoku, wenchuan, duzce, northridge));

TEST_F(RealRecord, ComponentsThatLieBesideEachOtherAreFoundTogether) {
  SKIP_WITHOUT(tohoku);
  const json components = info(tohoku).at("components");
  ASSERT_EQ(components.size(), 3u);
  std::map<std::string, double> peaks;
  for (const json& component : components) peaks[component.at("component")] = component.at("pga_g");
  EXPECT_NEAR(peaks.at("NS2"), 0.160279, 1e-6);
  EXPECT_NEAR(peaks.at("EW2"), 0.108002, 1e-6);
  EXPECT_NEAR(peaks.at("UD2"), 0.066749, 1e-6);
}

TEST_F(RealRecord, AShapeWithoutUnitAsksForItsPga) {
  SKIP_WITHOUT(wenchuan);
  expect_refusal(short_run("out", {"--record", path_of(wenchuan)}), {"target PGA", "--pga \"0.3 g\""});
}

using Case = std::tuple<Recording, std::string>;
class RealRun : public RealRecord, public testing::WithParamInterface<Case> {};

TEST_P(RealRun, HasAVerdictAndClosesItsEnergyBalance) {
  const auto& [recording, layout] = GetParam();
  SKIP_WITHOUT(recording);
  std::vector<std::string> more{"--layout", layout, "--record", path_of(recording), "--json"};
  more.insert(more.end(), recording.run_flags.begin(), recording.run_flags.end());
  const Ran ran = run(short_run("out", more), with_quick_plots());
  EXPECT_THAT(ran.exit_code, testing::AnyOf(0, 10, 30)) << ran.err;
  const json summary = json::parse(ran.out);
  EXPECT_NE(summary.at("verdict").at("kind"), "numerically invalid");
  EXPECT_LT(summary.at("energy").at("standing_error").at("value").get<double>(), 0.01);
  EXPECT_LT(summary.at("energy").at("relative_error").at("value").get<double>(), 0.002);
  EXPECT_LT(summary.at("energy").at("input_error").at("value").get<double>(), 0.01);
  EXPECT_TRUE(exists("out/report.html"));
}
INSTANTIATE_TEST_SUITE_P(Buildings, RealRun,
                         testing::Combine(testing::Values(el_centro, tohoku, wenchuan, duzce, northridge),
                                          testing::Values("four-storey", "four-storey-strong",
                                                          "brick-wall")));

}  // namespace
}  // namespace dougong::app
