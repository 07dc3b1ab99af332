#include "app/study/motion_input.h"

#include <fmt/format.h>

#include <utility>

#include "app/study/quantity.h"
#include "app/study/target_choice.h"

namespace dougong::app {

seismic::ReadOptions read_options(const RecordChoice& choice) {
  seismic::ReadOptions options;
  if (!choice.component.empty()) options.component = choice.component;
  if (!choice.station.empty()) options.station = choice.station;
  if (!choice.member.empty()) options.member = choice.member;
  if (!choice.response.empty()) options.response = choice.response;
  if (!choice.units.empty()) options.units = choice.units;
  if (!choice.format.empty()) options.format = choice.format;
  options.interval = choice.interval;
  if (choice.count_scale.empty()) return options;
  options.count_scale = seismic::parse_count_scale(choice.count_scale);
  if (!options.count_scale)
    throw seismic::InputError("record.count_scale", 0, "gal per count as \"3920/6182761\"",
                              choice.count_scale);
  return options;
}

namespace {

seismic::CatalogueEntry entry_named(const std::string& name, const std::filesystem::path& directory) {
  const auto catalogue = seismic::read_catalogue(directory);
  if (auto entry = seismic::find_entry(catalogue, name)) return *entry;
  std::string known;
  for (const auto& entry : catalogue)
    known += (known.empty() ? "" : ", ") + entry.id + " (" + entry.alias + ")";
  throw seismic::InputError("record", 0, "a file, or a shipped record: " + known, "\"" + name + "\"");
}

seismic::OffsetRemoval offset_of(const std::string& word) {
  if (word == "keep") return seismic::OffsetRemoval::none;
  if (word == "pre-event") return seismic::OffsetRemoval::pre_event_mean;
  return seismic::OffsetRemoval::whole_record_mean;
}

seismic::BaselineCorrection baseline_of(const std::string& word) {
  if (word == "acceleration-line") return seismic::BaselineCorrection::acceleration_line;
  if (word == "velocity-parabola") return seismic::BaselineCorrection::velocity_parabola;
  if (word == "acceleration-polynomial") return seismic::BaselineCorrection::acceleration_polynomial;
  if (word == "velocity-polynomial") return seismic::BaselineCorrection::velocity_polynomial;
  return seismic::BaselineCorrection::none;
}

seismic::ResampleMethod resampling_of(const std::string& word) {
  if (word == "spline") return seismic::ResampleMethod::spline;
  return word == "linear" ? seismic::ResampleMethod::linear : seismic::ResampleMethod::fft;
}

std::vector<NamedValue> provenance_of(const seismic::Record& record) {
  const seismic::Provenance& p = record.provenance;
  std::vector<NamedValue> values{{"event", p.event, ""},
                                 {"station", p.station, ""},
                                 {"component", record.component, ""},
                                 {"format", p.format, ""},
                                 {"units as found", p.units, ""},
                                 {"file", p.file, ""},
                                 {"SHA-256 of the file", p.sha256, ""}};
  values.push_back(
      {"samples", fmt::format("{} every {} s", record.acceleration.size(), record.interval), ""});
  if (p.synthetic) values.push_back({"kind", "synthetic: made by a program, not recorded", ""});
  return values;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

seismic::RecordSet read_scenario_record(const RecordChoice& choice, const std::filesystem::path& directory) {
  const seismic::ReadOptions options = read_options(choice);
  if (!choice.file.empty()) return seismic::read_record(choice.file, options);
  return seismic::read_records(entry_named(choice.name, directory).paths(), options);
}

seismic::ConditioningOptions conditioning_options(const Scenario& scenario) {
  const Conditioning& c = scenario.conditioning;
  seismic::ConditioningOptions options;
  options.offset = offset_of(c.offset);
  options.pre_event = c.pre_event;
  options.baseline = baseline_of(c.baseline);
  options.baseline_degree = static_cast<int>(c.baseline_degree);
  options.taper_fraction = c.taper;
  options.filter = c.filter;
  options.order = static_cast<int>(c.filter_order);
  options.phase = c.filter_phase == "causal" ? seismic::FilterPhase::causal : seismic::FilterPhase::zero;
  options.high_pass = c.high_pass;
  options.low_pass = c.low_pass;
  options.pad = c.pad;
  options.target_pga = scenario.record.pga;
  options.scale_factor = scenario.record.scale;
  options.interval = c.interval;
  options.resample_method = resampling_of(c.resample);
  options.end = c.end == "at-rest" ? seismic::EndRule::at_rest : seismic::EndRule::as_it_is;
  options.vertical = scenario.record.vertical;
  return options;
}

seismic::Channels read_scenario_channels(const RecordChoice& choice, const std::filesystem::path& directory) {
  seismic::ReadOptions options = read_options(choice);
  if (!choice.file.empty()) return seismic::read_channels(choice.file, options);
  seismic::RecordSet set = seismic::read_records(entry_named(choice.name, directory).paths(), options);
  return {std::move(set.components), std::move(set.warnings)};
}

MotionInput make_motion(const Scenario& scenario, const std::filesystem::path& directory) {
  MotionInput input;
  if (const std::string& design = scenario.record.design_spectrum; !design.empty())
    input.design = target_spectrum(design, "record.design_spectrum");
  input.records = read_scenario_record(scenario.record, directory);
  if (scenario.record.vertical && !input.records.vertical())
    throw seismic::InputError(input.records.horizontal().provenance.file, 0,
                              "a vertical component beside it (record.vertical is true)", "none");
  input.conditioned = seismic::condition(input.records, conditioning_options(scenario));
  input.ground = std::make_shared<const seismic::GroundMotion>(input.conditioned.ground_motion());
  return input;
}

namespace {

// At the periods of the motion's spectrum that it covers.
void draw_design(const seismic::DesignSpectrum& design, MotionSheet& sheet) {
  sheet.design_name = design.name;
  for (const double period : sheet.spectrum_periods) {
    if (period < design.shortest_period || period > design.longest_period) continue;
    sheet.design_periods.push_back(period);
    sheet.design_psa.push_back(design.at(period));
  }
}

}  // namespace

MotionSheet motion_sheet(const MotionInput& motion, double period) {
  const seismic::GroundHistory& x = motion.ground->horizontal();
  MotionSheet sheet;
  sheet.title = motion.conditioned.title;
  sheet.provenance = provenance_of(motion.records.horizontal());
  sheet.processing = motion.conditioned.processing;
  append(sheet.processing, motion.conditioned.warnings);
  append(sheet.processing, seismic::building_warnings(motion.conditioned, period));
  for (const seismic::Measure& m : seismic::measures(x.acceleration, x.interval))
    sheet.measures.push_back({m.name, fmt::format("{:.4g} {}", m.value, m.unit), m.meaning});
  sheet.interval = x.interval;
  sheet.times = motion.ground->times();
  sheet.acceleration_x = x.acceleration, sheet.velocity_x = x.velocity, sheet.displacement_x = x.displacement;
  if (const seismic::GroundHistory* y = motion.ground->vertical())
    sheet.acceleration_y = y->acceleration, sheet.velocity_y = y->velocity,
    sheet.displacement_y = y->displacement;
  sheet.spectrum_periods = seismic::log_spaced_periods();
  for (const auto& p : seismic::response_spectrum(x.acceleration, x.interval, sheet.spectrum_periods))
    sheet.spectrum_psa.push_back(p.pseudo_acceleration);
  if (motion.design) draw_design(*motion.design, sheet);
  if (period > 0.0)
    sheet.spectrum_at_period =
        seismic::spectral_point(x.acceleration, x.interval, period).pseudo_acceleration;
  return sheet;
}

}  // namespace dougong::app
