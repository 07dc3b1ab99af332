#include "tests/app/cli/program_test.h"

namespace dougong::app {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class Records : public ProgramTest {
 protected:
  json answer(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out);
  }
};

TEST_F(Records, AreThoseOfTheUsersFolderToo) {
  run({"record", "convert", "kobe", "--to", "at2", "--out", "mine/k"});
  run({"record", "convert", "elcentro", "--to", "csv", "--out", "mine/sub/e"});
  write("mine/notes.txt", "What was recorded.\n");
  const Ran ran = run({"records", "mine"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_THAT(ran.out, AllOf(HasSubstr("mine/k-EW.AT2"), HasSubstr("mine/sub/e.csv"),
                             HasSubstr("not read, 1 of"), HasSubstr("mine/notes.txt: no known format")));
  const json listed = answer({"records", "mine", "--periods", "0.3 s,1.5 s"});
  EXPECT_EQ(listed.at("records").size(), 6u);
  EXPECT_EQ(listed.at("unreadable").size(), 1u);
  for (const json& r : listed.at("records")) {
    EXPECT_GT(r.at("psa_m_s2_at_s").at("0.3").get<double>(), r.at("psa_m_s2_at_s").at("1.5").get<double>());
    EXPECT_EQ(r.at("dt_s"), 0.01);
  }
}

TEST_F(Records, AreSortedAndWrittenAsCsv) {
  const json by_pga = answer({"records", "--sort", "pga", "--csv", "r.csv", "-j", "2"}).at("records");
  ASSERT_EQ(by_pga.size(), 18u);
  for (std::size_t i = 1; i < by_pga.size(); ++i)
    EXPECT_GE(by_pga[i - 1].at("pga_m_s2").get<double>(), by_pga[i].at("pga_m_s2").get<double>());
  const std::string csv = read("r.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 19);
  EXPECT_THAT(csv, AllOf(HasSubstr("PSa at 0.5 s (m/s2)"), HasSubstr("\nkobe,")));
  const json near = answer({"records", "--near-period", "0.3 s"}).at("records");
  EXPECT_LT(std::abs(std::log(near.front().at("mean_period_s").get<double>() / 0.3)),
            std::abs(std::log(near.back().at("mean_period_s").get<double>() / 0.3)));
  EXPECT_TRUE(near.front().at("psa_m_s2_at_s").contains("0.3"));
}

TEST_F(Records, RefusesWhatItCannotList) {
  expect_refusal({"records", "nowhere"}, {"nowhere", "a folder of recordings"});
  write("r.csv", "mine");
  expect_refusal({"records", "--csv", "r.csv"}, {"r.csv", "exists", "--force"});
  expect_refusal({"records", "--sort", "size"}, {"--sort", "pga", "found \"size\""});
  expect_refusal({"records", "--near-period", "0.5"}, {"--near-period", "bare number"});
  write("words/notes.txt", "no numbers\n");
  expect_refusal({"records", "words"}, {"words", "a folder with recordings", "notes.txt"});
}

}  // namespace
}  // namespace dougong::app
