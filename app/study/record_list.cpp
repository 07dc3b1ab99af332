#include "app/study/record_list.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "app/study/share_tasks.h"
#include "seismic/seismic.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

struct FileSummary {
  std::vector<RecordSummary> records;
  std::optional<std::string> reason;
};

// PGV as in seismic::describe: the whole-record mean off, from rest.
double peak_velocity(std::vector<double> a, double interval) {
  const double offset = seismic::mean(a);
  for (double& value : a) value -= offset;
  return seismic::peak(seismic::integrate(a, interval).velocity, interval).value;
}

RecordSummary summary_of(const seismic::Record& record, const std::string& file,
                         const std::vector<double>& periods) {
  const seismic::Provenance& from = record.provenance;
  const auto& a = record.acceleration;
  const double h = record.interval;
  RecordSummary s;
  s.file = from.member.empty() ? file : file + "/" + from.member;
  s.event = from.event, s.station = seismic::station_of(record), s.component = record.component;
  s.format = from.format, s.units = record.dimensionless ? "none (shape)" : from.units;
  s.dimensionless = record.dimensionless, s.synthetic = from.synthetic;
  s.samples = a.size(), s.interval = h, s.length = record.duration();
  s.pga = seismic::peak(a, h).value;
  s.pgv = peak_velocity(a, h);
  s.d5_95 = seismic::significant_duration(a, h).duration();
  s.mean_period = seismic::mean_period(a, h);
  s.psa = seismic::pseudo_accelerations(a, h, periods);
  s.warnings = record.warnings.size();
  return s;
}

// The first problem is what a list has room for; the formats that were tried are not.
std::string reason_of(const seismic::InputError& error) {
  const seismic::InputProblem& first = error.problems().front();
  if (first.expected.starts_with("a known format")) return "no known format of recordings";
  const std::string line = first.line > 0 ? "line " + std::to_string(first.line) + ": " : "";
  return line + "expected " + first.expected + ", found " + first.found;
}

FileSummary summary_of(const fs::path& file, const std::vector<double>& periods) {
  seismic::ReadOptions alone;
  alone.siblings = false;
  FileSummary out;
  try {
    for (const seismic::Record& record : seismic::read_channels(file, alone).records)
      out.records.push_back(summary_of(record, file.string(), periods));
  } catch (const seismic::InputError& error) {
    out.reason = reason_of(error);
  }
  return out;
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().starts_with(".");
}

// The greatest first.
const std::map<std::string, std::function<double(const RecordSummary&)>, std::less<>>& quantities() {
  static const std::map<std::string, std::function<double(const RecordSummary&)>, std::less<>> all = {
      {"pga", [](const RecordSummary& r) { return r.pga; }},
      {"pgv", [](const RecordSummary& r) { return r.pgv; }},
      {"d5-95", [](const RecordSummary& r) { return r.d5_95; }},
      {"dt", [](const RecordSummary& r) { return r.interval; }},
      {"length", [](const RecordSummary& r) { return r.length; }},
      {"mean-period", [](const RecordSummary& r) { return r.mean_period; }},
      {"psa", [](const RecordSummary& r) { return r.psa.empty() ? 0.0 : r.psa.front(); }},
  };
  return all;
}

}  // namespace

std::vector<fs::path> files_below(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> files;
  auto entry =
      fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, failed);
  if (failed) throw seismic::InputError(folder.string(), 0, "a folder of recordings", failed.message());
  for (; entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    if (failed) throw seismic::InputError(folder.string(), 0, "a readable folder", failed.message());
    const bool hidden = is_hidden(entry->path());
    if (hidden && entry->is_directory(failed)) entry.disable_recursion_pending();
    if (!hidden && entry->is_regular_file(failed)) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

RecordList list_records(const std::vector<fs::path>& files, const std::vector<double>& periods,
                        std::size_t jobs) {
  std::vector<FileSummary> read(files.size());
  share_tasks(files.size(), jobs, [&](std::size_t i) { read[i] = summary_of(files[i], periods); });
  RecordList list;
  list.periods = periods;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (read[i].reason) list.unreadable.push_back({files[i].string(), *read[i].reason});
    for (RecordSummary& record : read[i].records) list.records.push_back(std::move(record));
  }
  return list;
}

const std::vector<std::string>& sort_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> out = {"name"};
    for (const auto& [key, quantity] : quantities()) out.push_back(key);
    return out;
  }();
  return keys;
}

void sort_records(RecordList& list, std::string_view key) {
  const auto found = quantities().find(key);
  std::stable_sort(list.records.begin(), list.records.end(),
                   [&](const RecordSummary& a, const RecordSummary& b) {
                     if (found == quantities().end()) return a.file < b.file;
                     if (a.dimensionless != b.dimensionless) return b.dimensionless;
                     return found->second(a) > found->second(b);
                   });
}

void sort_near_period(RecordList& list, double period) {
  const auto off = [&](const RecordSummary& r) {
    return r.mean_period > 0.0 ? std::abs(std::log(r.mean_period / period)) : HUGE_VAL;
  };
  std::stable_sort(list.records.begin(), list.records.end(),
                   [&](const RecordSummary& a, const RecordSummary& b) { return off(a) < off(b); });
}

}  // namespace dougong::app
