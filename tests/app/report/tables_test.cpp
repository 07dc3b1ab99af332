// summary.json against its schema, and the CSV files read back.
#include <gmock/gmock.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/report/axis.h"
#include "app/report/collapse_sequence.h"
#include "app/report/colour.h"
#include "app/report/csv.h"
#include "app/report/decimate.h"
#include "app/report/safe_file.h"
#include "app/report/screening_text.h"
#include "app/report/summary.h"
#include "app/report/text.h"
#include "app/study/floor_spectra.h"
#include "fixtures.h"

namespace dougong::app {
namespace {

using Json = nlohmann::json;

std::string type_name(const Json& value) {
  if (value.is_number_integer()) return "integer";
  return value.is_number() ? "number" : value.type_name();
}

bool has_type(const Json& value, const Json& types) {
  for (const Json& type : types.is_array() ? types : Json::array({types})) {
    if (type == type_name(value) || (type == "number" && value.is_number())) return true;
  }
  return false;
}

/// The part of JSON Schema the summary's schema uses; what is wrong, with its place.
void check(const Json& value, const Json& asked, const Json& root, const std::string& place,
           std::vector<std::string>& wrong) {
  const Json& schema = asked.contains("$ref")
                           ? root.at(Json::json_pointer(asked["$ref"].get<std::string>().substr(1)))
                           : asked;
  if (!has_type(value, schema.at("type"))) wrong.push_back(place + ": type " + type_name(value));
  if (schema.contains("const") && value != schema["const"]) wrong.push_back(place + ": not the constant");
  if (schema.contains("enum") && !std::count(schema["enum"].begin(), schema["enum"].end(), value))
    wrong.push_back(place + ": not in the list");
  if (value.is_object()) {
    for (const Json& key : schema.at("required")) {
      if (!value.contains(key)) wrong.push_back(place + ": lacks " + key.get<std::string>());
    }
    for (const auto& [key, part] : value.items()) {
      if (!schema.at("properties").contains(key))
        wrong.push_back(place + ": unexpected " + key);
      else
        check(part, schema["properties"][key], root, place + "/" + key, wrong);
    }
  }
  for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
    check(value[i], schema.at("items"), root, place + "/" + std::to_string(i), wrong);
}

Json schema() {
  return Json::parse(read_file(DOUGONG_SUMMARY_SCHEMA));
}

std::vector<std::string> violations(const Json& summary) {
  std::vector<std::string> wrong;
  check(summary, schema(), schema(), "", wrong);
  return wrong;
}

std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back(1);
    for (const char c : line) {
      if (c == ',')
        rows.back().emplace_back();
      else
        rows.back().back() += c;
    }
  }
  return rows;
}

double number(const std::string& text) {
  double value = NAN;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(DamageCsv, HasEveryBondWithItsStoreyAndTimes) {
  EXPECT_EQ(damage_csv(fixtures::repeated()),
            "bond,storey,mode,cracked (s),crushed (s),broken "
            "(s)\nbase,S1,tension,9.5,9.6,9.7\nhead,S1,shear,9.1,,\n"
            "sound,S2,,,,\n");
}

TEST(CollapseCsv, HasBondsSupportsAndStoreysInOrder) {
  RunResult run = fixtures::repeated();
  const auto rows = cells(collapse_sequence_csv(run));
  std::vector<std::string> order;
  for (std::size_t i = 1; i < rows.size(); ++i) order.push_back(rows[i][1] + " " + rows[i][2]);
  EXPECT_THAT(order, testing::ElementsAre("bond cracked head", "bond cracked base", "bond crushed base",
                                          "bond broke base", "support lost S1.column.left", "storey lost S1",
                                          "support lost S1.slab", "storey lost S2"));
  EXPECT_EQ(
      falls_csv(run),
      "block,storey,how,support lost (s),hardest hit (s),speed (m/s),energy (J)\n"
      "S1.column.left,S1,fell 1.30 m,11.2,12.1,5.5,39000\nS1.slab,S1,fell 1.50 m,11.4,12.2,6.1,101000\n");
}

TEST(CollapseCsv, MassLostIsThePartTimesTheStoreysMass) {
  const RunResult run = fixtures::collapsed();
  const auto rows = cells(mass_lost_csv(run));
  ASSERT_EQ(rows.size(), run.response.times.size() + 1);
  EXPECT_EQ(number(rows.back()[2]), 0.8);
  EXPECT_EQ(number(rows.back()[1]), 0.8 * run.response.storeys[0].original_mass);
  EXPECT_EQ(number(rows[1][1]), 0.0);
}

TEST(Screening, IsALineAStandard) {
  EXPECT_THAT(screening_lines(fixtures::repeated().screening),
              testing::ElementsAre("FEMA 356: 1 of 2 limits exceeded; farthest exceeded: LS (1/50, concrete "
                                   "frames); nearest kept: CP (1/25, concrete frames) at 0.75 of it"));
}

TEST(ScreeningCsv, HasEveryCheckWithItsSource) {
  const auto rows = cells(screening_csv(fixtures::repeated().screening));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(rows[1], testing::ElementsAre("FEMA 356", "Table C1-3", "concrete frames", "LS", "peak drift",
                                            "0.02", "0.03", "1", "2"));
}

TEST(Summary, TellsOfACollapseOnlyWhereThereWasOne) {
  EXPECT_FALSE(Json::parse(summary_json(fixtures::survived(), {})).contains("collapse"));
  const Json collapse = Json::parse(summary_json(fixtures::collapsed(), {}))["collapse"];
  EXPECT_EQ(collapse["mode"], "soft storey");
  EXPECT_EQ(collapse["footprint"]["left"]["reach"]["value"], 1.4);
  EXPECT_EQ(collapse["hardest_hit"]["time"], 12.2);
}

TEST(Summary, FollowsItsSchema) {
  for (const RunResult& run : {fixtures::survived(), fixtures::repeated(), fixtures::collapsed(),
                               fixtures::partial(), fixtures::motionless(), RunResult{}}) {
    EXPECT_THAT(violations(Json::parse(summary_json(run, {"drift.csv"}))), testing::IsEmpty());
  }
}

TEST(Summary, TheCheckSeesAMissingAndAnUnexpectedKey) {
  EXPECT_THAT(summary_json(fixtures::repeated(), {}), testing::HasSubstr("collapse_probability"));
  Json summary = Json::parse(summary_json(fixtures::survived(), {}));
  summary["metrics"].erase("weight");
  summary["surprise"] = 1;
  summary["partial"] = "no";
  EXPECT_EQ(violations(summary).size(), 3u);
}

TEST(Text, IsSetWithMinusSignsAndRaisedDigits) {
  EXPECT_EQ(typeset("-3.1 m/s2 (-1/161), 2400 kg/m3"), "−3.1 m/s² (−1/161), 2400 kg/m³");
  EXPECT_EQ(typeset("2-5 % of 1e-07, run-2, a/s2x, - 3"), "2-5 % of 1e-07, run-2, a/s2x, - 3");
}

TEST(Summary, TellsWhatTheJointsBearUnderTheWeight) {
  RunResult run = fixtures::survived();
  run.weight_joints[0].compression = std::numeric_limits<double>::infinity();  // at a corner
  const Json weight = Json::parse(summary_json(run, {}))["self_weight"];
  EXPECT_EQ(weight["joints"], run.weight_joints.size());
  EXPECT_EQ(weight["most_used"]["name"], run.weight_joints[0].name);
  EXPECT_EQ(weight["most_used"]["used"]["value"], run.weight_joints[0].used);
  EXPECT_EQ(weight["most_compressed"]["name"], run.weight_joints[1].name) << "the greatest that is one";
  EXPECT_THAT(violations(Json::parse(summary_json(run, {}))), testing::IsEmpty());
  run.weight_joints.clear();
  EXPECT_FALSE(Json::parse(summary_json(run, {})).contains("self_weight"));
}

TEST(Csv, OfAnEnsembleHasARowARunAndNothingAfterALoss) {
  const EnsembleSheet e = fixtures::repeated().ensemble;
  const auto runs = cells(ensemble_csv(e)), drift = cells(ensemble_roof_drift_csv(e));
  EXPECT_THAT(runs[0], testing::ElementsAre("run", "verdict", "peak drift (1)", "first loss of support (s)"));
  EXPECT_THAT(runs[1], testing::ElementsAre("as described", "collapsed", "0.031", "11.3"));
  EXPECT_EQ(runs[4][1], "not run to its end");
  EXPECT_EQ(runs.back()[0], "half the step");
  ASSERT_EQ(drift.size(), 101u);
  EXPECT_EQ(std::stod(drift[60][1]), e.members[0].roof_drift[59]);
  EXPECT_EQ(drift[61][1], "") << "a storey was lost";
  EXPECT_EQ(std::stod(drift[61][2]), e.members[1].roof_drift[60]);
}

TEST(Summary, MetricsKeepSignUnitAndTime) {
  const RunResult run = fixtures::collapsed();
  const Json s = Json::parse(summary_json(run, {}));
  const auto& peak = run.response.storeys[1].peak_drift.negative;
  EXPECT_EQ(s["metrics"]["storeys"][1]["peak_drift_ratio"]["negative"],
            (Json{{"value", peak.value}, {"unit", "1"}, {"time", peak.time}}));
  EXPECT_EQ(s["verdict"]["kind"], "collapsed");
  EXPECT_EQ(s["metrics"]["largest_drift_ratio"]["storey"], "S1");
  EXPECT_EQ(s["metrics"]["storeys"][3]["lost_at"], nullptr);
}

TEST(Csv, DriftReadsBackExactlyAndStopsAtTheLoss) {
  const RunResult run = fixtures::collapsed();
  const auto rows = cells(drift_csv(run));
  ASSERT_EQ(rows.size(), run.response.times.size() + 1);
  EXPECT_THAT(rows[0], testing::ElementsAre("time (s)", "S1 interstorey drift ratio (1)", "S1 lost",
                                            "S2 interstorey drift ratio (1)", "S2 lost",
                                            "S3 interstorey drift ratio (1)", "S3 lost",
                                            "S4 interstorey drift ratio (1)", "S4 lost"));
  for (std::size_t i = 0; i < run.response.times.size(); ++i) {
    const auto& row = rows[i + 1];
    ASSERT_EQ(number(row[0]), run.response.times[i]);
    const bool lost = run.response.times[i] >= 11.3;
    ASSERT_EQ(row[1].empty(), lost);
    ASSERT_EQ(row[2], lost ? "1" : "0");
    if (!lost) {
      ASSERT_EQ(number(row[1]), run.response.storeys[0].drift[i]);
    }
    ASSERT_EQ(number(row[7]), run.response.storeys[3].drift[i]);
  }
}

TEST(Csv, EveryTableHasItsHeaderAndRows) {
  const RunResult run = fixtures::survived();
  for (const std::string& csv : {drift_csv(run), acceleration_csv(run), roof_and_base_shear_csv(run),
                                 energy_csv(run), motion_csv(run)}) {
    const auto rows = cells(csv);
    EXPECT_GT(rows.size(), 1000u);
    for (const auto& row : rows) ASSERT_EQ(row.size(), rows[0].size());
  }
  EXPECT_EQ(cells(energy_csv({})).size(), 1u);
}

TEST(Csv, HoldsWhatTheProfilesTheSpectrumAndTheOverlapsAreDrawnFrom) {
  RunResult run = fixtures::survived();
  const auto storeys = cells(storeys_csv(run));
  ASSERT_EQ(storeys.size(), 1 + run.response.storeys.size());
  EXPECT_EQ(number(storeys[1][2]), run.response.storeys[0].peak_drift.positive.value);
  EXPECT_EQ(number(storeys[2][10]), run.response.storeys[1].peak_acceleration.positive.time);
  run.motion.spectrum_periods = {0.5, 1.0}, run.motion.spectrum_psa = {4.0, 2.0};
  const auto spectrum = cells(spectrum_csv(run.motion));
  EXPECT_NEAR(number(spectrum[2][2]), 2.0 / (4.0 * std::numbers::pi * std::numbers::pi), 1e-15)
      << "Sd = PSa (T / 2 pi)^2";
  const auto overlaps = cells(overlap_csv(run));
  EXPECT_EQ(number(overlaps[1][1]), run.numerics.overlap_ratio[0]);
  EXPECT_EQ(number(overlaps[1][2]), 1.2e-4);
}

TEST(Csv, FloorSpectraHaveTheGroundAndEveryFloor) {
  const RunResult run = fixtures::survived();
  const auto rows = cells(floor_spectra_csv(floor_spectra(run)));
  EXPECT_THAT(rows[0], testing::ElementsAre("period (s)", "ground PSa 5 % (m/s2)", "S1 PSa 5 % (m/s2)",
                                            "S2 PSa 5 % (m/s2)", "S3 PSa 5 % (m/s2)", "S4 PSa 5 % (m/s2)"));
  EXPECT_NEAR(number(rows[1][0]), 0.2, 1e-12);  // ten output intervals of 0.02 s
  EXPECT_NEAR(number(rows.back()[0]), 10.0, 1e-9);
}

TEST(Csv, BaseShearOverWeightIsTheirQuotient) {
  const RunResult run = fixtures::survived();
  const auto rows = cells(roof_and_base_shear_csv(run));
  EXPECT_EQ(number(rows[601][3]), run.response.base_shear[600] / run.response.weight);
}

TEST(Decimate, KeepsPeaksEndsAndOrder) {
  std::vector<double> x(20000), y(20000, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
  y[7777] = 5.0;
  y[7778] = -6.0;
  const Points p = decimated(x, y, 100);
  EXPECT_LE(p.x.size(), 202u);
  EXPECT_TRUE(std::is_sorted(p.x.begin(), p.x.end()));
  EXPECT_THAT(p.y, testing::IsSupersetOf({5.0, -6.0}));
  EXPECT_EQ(p.x.front(), 0.0);
  EXPECT_EQ(p.x.back(), 19999.0);
}

TEST(Colour, TextIsReadableOnWhiteAndViridisRuns) {
  EXPECT_EQ(readable(ink::black), ink::black);
  EXPECT_EQ(to_hex(from_hex("#d55e00")), "#d55e00");
  EXPECT_EQ(to_hex(viridis(0.0)), "#440154");
  EXPECT_EQ(to_hex(viridis(2.0)), "#fde725");
  for (std::size_t i = 0; i < 7; ++i) EXPECT_LE(category_ink(i).green, category(i).green);
  EXPECT_LT(category_ink(4).red, category(4).red);  // orange needs darkening
}

TEST(Axis, StepsAreRoundAndFit) {
  for (const double span : {0.0037, 0.158, 0.62, 1.0, 7.3, 29.99, 640.0}) {
    const double step = round_step(span, 5);
    EXPECT_NEAR(round_below(step), step, 1e-9 * step) << span;
    EXPECT_LE(span / step, 5.0) << span;
    EXPECT_GE(span / step, 1.9) << span;
  }
}

TEST(Text, PrintsWhatAReaderExpects) {
  EXPECT_EQ(drift_percent(0.0042), "+0.42 %");
  EXPECT_EQ(drift_percent(-0.0123), "−1.23 %");
  EXPECT_EQ(drift_fraction(-0.0042), "1/238");
  EXPECT_EQ(drift_fraction(0.528), "1/1.9");
  EXPECT_EQ(shortened("θθθθ", 4), "θθθθ");
  EXPECT_EQ(shortened("θθθθθ", 4), "θθθ…");
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(significant(3.2e-7, 2), "3.2 × 10⁻⁷");
  EXPECT_EQ(significant(0.35, 3), "0.350");
  EXPECT_EQ(significant(0.99999, 3), "1.00");
  EXPECT_EQ(significant(-9.996, 3), "−10.0");
  EXPECT_EQ(significant(0.009999, 2), "0.010");
  EXPECT_EQ(displacement(-0.0123), "−12.3 mm");
  EXPECT_EQ(acceleration_g(9.80665), "+1.000 g");
  EXPECT_EQ(fixed(NAN, 2), "n/a");
  EXPECT_EQ(escape_markup("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
}

}  // namespace
}  // namespace dougong::app
