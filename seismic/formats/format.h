// The choice point "record format": one file and one line of the table each.
//
// A format is a sniffer, which looks at the content, a reader, and optionally the names under which the
// other components of the station lie beside a file.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

struct Format {
  std::string_view id;     // "peer-at2"
  std::string_view title;  // "PEER AT2"
  bool (*recognises)(const FileText& text);
  /// Every channel of the file. Throws InputError; NotAcceleration for a file to be passed over in an
  /// archive.
  std::vector<Record> (*read)(const FileText& text, const ReadOptions& options);
  std::vector<std::filesystem::path> (*siblings)(const std::filesystem::path& path) = nullptr;
};

/// Every known format, in the order in which they are tried: the vaguest, plain columns, last.
std::span<const Format> formats();

}  // namespace dougong::seismic
