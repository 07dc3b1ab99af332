// record convert and record info as a person meets them, on files made here.
#include <fmt/format.h>

#include <cmath>

#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class RecordConvert : public ProgramTest {
 protected:
  // Time and two components at right angles, of peaks 2 and 1 m/s2.
  void write_pair(const std::string& name) const {
    std::string text = "time,N00E,N90E\n";
    for (int k = 0; k <= 200; ++k)
      text += fmt::format("{:.2f},{:.6f},{:.6f}\n", 0.01 * k, 2 * std::sin(0.1570796327 * k),
                          std::sin(0.1570796327 * k));
    write(name, text);
  }
  json info(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all{"record", "info", "--json"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ran ran = run(all);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out);
  }
  std::vector<std::string> convert(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"record", "convert", "pair.csv", "--units", "m/s2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(RecordConvert, WritesFilesThatTheProgramReadsBack) {
  write_pair("pair.csv");
  const std::pair<const char*, const char*> files[] = {{"at2", "out/at2-N00E.AT2"},
                                                       {"knet", "out/knet.NS"},
                                                       {"csmnc", "out/csmnc-N00E.dat"},
                                                       {"csv", "out/csv.csv"},
                                                       {"miniseed", "out/miniseed.mseed"}};
  for (const auto& [format, file] : files) {
    const Ran ran = run(convert({"--to", format, "--out", std::string("out/") + format}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(file));
    std::vector<std::string> asked{file};
    if (std::string(format) == "miniseed")
      asked.insert(asked.end(), {"--units", "m/s2", "--component", "HNN"});
    const json all = info(asked).at("components");
    const json& first = std::string(format) == "miniseed" ? all.at(1) : all.at(0);
    EXPECT_EQ(first.at("npts"), 201) << format;
    EXPECT_DOUBLE_EQ(first.at("dt_s"), 0.01) << format;
    EXPECT_NEAR(first.at("pga_m_s2"), 2.0, 2e-4) << format;
  }
}

TEST_F(RecordConvert, TurnsThePairAndScalesIt) {
  write_pair("pair.csv");
  const Ran ran =
      run(convert({"--to", "csv", "--out", "turned", "--azimuth", "90 deg", "--pga", "3 m/s2", "--json"}));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(json::parse(ran.out).at("written").at(0).at("components"), ElementsAre("90", "180"));
  const json components = info({"turned.csv"}).at("components");
  EXPECT_NEAR(components.at(0).at("pga_m_s2"), 3.0, 1e-9);
  EXPECT_NEAR(components.at(1).at("pga_m_s2"), 6.0, 1e-5);
  EXPECT_DOUBLE_EQ(components.at(1).at("azimuth_deg"), 180.0);
}

TEST_F(RecordConvert, WritesOnlyTheComponentAskedFor) {
  write_pair("pair.csv");
  ASSERT_EQ(run(convert({"--to", "at2", "--component", "90"})).exit_code, 0);
  EXPECT_TRUE(exists("pair-N90E.AT2"));
  EXPECT_FALSE(exists("pair-N00E.AT2"));
}

TEST_F(RecordConvert, TakesSeveralFilesForTheComponentsOfAStation) {
  write_pair("pair.csv");
  ASSERT_EQ(run(convert({"--to", "at2"})).exit_code, 0);
  const Ran ran =
      run({"record", "convert", "pair-N00E.AT2", "pair-N90E.AT2", "--to", "csv", "--out", "both"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json both = info({"both.csv"}).at("components");
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both.at(1).at("component"), "N90E");
  const json files = info({"pair-N00E.AT2", "pair-N90E.AT2", "--component", "90"}).at("components");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_TRUE(files.at(1).at("chosen").get<bool>());
}

TEST_F(RecordConvert, NeverWritesOverAFileUnlessToldTo) {
  write_pair("pair.csv");
  write("pair-N90E.AT2", "mine");
  expect_refusal(convert({"--to", "at2"}), {"pair-N90E.AT2", "a name that is free"});
  EXPECT_EQ(run(convert({"--to", "at2", "--force"})).exit_code, 0);
  EXPECT_NE(read("pair-N90E.AT2"), "mine");
}

TEST_F(RecordConvert, SaysWhatIsWrongWithItsOptions) {
  write_pair("pair.csv");
  expect_refusal(convert({"--to", "sac"}), {"--to", "at2, knet, csmnc, csv or miniseed", "sac"});
  expect_refusal(convert({"--to", "csv", "--azimuth", "45"}), {"--azimuth"});
  expect_refusal(convert({"--to", "csv", "--pga", "0 g"}), {"--pga"});
  expect_refusal(convert({"--to", "knet", "--azimuth", "45 deg"}), {"north, east and up"});
  expect_refusal({"record", "convert", "missing.AT2", "--to", "csv"}, {"missing.AT2", "no such file"});
  expect_refusal({"record", "convert", "pair.csv", "--to", "csv"}, {"option units", "--units gal"});
}

TEST_F(RecordConvert, InfoWritesARowAComponent) {
  EXPECT_EQ(run({"record", "info", "wenchuan", "--csv", "info.csv"}).exit_code, 0);
  const std::string csv = read("info.csv");
  EXPECT_THAT(csv, testing::StartsWith("component,axis,event,"));
  EXPECT_THAT(csv, testing::HasSubstr("\nUD,vertical,"));
  EXPECT_EQ(run({"record", "info", "wenchuan", "--csv", "info.csv"}).exit_code, 2)
      << "nothing is written over";
}

TEST_F(RecordConvert, InfoShowsEveryChannelAndWhichOneDrives) {
  write_pair("pair.csv");
  const json components = info({"pair.csv", "--units", "m/s2", "--component", "E-W"}).at("components");
  ASSERT_EQ(components.size(), 2u);
  EXPECT_FALSE(components.at(0).at("chosen").get<bool>());
  EXPECT_TRUE(components.at(1).at("chosen").get<bool>());
  EXPECT_DOUBLE_EQ(components.at(1).at("azimuth_deg"), 90.0);
  expect_refusal({"record", "info", "pair.csv", "--units", "m/s2", "--component", "45"},
                 {"expected component 45, found N00E, N90E"});
  expect_refusal({"record", "info", "pair.csv", "--units", "m/s2", "--member", "x"},
                 {"no archive", "--member NAME"});
}

}  // namespace
}  // namespace dougong::app
