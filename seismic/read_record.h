// Reads a recording of any known format: the content decides which, never the file's name. A file may be an
// archive (.gz, .tar.gz, .zip) of recordings, and a recording may have many channels.
//
// Units and time step are never guessed. A file that does not state them needs them from the caller, and
// the error says which option to give.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "seismic/constants.h"
#include "seismic/input_error.h"
#include "seismic/record.h"

namespace dougong::seismic {

struct ReadOptions {
  std::optional<std::string>
      component;  // drives the horizontal axis: "EW", "180", "N08W", by name or direction; unset: the first
  std::optional<std::string> station;  // of a file with several: "AOM001", with its sensor "TKYH12.2"
  std::optional<std::string> member;   // of an archive: its name, with or without folders
  std::optional<std::string> units;    // of the values, for files that do not say
  std::optional<double> interval;      // s between samples, for files that do not say
  std::optional<double> count_scale;   // m/s2 per count (parse_count_scale reads "3920/6182761")
  std::optional<std::filesystem::path> response;  // StationXML with the sensitivity of counts
  std::optional<std::string> format;              // id of the format, to skip the sniffing
  std::optional<bool> remove_mean;                // unset: only for counts, whose offset is the instrument's
  bool siblings = true;                           // read the other components that lie beside the file
  double gravity = standard_gravity;              // m/s2 per g
};

/// Every channel that a file or archive holds, each as long as it is there; of a file whose format keeps one
/// component a file, those beside it too. Channels of one station that share a name are told apart by a
/// number ("90", "90#2").
struct Channels {
  std::vector<Record> records;
  std::vector<std::string> warnings;
};

/// Throws InputError.
Channels read_channels(const std::filesystem::path& path, const ReadOptions& options = {});

/// The components of one station, cut to the shortest: options.component or options.station chooses among
/// several stations. Throws InputError.
RecordSet read_record(const std::filesystem::path& path, const ReadOptions& options = {});

/// Reads files named one by one as the components of one station. Throws InputError.
RecordSet read_records(std::span<const std::filesystem::path> paths, const ReadOptions& options = {});

/// The formats' reader for bytes at hand, under a name for messages: no archives, no siblings.
std::vector<Record> read_bytes_as_record(const std::string& name, std::string bytes,
                                         const ReadOptions& options = {});

}  // namespace dougong::seismic
