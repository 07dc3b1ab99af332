// `dougong records`: the shipped ground motions, or every recording of a folder, as one table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/commands.h"
#include "app/cli/record_output.h"
#include "app/cli/record_source.h"
#include "app/report/csv.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "app/study/record_list.h"
#include "seismic/seismic.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

const std::vector<double> usual_periods = {0.2, 0.5, 1.0, 2.0};  // s

std::vector<double> listed_periods(const RecordListOptions& o, std::optional<double> near) {
  PeriodChoice choice;
  choice.periods = o.periods;
  std::vector<double> periods = o.periods.empty() ? usual_periods : periods_of(choice, 0.1, 1.0, 1);
  if (near && o.periods.empty()) periods = {*near};
  return periods;
}

// A shape has neither PGA nor spectrum until it is scaled.
std::string cell(const RecordSummary& r, double value, double unit, int width) {
  return r.dimensionless ? fmt::format(" {:>{}}", "-", width)
                         : fmt::format(" {:>{}.3g}", value / unit, width);
}

// In the units that engineers read: g, m/s, s.
std::string row_of(const RecordSummary& r, std::size_t file_width, std::size_t component_width) {
  constexpr double g = seismic::standard_gravity;
  std::string row = fmt::format("{:<{}}  {:<{}} {:>6.4g} {:>8.5g}", r.file, file_width, r.component,
                                component_width, r.interval, r.length);
  row += cell(r, r.pga, g, 9) + cell(r, r.pgv, 1.0, 9);
  row += fmt::format(" {:>7.3g} {:>6.3g}", r.d5_95, r.mean_period);
  for (const double psa : r.psa) row += cell(r, psa, g, 9);
  const char* plural = r.warnings == 1 ? "" : "s";
  return row + fmt::format("  {}{}, {}{}", r.synthetic ? "SYNTHETIC, " : "", r.format, r.units,
                           r.warnings > 0 ? fmt::format(", {} warning{}", r.warnings, plural) : "");
}

void print_table(const RecordList& list) {
  std::size_t file = 4, component = 5;
  for (const RecordSummary& r : list.records) {
    file = std::max(file, r.file.size());
    component = std::max(component, r.component.size());
  }
  std::string head = fmt::format("{:<{}}  {:<{}} {:>6} {:>8} {:>9} {:>9} {:>7} {:>6}", "file", file, "comp.",
                                 component, "dt, s", "length,s", "PGA, g", "PGV, m/s", "D5-95,s", "Tm, s");
  for (const double period : list.periods) head += fmt::format(" {:>9}", fmt::format("Sa({:g}),g", period));
  fmt::print("{}  format, units as found\n", head);
  for (const RecordSummary& r : list.records) fmt::print("{}\n", row_of(r, file, component));
}

void print_unreadable(const RecordList& list) {
  if (list.unreadable.empty()) return;
  fmt::print("\nnot read, {} of the files:\n", list.unreadable.size());
  for (const UnreadableFile& file : list.unreadable) fmt::print("  {}: {}\n", file.file, file.reason);
}

ordered_json json_of(const RecordList& list) {
  ordered_json records = ordered_json::array(), unreadable = ordered_json::array();
  for (const RecordSummary& r : list.records) {
    ordered_json psa = ordered_json::object();
    for (std::size_t i = 0; i < r.psa.size(); ++i) psa[fmt::format("{:g}", list.periods[i])] = r.psa[i];
    records.push_back({{"file", r.file},
                       {"component", r.component},
                       {"event", r.event},
                       {"station", r.station},
                       {"format", r.format},
                       {"units_as_found", r.units},
                       {"dimensionless", r.dimensionless},
                       {"synthetic", r.synthetic},
                       {"npts", r.samples},
                       {"dt_s", r.interval},
                       {"duration_s", r.length},
                       {"pga_m_s2", r.pga},
                       {"pgv_m_s", r.pgv},
                       {"d5_95_s", r.d5_95},
                       {"mean_period_s", r.mean_period},
                       {"psa_m_s2_at_s", psa},
                       {"warnings", r.warnings}});
  }
  for (const UnreadableFile& file : list.unreadable)
    unreadable.push_back({{"file", file.file}, {"reason", file.reason}});
  return {{"records", records}, {"unreadable", unreadable}};
}

std::string csv_of_list(const RecordList& list) {
  std::string out =
      "file,component,event,station,format,units as found,synthetic,samples,dt (s),length (s),PGA (m/s2),PGV "
      "(m/s),D5-95 (s),mean period (s)";
  for (const double period : list.periods) out += fmt::format(",PSa at {:g} s (m/s2)", period);
  out += '\n';
  for (const RecordSummary& r : list.records) {
    for (const std::string* text : {&r.file, &r.component, &r.event, &r.station, &r.format, &r.units})
      out += csv_text(*text) + ",";
    out += fmt::format("{},{},{},{}", r.synthetic ? 1 : 0, r.samples, exact(r.interval), exact(r.length));
    for (const double value : {r.pga, r.pgv, r.d5_95, r.mean_period}) out += "," + exact(value);
    for (const double psa : r.psa) out += "," + exact(psa);
    out += '\n';
  }
  return out;
}

// The files of the catalogue, under the names by which commands know them.
RecordList shipped_list(const std::vector<double>& periods, std::size_t jobs) {
  std::vector<fs::path> files;
  std::map<std::string, std::string> alias_of;
  for (const seismic::CatalogueEntry& entry : seismic::read_catalogue(records_directory()))
    for (const fs::path& path : entry.paths()) {
      files.push_back(path);
      alias_of[path.string()] = entry.alias;
    }
  RecordList list = list_records(files, periods, jobs);
  for (RecordSummary& r : list.records) r.file = alias_of.at(r.file);
  return list;
}

void sort_as_asked(RecordList& list, const RecordListOptions& o, std::optional<double> near) {
  const auto& keys = sort_keys();
  if (!o.sort.empty() && std::find(keys.begin(), keys.end(), o.sort) == keys.end())
    refuse("--sort", fmt::format("expected one of {}, found \"{}\"", fmt::join(keys, ", "), o.sort));
  if (near) sort_near_period(list, *near);
  if (!o.sort.empty()) sort_records(list, o.sort);
}

void print_shipped_notes() {
  fmt::print("\n");
  for (const seismic::CatalogueEntry& entry : seismic::read_catalogue(records_directory()))
    fmt::print("{}: {}{}, {}\n", entry.alias, entry.synthetic ? "SYNTHETIC, not a recording: " : "",
               entry.title, entry.id);
  fmt::print("\nHow they were made: docs/records.md. Any file: dougong record info FILE\n");
}

}  // namespace

int records_command(const RecordListOptions& o) {
  std::optional<double> near;
  if (!o.near_period.empty()) near = quantity_of(o.near_period, Dimension::time, "--near-period");
  if (near && !(*near > 0.0)) refuse("--near-period", "expected a period above 0 s");
  check_new_file(o.csv, o.force);
  const std::vector<double> periods = listed_periods(o, near);
  const std::size_t jobs = o.jobs > 0 ? o.jobs : std::max(1u, std::thread::hardware_concurrency());
  RecordList list =
      o.folder.empty() ? shipped_list(periods, jobs) : list_records(files_below(o.folder), periods, jobs);
  if (list.records.empty())
    throw seismic::InputError(o.folder, 0, "a folder with recordings",
                              fmt::format("{} files, none of them readable{}", list.unreadable.size(),
                                          list.unreadable.empty() ? ""
                                                                  : "; " + list.unreadable[0].file + ": " +
                                                                        list.unreadable[0].reason));
  sort_as_asked(list, o, near);
  if (!o.csv.empty()) write_file(o.csv, csv_of_list(list));
  if (o.json) return print_json(json_of(list)), exit_survived;
  print_table(list);
  print_unreadable(list);
  if (o.folder.empty()) print_shipped_notes();
  return exit_survived;
}

}  // namespace dougong::app
