// Many recordings at once: what each component measures, and which files are none.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dougong::app {

/// One component. Of a dimensionless shape the values are over its peak.
struct RecordSummary {
  std::string file, event, station, component, format, units;  // units as found
  bool dimensionless = false, synthetic = false;
  std::size_t samples = 0;
  double interval = 0.0, length = 0.0;  // s
  double pga = 0.0, pgv = 0.0;          // m/s2; m/s, mean removed
  double d5_95 = 0.0;                   // s
  double mean_period = 0.0;             // s, Rathje et al. (1998)
  std::vector<double> psa;              // m/s2, 5 %, at the list's periods
  std::size_t warnings = 0;
};

struct UnreadableFile {
  std::string file, reason;
};

struct RecordList {
  std::vector<double> periods;         // s
  std::vector<RecordSummary> records;  // in the order of the files
  std::vector<UnreadableFile> unreadable;
};

/// Every file below a folder, sorted by name; hidden ones are left out. Throws seismic::InputError.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// Every file is read alone, on so many threads: the list does not depend on their number.
RecordList list_records(const std::vector<std::filesystem::path>& files, const std::vector<double>& periods,
                        std::size_t jobs);

/// What a list is sorted by: "name", the least first; "pga", "pgv", "d5-95", "dt", "length", "mean-period" or
/// "psa" (at the first period), the greatest first. Shapes without units come last of those with units.
const std::vector<std::string>& sort_keys();
void sort_records(RecordList& list, std::string_view key);
/// The motions first whose mean period is nearest to this one (s), by its ratio.
void sort_near_period(RecordList& list, double period);

}  // namespace dougong::app
