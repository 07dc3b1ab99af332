#include "app/cli/motion_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "seismic/formats/peer_at2.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// One field of a header line: what would end it is taken out.
std::string field(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

void check_motion_file(const fs::path& path, bool force) {
  const std::string extension = extension_of(path);
  if (extension != ".at2" && extension != ".csv")
    throw FileError(path, "write", "expected a name that ends in .at2 or .csv");
  if (!force && fs::exists(path))
    throw FileError(path, "write", "the file exists; choose another name, or --force");
}

std::string csv_of(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : ",") + names[i];
  out += '\n';
  for (std::size_t row = 0; !columns.empty() && row < columns[0].size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) out += (i == 0 ? "" : ",") + exact(columns[i][row]);
    out += '\n';
  }
  return out;
}

void write_motion(const fs::path& path, const MotionSheetLines& lines, double interval,
                  const std::vector<double>& acceleration, bool force) {
  check_motion_file(path, force);
  const bool four_decimals = std::abs(std::round(1e4 * interval) - 1e4 * interval) < 1e-9;
  if (extension_of(path) == ".at2" && !four_decimals)
    throw FileError(path, "write",
                    fmt::format("AT2 states a step to 0.1 ms, this one is {:.9g} s; use .csv", interval));
  if (extension_of(path) == ".at2")
    return write_file(path, seismic::write_peer_at2({field(lines.title), field(lines.event), "undated",
                                                     field(lines.station), field(lines.component), interval,
                                                     acceleration}));
  std::vector<double> times(acceleration.size());
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = interval * static_cast<double>(k);
  write_file(path, csv_of({"time_s", "acceleration_m_s2"}, {times, acceleration}));
}

}  // namespace dougong::app
