// The shipped recordings: catalogue.json in the folder of the records names every one, says how it was
// made and what it measures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seismic/record.h"

namespace dougong::seismic {

struct CatalogueFile {
  std::string name;       // in the folder of the catalogue
  std::string component;  // "EW", "NS", "UD"
  std::string sha256;
  double pga = 0.0;                                                   // m/s2
  double pgv = 0.0;                                                   // m/s, mean removed
  double arias = 0.0;                                                 // m/s
  double d5_95 = 0.0;                                                 // s
  double psa_0_2 = 0.0, psa_0_5 = 0.0, psa_1_0 = 0.0, psa_2_0 = 0.0;  // m/s2, 5 %
};

struct CatalogueEntry {
  std::string id;     // "wenchuan-synthetic"
  std::string alias;  // "wenchuan"
  std::string title;
  bool synthetic = true;
  std::string made_by;  // plain words: method, parameters
  std::string command;  // that makes the files again
  std::uint64_t seed = 0;
  double interval = 0.0;  // s
  double duration = 0.0;  // s
  std::vector<CatalogueFile> files;
  std::vector<std::string> also;  // names of files that hold the same motion in other formats
  std::filesystem::path directory;

  std::vector<std::filesystem::path> paths() const;
};

/// Every entry of directory/catalogue.json. Throws InputError.
std::vector<CatalogueEntry> read_catalogue(const std::filesystem::path& directory);

/// By id or alias, any case. Nothing when there is none.
std::optional<CatalogueEntry> find_entry(const std::vector<CatalogueEntry>& catalogue, std::string_view name);

}  // namespace dougong::seismic
