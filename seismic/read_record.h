// Reads a recording of any known format: the content decides which, never the file's name.
//
// Units and time step are never guessed. A file that does not state them needs them from the caller, and
// the error says which option to give.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "seismic/constants.h"
#include "seismic/input_error.h"
#include "seismic/record.h"

namespace dougong::seismic {

struct ReadOptions {
  std::optional<std::string>
      component;                     // drives the horizontal axis: "EW", "NS", "180"; unset: the given file's
  std::optional<std::string> units;  // of the values, for files that do not say
  std::optional<double> interval;    // s between samples, for files that do not say
  std::optional<double> count_scale;  // m/s2 per count (parse_count_scale reads "3920/6182761")
  std::optional<std::string> format;  // id of the format, to skip the sniffing
  std::optional<bool> remove_mean;    // unset: only for counts, whose offset is the instrument's
  bool siblings = true;               // read the other components that lie beside the file
  double gravity = standard_gravity;  // m/s2 per g
};

/// Reads the file and, beside it, the other components of its station. Throws InputError.
RecordSet read_record(const std::filesystem::path& path, const ReadOptions& options = {});

/// Reads files named one by one as the components of one station. Throws InputError.
RecordSet read_records(std::span<const std::filesystem::path> paths, const ReadOptions& options = {});

}  // namespace dougong::seismic
