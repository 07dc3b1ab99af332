#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/record_choice.h"
#include "app/cli/record_facts.h"
#include "app/cli/record_output.h"
#include "app/report/csv.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "app/study/motion_input.h"
#include "seismic/seismic.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

std::string acceleration_text(const seismic::RecordInfo& info, double value) {
  if (info.dimensionless)
    return fmt::format("{} of its peak (no unit: give a target PGA to use it)", significant(value, 4));
  return fmt::format("{:.6g} m/s2 = {:+.6f} g", value, value / seismic::standard_gravity);
}

void print_info(const seismic::RecordInfo& i) {
  const auto row = [](const std::string& name, const std::string& value) {
    if (!value.empty()) fmt::print("  {:<12}{}\n", name, value);
  };
  fmt::print("{} {}\n", i.component, i.dimensionless ? "(dimensionless shape)" : "");
  row("event", i.event);
  row("station", i.station);
  row("axis", i.axis);
  row("format", i.format);
  row("units", i.units);
  row("file", i.file);
  row("SHA-256", i.sha256);
  row("samples", fmt::format("{} every {} s, {:.6g} s", i.samples, i.interval, i.duration));
  row("PGA", fmt::format("{} at {:.6g} s", acceleration_text(i, i.peak), i.pga_time));
  row("PGV", fmt::format("{:.6g} {}", i.pgv, i.dimensionless ? "s x peak" : "m/s, mean removed"));
  if (!i.dimensionless) row("Arias", fmt::format("{:.6g} m/s", i.arias));
  if (!i.dimensionless) row("CAV", fmt::format("{:.6g} m/s", i.cav));
  row("D5-95", fmt::format("{:.6g} s", i.d5_95));
  row("PSa",
      fmt::format("{:.4g} at 0.2 s, {:.4g} at 0.5 s, {:.4g} at 1 s, {:.4g} at 2 s ({}, 5 %)", i.psa_0_2,
                  i.psa_0_5, i.psa_1_0, i.psa_2_0, i.dimensionless ? "of the peak" : "m/s2"));
  for (const std::string& step : i.processing) row("done", step);
  for (const std::string& warning : i.warnings) row("warning", warning);
}

ordered_json json_of(const seismic::RecordInfo& i) {
  ordered_json header = ordered_json::object();
  for (const auto& [name, value] : i.header) header[name] = value;
  return {{"component", i.component},
          {"axis", i.axis},
          {"event", i.event},
          {"station", i.station},
          {"format", i.format},
          {"units_as_found", i.units},
          {"dimensionless", i.dimensionless},
          {"synthetic", i.synthetic},
          {"processed", i.processed},
          {"file", i.file},
          {"sha256", i.sha256},
          {"npts", i.samples},
          {"dt_s", i.interval},
          {"duration_s", i.duration},
          {"pga_m_s2", i.pga},
          {"pga_g", i.pga / seismic::standard_gravity},
          {"peak_m_s2", i.peak},
          {"peak_g", i.peak / seismic::standard_gravity},
          {"pga_time_s", i.pga_time},
          {"pgv_m_s", i.pgv},
          {"pgd_m", i.pgd},
          {"arias_m_s", i.arias},
          {"cav_m_s", i.cav},
          {"d5_95_s", i.d5_95},
          {"d5_75_s", i.d5_75},
          {"bracketed_0_05g_s", i.bracketed},
          {"rms_m_s2", i.rms},
          {"housner_m", i.housner},
          {"psa_0_2_m_s2", i.psa_0_2},
          {"psa_0_5_m_s2", i.psa_0_5},
          {"psa_1_0_m_s2", i.psa_1_0},
          {"psa_2_0_m_s2", i.psa_2_0},
          {"header", header},
          {"processing", i.processing},
          {"warnings", i.warnings}};
}

std::string cell_of(const ordered_json& value) {
  if (value.is_null()) return "";
  return csv_text(value.is_string() ? value.get<std::string>() : value.dump());
}

/// A row a component; what one of them does not say is an empty cell.
std::string csv_of(const ordered_json& components) {
  std::vector<std::string> names;
  for (const ordered_json& component : components)
    for (const auto& item : component.items())
      if (std::ranges::find(names, item.key()) == names.end()) names.push_back(item.key());
  std::string out = fmt::format("{}\n", fmt::join(names, ","));
  for (const ordered_json& component : components) {
    std::vector<std::string> cells;
    for (const std::string& name : names)
      cells.push_back(component.contains(name) ? cell_of(component.at(name)) : "");
    out += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return out;
}

}  // namespace

std::filesystem::path records_directory() {
  if (const char* directory = std::getenv("DOUGONG_RECORDS"); directory && *directory) return directory;
  return DOUGONG_RECORDS_DIRECTORY;
}

int record_info_command(const RecordInfoOptions& options) {
  check_new_file(options.csv, options.force);
  const AskedChannels asked = read_asked_channels(options);
  const seismic::Channels& set = asked.channels;
  ordered_json components = ordered_json::array();
  for (std::size_t i = 0; i < set.records.size(); ++i) {
    const seismic::RecordInfo info = seismic::describe(set.records[i]);
    if (!options.json) print_info(info);
    if (!options.json) print_facts(set.records[i]);
    components.push_back(json_of(info));
    components.back().update(facts_json(set.records[i]));
    components.back()["chosen"] = asked.chosen == i;
  }
  if (options.json)
    fmt::print("{}\n", ordered_json{{"components", components}, {"warnings", set.warnings}}.dump(
                           2, ' ', false, ordered_json::error_handler_t::replace));
  else
    for (const std::string& warning : set.warnings) fmt::print("warning: {}\n", warning);
  if (!options.csv.empty()) write_file(options.csv, csv_of(components));
  return exit_survived;
}

}  // namespace dougong::app
