#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/record_choice.h"
#include "app/report/safe_file.h"
#include "app/study/quantity.h"
#include "seismic/seismic.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

seismic::WrittenFormat format_asked_for(const std::string& name) {
  if (const auto format = seismic::written_format(name)) return *format;
  throw seismic::InputError("--to", 0, "at2, knet, csmnc, csv or miniseed", "\"" + name + "\"");
}

// The flag is named where its value is wrong.
double quantity_of(const char* flag, const std::string& text, Dimension dimension) {
  try {
    return parse_quantity(text, dimension);
  } catch (const QuantityError& error) {
    throw seismic::InputError(flag, 0, "a quantity with its unit", error.what());
  }
}

void turn(seismic::RecordSet& set, const std::string& azimuth) {
  if (azimuth.empty()) return;
  const double degrees = quantity_of("--azimuth", azimuth, Dimension::angle) * 360.0 / seismic::two_pi;
  set = seismic::rotated(set, degrees);
}

// Every component by the factor that brings the chosen one to the peak asked for.
void scale(seismic::RecordSet& set, const std::string& pga) {
  if (pga.empty()) return;
  const double target = quantity_of("--pga", pga, Dimension::acceleration);
  const double peak = seismic::peak(set.horizontal().acceleration, set.horizontal().interval).value;
  if (!(target > 0.0) || !(peak > 0.0))
    throw seismic::InputError("--pga", 0, "a positive peak, and a record that is not zero throughout", pga);
  const double factor = target / peak;
  for (seismic::Record& record : set.components) {
    for (double& a : record.acceleration) a *= factor;
    record.dimensionless = false;
    record.processing.push_back(fmt::format("scaled by {:.10g} to a peak of {}", factor, pga));
  }
}

std::vector<seismic::Record> components_to_write(seismic::RecordSet set, bool only_chosen) {
  if (only_chosen) return {set.horizontal()};
  return std::move(set.components);
}

fs::path stem_of(const RecordConvertOptions& options) {
  if (!options.out.empty()) return options.out;
  return fs::path(options.from.record).stem();
}

fs::path path_of(const fs::path& stem, const seismic::WrittenFile& file) {
  return stem.string() + file.suffix;
}

// All or nothing: no file is written when one of them is in the way.
void check_free(const fs::path& stem, const std::vector<seismic::WrittenFile>& files, bool force) {
  for (const seismic::WrittenFile& file : files) {
    const fs::path path = path_of(stem, file);
    std::error_code error;
    if (!force && fs::exists(path, error))
      throw seismic::InputError(path.string(), 0, "a name that is free (--force writes over it)", "a file");
  }
}

}  // namespace

int record_convert_command(const RecordConvertOptions& options) {
  const seismic::WrittenFormat format = format_asked_for(options.format);
  seismic::RecordSet set = read_asked_record(options.from);
  turn(set, options.azimuth);
  scale(set, options.pga);
  const std::vector<std::string> warnings = set.warnings;
  const bool only_chosen = !options.from.component.empty();
  const auto components = components_to_write(std::move(set), only_chosen);
  const auto files = seismic::write_records(components, format);
  const fs::path stem = stem_of(options);
  check_free(stem, files, options.force);
  if (stem.has_parent_path()) make_directory(stem.parent_path());
  nlohmann::ordered_json written = nlohmann::ordered_json::array();
  for (const seismic::WrittenFile& file : files) {
    const fs::path path = path_of(stem, file);
    write_file(path, file.bytes);
    written.push_back(
        {{"file", path.string()}, {"components", file.components}, {"bytes", file.bytes.size()}});
    if (!options.from.json) fmt::print("{}: {}\n", path.string(), fmt::join(file.components, ", "));
  }
  if (options.from.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"written", written}, {"warnings", warnings}}.dump(2));
  else
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
  return exit_survived;
}

}  // namespace dougong::app
