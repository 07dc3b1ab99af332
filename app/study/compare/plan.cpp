#include "app/study/compare/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/study/entries.h"
#include "app/study/motion_input.h"
#include "app/study/prepare.h"
#include "app/study/scenario_keys.h"
#include "app/study/version.h"
#include "seismic/formats/file_text.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

/// Messages of many scenarios, each said once.
class Errors {
 public:
  void add(const ScenarioError& error) {
    for (const LocatedMessage& message : error.messages()) add(message);
  }
  void add(const LocatedMessage& message) {
    if (said_.insert(message.text()).second) messages_.push_back(message);
  }
  void throw_any() {
    if (!messages_.empty()) throw ScenarioError(std::move(messages_));
  }

 private:
  std::set<std::string> said_;
  std::vector<LocatedMessage> messages_;
};

Scenario scenario_of(const ComparisonChoice& choice, const std::vector<Override>& more) {
  std::vector<Override> all = choice.overrides;
  all.insert(all.end(), more.begin(), more.end());
  return choice.scenario.empty() ? scenario_from(all)
                                 : load_scenario(choice.scenario, all, RecordRule::required, {"variant"});
}

// A record in place of the base's: file and name exclude each other.
std::vector<Override> with_record(const ComparisonChoice& choice, std::size_t record) {
  if (choice.records.empty()) return {};
  return {choice.records[record]};
}

std::string record_label(const RecordChoice& record) {
  return record.file.empty() ? record.name : fs::path(record.file).stem().string();
}

bool is_paired(const std::string& section) {
  return section == "record" || section == "conditioning" || section == "ensemble" || section == "output";
}

// What the variant sets and must not.
void refuse_other_motion(const Scenario& base, const Scenario& other, const Variant& variant,
                         Errors& errors) {
  for (const ScenarioKey& key : scenario_keys()) {
    if (!is_paired(key.section()) || toml_value(key, base) == toml_value(key, other)) continue;
    errors.add({fmt::format("variant \"{}\"", variant.name),
                fmt::format("{}: runs are compared on the same motion with the same small changes; set it "
                            "for all of them, or give another --record",
                            key.name)});
  }
}

std::vector<Variant> all_variants(const ComparisonChoice& choice) {
  const std::vector<Variant> named =
      choice.scenario.empty() ? std::vector<Variant>{} : variants_of_file(choice.scenario);
  std::vector<Variant> all = crossed(named, choice.variants);
  Errors errors;
  if (all.size() < 2)
    errors.add({choice.scenario.empty() ? "command line" : choice.scenario.string(),
                fmt::format("expected at least two variants, found {}: give --vary \"key = value, value\" or "
                            "tables [[variant]]",
                            all.size())});
  std::set<std::string> names;
  for (const Variant& variant : all)
    if (!names.insert(variant.name).second)
      errors.add({fmt::format("variant \"{}\"", variant.name), "there are two of this name"});
  errors.throw_any();
  return all;
}

std::string folder_of(const std::string& variant, const std::string& record, View view) {
  return (fs::path(variant) / (record + (view == View::same_sa ? ".same-sa" : ""))).string();
}

class Planner {
 public:
  explicit Planner(const ComparisonChoice& choice) : choice_(choice), variants_(all_variants(choice)) {}

  ComparisonPlan plan() {
    const std::size_t records = std::max<std::size_t>(choice_.records.size(), 1);
    for (std::size_t r = 0; r < records; ++r) attempt([&] { add_record(r); });
    errors_.throw_any();
    plan_.records = told_apart(plan_.records);
    for (const Variant& variant : variants_) plan_.variants.push_back(variant.name);
    const auto variant_folders = folders_of(plan_.variants), record_folders = folders_of(plan_.records);
    for (std::size_t v = 0; v < variants_.size(); ++v)
      for (std::size_t r = 0; r < records; ++r)
        attempt([&] { add_case(v, r, folder_of(variant_folders[v], record_folders[r], View::same_motion)); });
    errors_.throw_any();
    return plan_;
  }

 private:
  template <class Step>
  void attempt(Step step) {
    try {
      step();
    } catch (const ScenarioError& error) {
      errors_.add(error);
    }
  }

  void add_record(std::size_t record) {
    bases_.push_back(scenario_of(choice_, with_record(choice_, record)));
    plan_.records.push_back(record_label(bases_.back().record));
  }

  void add_case(std::size_t variant, std::size_t record, const std::string& folder) {
    std::vector<Override> changes = with_record(choice_, record);
    const std::vector<Override>& own = variants_[variant].overrides;
    changes.insert(changes.end(), own.begin(), own.end());
    Case one{variant, record, View::same_motion, 1.0, scenario_of(choice_, changes)};
    refuse_other_motion(bases_[record], one.scenario, variants_[variant], errors_);
    one.scenario.output.directory = folder;
    plan_.cases.push_back(std::move(one));
  }

  static std::vector<std::string> folders_of(std::vector<std::string> names) {
    for (std::string& name : names) name = folder_name(name);
    return told_apart(std::move(names));
  }

  const ComparisonChoice& choice_;
  std::vector<Variant> variants_;
  std::vector<Scenario> bases_;  // by record
  ComparisonPlan plan_;
  Errors errors_;
};

double spectral_acceleration(const MotionInput& motion, double period) {
  const seismic::GroundHistory& x = motion.ground->horizontal();
  return seismic::spectral_point(x.acceleration, x.interval, period).pseudo_acceleration;
}

// The motion is linear in either.
void scale_motion(RecordChoice& record, double factor) {
  if (record.pga)
    record.pga = factor * *record.pga;
  else
    record.scale = factor * record.scale.value_or(1.0);
}

Case scaled_case(const Case& one, double factor) {
  Case scaled = one;
  scaled.view = View::same_sa;
  scaled.factor = factor;
  scale_motion(scaled.scenario.record, factor);
  const fs::path folder = one.scenario.output.directory;
  scaled.scenario.output.directory =
      folder_of(folder.parent_path().string(), folder.filename().string(), View::same_sa);
  return scaled;
}

}  // namespace

std::string to_string(View view) {
  return view == View::same_motion ? "same motion" : "same Sa(T1)";
}

ComparisonPlan plan_comparison(const ComparisonChoice& choice) {
  return Planner(choice).plan();
}

std::vector<VariantSheet> look_at_variants(const ComparisonPlan& plan, const fs::path& records) {
  std::vector<VariantSheet> sheets;
  for (const Case& one : plan.cases) {
    if (one.record != 0) continue;
    const std::string& name = plan.variants[one.variant];
    try {
      const Preparation p = prepare(one.scenario, records);
      const ModelSheet sheet = model_sheet(p);
      sheets.push_back({name, sheet.title, sheet.period, sheet.mass, sheet.blocks.size(), sheet.bonds,
                        p.estimated_seconds});
    } catch (const ModelError& error) {
      throw ModelError(fmt::format("variant \"{}\": {}", name, error.what()));
    } catch (const structures::LayoutError& error) {
      throw ScenarioError({{fmt::format("variant \"{}\"", name), error.what()}});
    }
  }
  return sheets;
}

bool periods_differ(const std::vector<VariantSheet>& variants) {
  const double reference = variants.front().period;
  return reference > 0.0 && std::ranges::any_of(variants, [&](const VariantSheet& variant) {
           return variant.period > 0.0 && std::abs(variant.period / reference - 1.0) > same_period;
         });
}

std::vector<Case> cases_of_same_sa(const ComparisonPlan& plan, const std::vector<VariantSheet>& variants,
                                   const fs::path& records) {
  std::vector<Case> scaled;
  const double reference = variants.front().period;
  if (!(reference > 0.0)) return scaled;
  std::vector<MotionInput> motions;
  for (const Case& one : plan.cases) {
    if (one.variant == 0) motions.push_back(make_motion(one.scenario, records));
    const double period = variants[one.variant].period;
    if (!(period > 0.0) || period == reference) continue;
    const MotionInput& motion = motions[one.record];
    const double own = spectral_acceleration(motion, period);
    if (own > 0.0) scaled.push_back(scaled_case(one, spectral_acceleration(motion, reference) / own));
  }
  return scaled;
}

std::string inputs_of(const Case& one, const fs::path& records) {
  std::string all = program_version() + "\n" + program_git_hash() + "\n" + to_toml(one.scenario);
  for (const auto& component : read_scenario_record(one.scenario.record, records).components)
    all += component.provenance.sha256 + "\n";
  if (!one.scenario.layout.file.empty()) all += load_text(one.scenario.layout.file, "a building");
  return seismic::sha256_hex(all);
}

}  // namespace dougong::app
