#include "seismic/catalogue.h"

#include <nlohmann/json.hpp>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

using Json = nlohmann::json;

CatalogueFile file_of(const Json& json) {
  CatalogueFile file;
  json.at("name").get_to(file.name);
  json.at("component").get_to(file.component);
  json.at("sha256").get_to(file.sha256);
  const Json& measures = json.at("measures");
  measures.at("pga").get_to(file.pga);
  measures.at("pgv").get_to(file.pgv);
  measures.at("arias").get_to(file.arias);
  measures.at("d5_95").get_to(file.d5_95);
  measures.at("psa_0.2").get_to(file.psa_0_2);
  measures.at("psa_0.5").get_to(file.psa_0_5);
  measures.at("psa_1.0").get_to(file.psa_1_0);
  measures.at("psa_2.0").get_to(file.psa_2_0);
  return file;
}

CatalogueEntry entry_of(const Json& json, const std::filesystem::path& directory) {
  CatalogueEntry entry;
  json.at("id").get_to(entry.id);
  json.at("alias").get_to(entry.alias);
  json.at("title").get_to(entry.title);
  json.at("synthetic").get_to(entry.synthetic);
  json.at("made_by").get_to(entry.made_by);
  json.at("command").get_to(entry.command);
  json.at("seed").get_to(entry.seed);
  json.at("interval").get_to(entry.interval);
  json.at("duration").get_to(entry.duration);
  for (const Json& file : json.at("files")) entry.files.push_back(file_of(file));
  for (const Json& file : json.at("also")) entry.also.push_back(file.at("name").get<std::string>());
  entry.directory = directory;
  return entry;
}

}  // namespace

std::vector<std::filesystem::path> CatalogueEntry::paths() const {
  std::vector<std::filesystem::path> out;
  for (const CatalogueFile& file : files) out.push_back(directory / file.name);
  return out;
}

std::vector<CatalogueEntry> read_catalogue(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "catalogue.json";
  FileText text;
  load_file(path, text);
  std::vector<CatalogueEntry> entries;
  try {
    const Json catalogue = Json::parse(text.bytes);
    for (const Json& json : catalogue.at("records")) entries.push_back(entry_of(json, directory));
  } catch (const Json::exception& error) {
    throw InputError(path.string(), 0, "a catalogue of records", printable(error.what()));
  }
  return entries;
}

std::optional<CatalogueEntry> find_entry(const std::vector<CatalogueEntry>& catalogue,
                                         std::string_view name) {
  const std::string asked = upper_case(name);
  for (const CatalogueEntry& entry : catalogue) {
    if (upper_case(entry.id) == asked || upper_case(entry.alias) == asked) return entry;
  }
  return std::nullopt;
}

}  // namespace dougong::seismic
