// A motion that a command leaves behind: PEER AT2 (.at2) or two columns (.csv), by the name of the file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dougong::app {

struct MotionSheetLines {
  std::string title;  // first line: what it is, and that it is synthetic where it is
  std::string event, station, component;
};

/// m/s2. Throws FileError for an existing file unless forced, and for a name that is neither.
void write_motion(const std::filesystem::path& path, const MotionSheetLines& lines, double interval,
                  const std::vector<double>& acceleration, bool force);
/// Throws FileError where it could not be written: before anything is computed.
void check_motion_file(const std::filesystem::path& path, bool force);

/// Columns under their names, numbers that read back exactly.
std::string csv_of(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns);

}  // namespace dougong::app
