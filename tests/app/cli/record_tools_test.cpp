// The commands of `dougong record` that measure, condition, draw, scale, turn and make motions.
#include <cmath>

#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class RecordTools : public ProgramTest {
 protected:
  json answer(Words words) const {
    words.push_back("--json");
    const Ran ran = run(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out);
  }
};

// --- spectrum -----------------------------------------------------------------------------------------

TEST_F(RecordTools, SpectrumGivesTheOrdinatesOfAnOscillatorAtItsPeriods) {
  const json columns = answer({"record", "spectrum", "kobe", "--periods", "0.5 s,1 s"}).at("columns");
  ASSERT_EQ(columns.at("period_s"), (json{0.5, 1.0}));
  const double sd = columns.at("sd_m")[0], psa = columns.at("psa_m_s2")[0], w = 4.0 * M_PI;
  EXPECT_NEAR(psa / (w * w * sd), 1.0, 1e-12);
  EXPECT_GT(columns.at("sa_m_s2")[0].get<double>(), psa);
  const json more =
      answer({"record", "spectrum", "kobe", "--periods", "0.5 s", "--damping", "20 %"}).at("columns");
  EXPECT_LT(more.at("psa_m_s2")[0].get<double>(), psa);
}

TEST_F(RecordTools, SpectrumFindsHigherPeaksWithinTheSteps) {
  const auto psa = [&](const char* peaks) {
    return answer({"record", "spectrum", "kobe", "--periods", "0.03 s", "--peaks", peaks})
        .at("columns")
        .at("psa_m_s2")[0]
        .get<double>();
  };
  EXPECT_GT(psa("continuous"), psa("samples"));
}

TEST_F(RecordTools, SpectrumWritesItsTableAndOrdersTheAngles) {
  const json c =
      answer({"record", "spectrum", "tohoku", "--rotated", "--count", "7", "--csv", "s.csv"}).at("columns");
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_LE(c.at("rotd00_m_s2")[i].get<double>(), c.at("rotd50_m_s2")[i].get<double>());
    EXPECT_LE(c.at("rotd50_m_s2")[i].get<double>(), c.at("rotd100_m_s2")[i].get<double>());
  }
  EXPECT_THAT(read("s.csv"), testing::StartsWith("period_s,rotd00_m_s2,rotd50_m_s2,rotd100_m_s2"));
  expect_refusal({"record", "spectrum", "tohoku", "--csv", "s.csv"}, {"s.csv", "exists", "--force"});
}

TEST_F(RecordTools, SpectrumOfConstantDuctilityMeetsIt) {
  const json c =
      answer({"record", "spectrum", "kobe", "--ductility", "3", "--periods", "0.4 s"}).at("columns");
  EXPECT_NEAR(c.at("ductility")[0].get<double>(), 3.0, 1e-6);
  EXPECT_GT(c.at("strength_reduction")[0].get<double>(), 1.2);
}

TEST_F(RecordTools, SpectrumRefusesWhatIsNoPeriodOrDamping) {
  expect_refusal({"record", "spectrum", "kobe", "--periods", "0.1"}, {"--periods 0.1", "bare number"});
  expect_refusal({"record", "spectrum", "kobe", "--from", "1 s", "--to", "0.5 s"}, {"--to", "above --from"});
  expect_refusal({"record", "spectrum", "kobe", "--damping", "5"}, {"--damping 5", "0 to 1"});
  expect_refusal({"record", "spectrum", "kobe", "--ductility", "0.5"}, {"--ductility 0.5", "1 or more"});
  expect_refusal({"record", "spectrum", "kobe", "--peaks", "exact"}, {"--peaks"});
}

// --- measure ------------------------------------------------------------------------------------------

TEST_F(RecordTools, MeasureTellsOfComponentsPairAndStation) {
  const json groups = answer({"record", "measure", "tohoku", "--period", "0.5 s"}).at("groups");
  ASSERT_EQ(groups.size(), 5u);
  EXPECT_EQ(groups[3].at("of"), "horizontal pair");
  EXPECT_EQ(groups[4].at("measures")[0].at("name"), "JMA");
  EXPECT_EQ(groups[0].at("measures").back().at("name"), "Sa average");
}

// --- process ------------------------------------------------------------------------------------------

TEST_F(RecordTools, ProcessSaysEveryStepAndItsMotionReadsBack) {
  const json p =
      answer({"record", "process", "wenchuan", "--set", "filter=false", "--set", "end=at-rest", "--set",
              "baseline=velocity-polynomial", "--set", "baseline_degree=4", "--out", "w.at2"});
  EXPECT_NEAR(p.at("residual_displacement_m").get<double>(), 0.0, 1e-9);
  EXPECT_THAT(p.at("processing").dump(), AllOf(HasSubstr("degree 4"), HasSubstr("rest: EW ended at")));
  EXPECT_EQ(p.at("stages")[0].at("step"), "read");
  const json back = answer({"record", "info", "w.at2"}).at("components")[0];
  EXPECT_EQ(back.at("npts"), p.at("npts"));
  EXPECT_NEAR(back.at("pga_m_s2").get<double>(), p.at("stages").back().at("pga_m_s2").get<double>(), 1e-6);
  EXPECT_TRUE(back.at("synthetic").get<bool>());
}

TEST_F(RecordTools, ProcessWarnsOfABuildingThatTheRecordDoesNotSuit) {
  EXPECT_THAT(answer({"record", "process", "wenchuan", "--period", "0.05 s"}).at("warnings").dump(),
              HasSubstr("too coarse for a building"));
  EXPECT_THAT(answer({"record", "process", "wenchuan", "--period", "12 s"}).at("warnings").dump(),
              HasSubstr("high-pass corner"));
}

// --- plot ---------------------------------------------------------------------------------------------

TEST_F(RecordTools, MeasuresAndSheetsAreForProgramsToo) {
  const json groups = answer({"record", "measure", "kobe", "--csv", "m.csv"}).at("groups");
  EXPECT_THAT(read("m.csv"), AllOf(HasSubstr("of,measure,value,unit,meaning\n"), HasSubstr(",PGA,"),
                                   HasSubstr("/ EW,D5-95,")));
  expect_refusal({"record", "measure", "kobe", "--csv", "m.csv"}, {"m.csv", "exists"});
  const json sheet = answer({"record", "plot", "kobe", "--out", "sheet.svg"});
  EXPECT_EQ(sheet.at("picture"), "sheet.svg");
  EXPECT_NEAR(std::abs(sheet.at("acceleration_m_s2").at("value").get<double>()),
              groups[0].at("measures")[0].at("value").get<double>(), 1e-5);
}

TEST_F(RecordTools, PlotDrawsOneSheetAndWritesTheHistories) {
  const Ran ran = run({"record", "plot", "kobe", "--out", "k.svg", "--csv", "k.csv"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(read("k.svg"), AllOf(HasSubstr("Kobe-style"), HasSubstr("SYNTHETIC"), HasSubstr("Husid"),
                                   HasSubstr("PSa, 5 %"), HasSubstr("Fourier amplitude")));
  EXPECT_THAT(read("k.csv"),
              testing::StartsWith("time_s,acceleration_m_s2,velocity_m_s,displacement_m,husid"));
  expect_refusal({"record", "plot", "kobe", "--out", "k.svg"}, {"k.svg", "exists"});
  expect_refusal({"record", "plot", "kobe", "--out", "k.jpg"}, {".png or .svg"});
}

TEST_F(RecordTools, ProcessScaleAndSpectrumDrawTheirs) {
  EXPECT_EQ(run({"record", "process", "wenchuan", "--plot", "p.svg"}).exit_code, 0);
  EXPECT_THAT(read("p.svg"), AllOf(HasSubstr("Before and after conditioning"), HasSubstr("as read")));
  EXPECT_EQ(run({"record", "scale", "kobe", "tohoku", "--target", "jra: type=2, ground=2", "--plot", "s.svg"})
                .exit_code,
            0);
  EXPECT_THAT(read("s.svg"), AllOf(HasSubstr("JRA 2017"), HasSubstr("mean of 2"), HasSubstr("target")));
  EXPECT_EQ(run({"record", "spectrum", "kobe", "--rotated", "--count", "20", "--plot", "r.svg"}).exit_code,
            0);
  EXPECT_THAT(read("r.svg"), AllOf(HasSubstr("RotD50"), HasSubstr("RotD100")));
}

TEST_F(RecordTools, OfARecordOfZerosAreZeroAndNeverFail) {
  std::string zeros = "time,a\n";
  for (int k = 0; k < 400; ++k) zeros += std::to_string(0.01 * k) + ",0\n";
  write("z.csv", zeros);
  const json groups = answer({"record", "measure", "z.csv", "--units", "g", "--period", "1 s"}).at("groups");
  for (const json& m : groups[0].at("measures")) EXPECT_EQ(m.at("value").get<double>(), 0.0) << m.at("name");
  EXPECT_EQ(run({"record", "plot", "z.csv", "--units", "g", "--out", "z.png"}).exit_code, 0);
  EXPECT_EQ(answer({"record", "spectrum", "z.csv", "--units", "g", "--ductility", "4", "--periods", "1 s"})
                .at("columns")
                .at("yield_acceleration_m_s2")[0],
            0.0);
  expect_refusal({"record", "scale", "z.csv", "--units", "g", "--pga", "1 g"}, {"zero", "cannot be scaled"});
}

// --- scale --------------------------------------------------------------------------------------------

TEST_F(RecordTools, ScaleMeetsAPgaAnOrdinateAndAFloor) {
  const json pga = answer({"record", "scale", "kobe", "--pga", "2 m/s2"});
  const json ordinate = answer({"record", "scale", "kobe", "--sa", "5 m/s2", "--period", "1 s"});
  const json spectrum = answer({"record", "spectrum", "kobe", "--periods", "1 s"});
  EXPECT_NEAR(ordinate.at("records")[0].at("factor").get<double>() *
                  spectrum.at("columns").at("psa_m_s2")[0].get<double>(),
              5.0, 1e-9);
  EXPECT_NEAR(pga.at("mean_m_s2")[0].get<double>(), 2.0, 1e-12);
  const json suite = answer({"record", "scale", "wenchuan", "tohoku", "kobe", "--target",
                             "ec8: type=1, ground=C, ag=0.25 g", "--floor", "0.9"});
  EXPECT_NEAR(suite.at("least_ratio").get<double>(), 0.9, 1e-9);
  EXPECT_EQ(suite.at("records").size(), 3u);
  EXPECT_GT(suite.at("mean_misfit").get<double>(), 0.0);
}

TEST_F(RecordTools, ScaleTakesATableOfTheUsers) {
  write("target.csv", "period,psa\n0.1,0.8\n1,0.4\n3,0.1\n");
  const json s = answer({"record", "scale", "kobe", "--target", "table: file=target.csv, unit=g", "--rule",
                         "never-below", "--count", "5"});
  EXPECT_NEAR(s.at("least_ratio").get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(s.at("target_m_s2")[0].get<double>(), 9.80665 * (0.8 - 0.4 * 0.1 / 0.9), 1e-9);
  write("bad.csv", "0.1,0.8\n1,oops\n");
  expect_refusal({"record", "scale", "kobe", "--target", "table: file=bad.csv, unit=g"},
                 {"bad.csv:2", "oops"});
}

TEST_F(RecordTools, ScaleRefusesTargetsThatThereAreNot) {
  expect_refusal({"record", "scale", "kobe"}, {"one of --target, --pga and --sa"});
  expect_refusal({"record", "scale", "kobe", "--target", "ec9: a=1"}, {"found \"ec9\"", "gb50011"});
  expect_refusal({"record", "scale", "kobe", "--target", "ec8: type=1, ground=C, ag=0.2"},
                 {"ag", "bare number"});
  expect_refusal({"record", "scale", "kobe", "--target", "ec8: type=1, ground=C, ag=0.2 g, soil=1"},
                 {"unknown key \"soil\""});
  expect_refusal({"record", "scale", "kobe", "--target", "ec8: type=1, ground=C, ag=0.2 g", "--to", "9 s"},
                 {"0 s to 4 s"});
}

// --- rotate -------------------------------------------------------------------------------------------

TEST_F(RecordTools, RotateToNorthIsTheNorthComponent) {
  const json north = answer({"record", "rotate", "tohoku", "--azimuth", "0 deg", "--out", "n.csv"});
  const json info = answer({"record", "measure", "tohoku"});  // EW, NS, UD
  EXPECT_NEAR(north.at("pga_m_s2").get<double>(),
              info.at("groups")[1].at("measures")[0].at("value").get<double>(), 1e-3);
  EXPECT_TRUE(exists("n.csv"));
  const json largest = answer({"record", "rotate", "tohoku", "--largest"});
  EXPECT_NEAR(largest.at("pga_m_s2").get<double>(), largest.at("rotd100_pga_m_s2").get<double>(), 1e-9);
  expect_refusal({"record", "rotate", "tohoku"}, {"one of --azimuth, --angle and --largest"});
  expect_refusal({"record", "rotate", "tohoku", "--azimuth", "30"}, {"bare number"});
}

// --- make ---------------------------------------------------------------------------------------------

TEST_F(RecordTools, MakeListsItsKindsAndMakesEachOfThem) {
  EXPECT_THAT(run({"record", "make"}).out, AllOf(HasSubstr("ricker"), HasSubstr("finite-fault")));
  const std::vector<Words> kinds = {
      {"sine", "--set", "peak=0.3 g", "--set", "frequency=2 Hz"},
      {"cosine", "--set", "peak=0.3 g", "--set", "frequency=2 Hz", "--set", "cycles=3"},
      {"ricker", "--set", "peak=0.3 g", "--set", "frequency=2 Hz", "--set", "lead=1 s"},
      {"near-fault", "--set", "velocity=1 m/s", "--set", "frequency=0.5 Hz"},
      {"harmonic", "--set", "peak=0.1 g", "--set", "frequency=1 Hz", "--set", "ramp=2 s"},
      {"sweep", "--set", "peak=0.1 g", "--set", "from=1 Hz", "--set", "to=9 Hz"},
      {"noise", "--set", "deviation=0.1 g"},
      {"compatible", "--set", "target=asce7: sds=1 g; sd1=0.6 g; tl=8 s", "--set", "rounds=5"},
      {"styled", "--set", "name=kobe", "--set", "seed=7", "--set", "component=UD"},
      {"point-source", "--set", "magnitude=6", "--set", "distance=20 km"},
      {"finite-fault", "--set", "magnitude=6.5", "--set", "site-east=10 km", "--set", "site-north=5 km"},
  };
  for (const Words& kind : kinds) {
    Words words{"record", "make"};
    words.insert(words.end(), kind.begin(), kind.end());
    words.insert(words.end(), {"--out", kind[0] + ".at2"});
    const json made = answer(words);
    const json back = answer({"record", "info", kind[0] + ".at2"}).at("components")[0];
    EXPECT_EQ(back.at("npts"), made.at("npts")) << kind[0];
    EXPECT_TRUE(back.at("synthetic").get<bool>()) << kind[0];
    EXPECT_NEAR(back.at("pga_m_s2").get<double>(), made.at("pga_m_s2").get<double>(), 1e-5) << kind[0];
  }
}

TEST_F(RecordTools, MakeGivesTheSameFileForASeed) {
  const auto make = [&](const char* out, const char* seed) {
    return run({"record", "make", "finite-fault", "--set", "magnitude=6.5", "--set", "site-east=10 km",
                "--set", "site-north=5 km", "--set", seed, "--out", out})
        .exit_code;
  };
  ASSERT_EQ(make("a.csv", "seed=3") + make("b.csv", "seed=3") + make("c.csv", "seed=4"), 0);
  EXPECT_EQ(read("a.csv"), read("b.csv"));
  EXPECT_NE(read("a.csv"), read("c.csv"));
}

TEST_F(RecordTools, MakeRefusesWhatItCannotMake) {
  expect_refusal({"record", "make", "ricker", "--out", "r.at2"}, {"expected the key peak"});
  expect_refusal({"record", "make", "rickr", "--out", "r.at2"}, {"expected one of sine"});
  expect_refusal({"record", "make", "noise", "--set", "deviation=0.1 g"}, {"expected a file to write"});
  expect_refusal({"record", "make", "noise", "--set", "deviation=0.1 g", "--set", "sed=3", "--out", "r.at2"},
                 {"unknown key \"sed\""});
  expect_refusal(
      {"record", "make", "sine", "--set", "peak=1 g", "--set", "frequency=80 Hz", "--out", "r.at2"},
      {"Nyquist"});
  expect_refusal(
      {"record", "make", "noise", "--set", "deviation=1 g", "--set", "interval=0.00333 s", "--out", "r.at2"},
      {"0.1 ms", ".csv"});
}

}  // namespace
}  // namespace dougong::app
