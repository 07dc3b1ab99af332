// What a comparison will run: every variant on every record, the first variant as the reference.
//
//   base scenario + record + variant's overrides --> Case, a complete scenario with the folder of its results
//
// A variant may change the building and how it is computed, but nothing that pairs its runs with those of the
// reference: the motion, its conditioning, the ensemble and its seed are the base's.
#pragma once

#include "app/study/compare/variants.h"
#include "app/study/run_result.h"
#include "app/study/scenario.h"

namespace dougong::app {

struct ComparisonChoice {
  std::filesystem::path scenario;   // empty: the defaults
  std::vector<Override> overrides;  // of every run
  std::vector<Override> records;    // record.name or record.file, one each; empty: the base's own
  std::vector<Variant> variants;    // of the command line; those of the file are read
};

/// same_motion: the record as the base scales it. same_sa: scaled so that its PSa(T1, 5 %) of the variant is
/// that of the reference.
enum class View { same_motion, same_sa };
std::string to_string(View view);  // "same motion", "same Sa(T1)"

struct Case {
  std::size_t variant = 0, record = 0;
  View view = View::same_motion;
  double factor = 1.0;  // on the motion, for the view
  Scenario scenario;    // output.directory: the folder, from that of the comparison
};

struct ComparisonPlan {
  std::vector<std::string> variants;  // names
  std::vector<std::string> records;   // names
  std::vector<Case> cases;            // of the same motion, by variant, then by record
};

/// Reads every scenario. Throws ScenarioError with all that is wrong, and for fewer than two variants.
ComparisonPlan plan_comparison(const ComparisonChoice& choice);

/// What a variant is before the ground moves.
struct VariantSheet {
  std::string name;
  std::string title;    // what the building is
  double period = 0.0;  // s, small amplitudes; 0: none found
  double mass = 0.0;    // kg
  std::size_t blocks = 0, bonds = 0;
  double estimated_seconds = 0.0;  // of one run on the first record
};

/// Prepares every variant on the first record. Throws as prepare(), with the variant's name.
std::vector<VariantSheet> look_at_variants(const ComparisonPlan& plan, const std::filesystem::path& records);

/// Whether any first period is further than this from that of the reference.
inline constexpr double same_period = 0.05;
bool periods_differ(const std::vector<VariantSheet>& variants);

/// The cases of the second view. A variant whose factor is 1, as the reference's, has none: its runs of the
/// first view serve. Nor has one without a period, or when the reference has none.
std::vector<Case> cases_of_same_sa(const ComparisonPlan& plan, const std::vector<VariantSheet>& variants,
                                   const std::filesystem::path& records);

/// SHA-256 of all that a case's results follow from: its scenario, the bytes of record and building, and this
/// program.
std::string inputs_of(const Case& one, const std::filesystem::path& records);

}  // namespace dougong::app
