#include "seismic/read_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "seismic/formats/archive.h"
#include "seismic/formats/format.h"
#include "seismic/orientation.h"
#include "seismic/stations.h"

namespace dougong::seismic {
namespace {

namespace fs = std::filesystem;

std::string titles_tried() {
  std::string list;
  for (const Format& format : formats()) list += (list.empty() ? "" : ", ") + std::string(format.title);
  return list;
}

const Format& named_format(const std::string& id) {
  std::string ids;
  for (const Format& format : formats()) {
    if (format.id == id) return format;
    ids += (ids.empty() ? "" : ", ") + std::string(format.id);
  }
  throw InputError("option format", 0, "one of " + ids, in_quotes(id));
}

const Format* recognised(const FileText& text) {
  for (const Format& format : formats()) {
    if (format.recognises(text)) return &format;
  }
  return nullptr;
}

const Format& format_of(const FileText& text, const ReadOptions& options) {
  if (options.format) return named_format(*options.format);
  if (const Format* format = recognised(text)) return *format;
  const std::string_view first = text.lines.empty() ? std::string_view{} : text.lines.front();
  throw InputError(text.name, 0, "a known format (tried: " + titles_tried() + ")",
                   in_quotes(trimmed(first.substr(0, 60))));
}

// --- archives --------------------------------------------------------------------------------------

bool is_member(const std::string& name, const std::string& asked) {
  return name == asked || fs::path(name).filename() == asked;
}

std::string names_of(const std::vector<ArchiveMember>& members) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(members.size(), most); ++i) list += (i ? ", " : "") + members[i].name;
  return members.size() > most ? list + fmt::format(" and {} more", members.size() - most) : list;
}

// An archive is read as a whole: members that are no recordings are passed over and named. Plain columns are
// read only when they are asked for, any list of numbers looks like them.
class ArchiveReading {
 public:
  ArchiveReading(const fs::path& path, const ReadOptions& options) : path_(path), options_(options) {}

  void read(const ArchiveMember& member, Channels& channels) const {
    FileText text;
    set_bytes(member.name.empty() ? path_.string() : path_.string() + "/" + member.name, member.bytes, text);
    const bool asked = options_.member || options_.format || member.name.empty();
    const Format* known = asked ? &format_of(text, options_) : recognised(text);
    if (!known || (!asked && known->id == "columns"))
      return pass_over(member, "no known recording", channels);
    try {
      for (Record& record : known->read(text, options_)) {
        record.provenance.member = member.name;
        channels.records.push_back(std::move(record));
      }
    } catch (const NotAcceleration& error) {
      if (asked) throw;
      pass_over(member, "no acceleration (" + error.problems().front().found + ")", channels);
    }
  }

 private:
  static void pass_over(const ArchiveMember& member, const std::string& reason, Channels& channels) {
    channels.warnings.push_back(fmt::format("{} is passed over: {}", member.name, reason));
  }

  const fs::path& path_;
  const ReadOptions& options_;
};

Channels read_archive(const fs::path& path, const std::string& bytes, const ReadOptions& options) {
  const std::vector<ArchiveMember> members = unpack(bytes, path.string());
  const ArchiveReading reading(path, options);
  Channels channels;
  bool found = false;
  for (const ArchiveMember& member : members) {
    if (options.member && !is_member(member.name, *options.member)) continue;
    reading.read(member, channels);
    found = true;
  }
  if (options.member && !found)
    throw InputError(path.string(), 0, "member " + *options.member, names_of(members));
  if (channels.records.empty())
    throw InputError(path.string(), 0, "an archive of recordings (one by name: option member)",
                     members.empty() ? "no files" : names_of(members));
  const std::string sum = sha256_hex(bytes);
  for (Record& record : channels.records) {
    record.provenance.file = path.string();
    record.provenance.sha256 = sum;
  }
  return channels;
}

// --- files -----------------------------------------------------------------------------------------

// A name alone does not make files components of one motion: what they say of themselves must agree.
bool belong_together(const Record& a, const Record& b) {
  return a.provenance.event == b.provenance.event && station_of(a) == station_of(b) &&
         a.provenance.format == b.provenance.format;
}

void add_siblings(const fs::path& path, const Format& format, const ReadOptions& options,
                  Channels& channels) {
  for (const fs::path& sibling : format.siblings(path)) {
    std::error_code failed;
    if (sibling == path || !fs::is_regular_file(sibling, failed)) continue;
    for (Record& record : read_bytes_as_record(sibling.string(), read_bytes(sibling), options))
      if (belong_together(channels.records.front(), record)) channels.records.push_back(std::move(record));
  }
}

Channels read_plain_file(const fs::path& path, std::string bytes, const ReadOptions& options) {
  if (options.member) throw InputError(path.string(), 0, "an archive (option member)", "no archive");
  FileText text;
  set_bytes(path.string(), std::move(bytes), text);
  const Format& format = format_of(text, options);
  Channels channels{format.read(text, options), {}};
  if (options.siblings && format.siblings) add_siblings(path, format, options, channels);
  return channels;
}

// --- one station of them ---------------------------------------------------------------------------

std::string names_of(const std::vector<Record>& records) {
  std::string list;
  for (const Record& record : records) list += (list.empty() ? "" : ", ") + record.component;
  return list;
}

std::string names_of(const std::vector<Station>& stations) {
  std::string list;
  for (const Station& station : stations)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", station.name, names_of(station.channels));
  return list;
}

bool is_asked_for(const Station& station, const ReadOptions& options) {
  if (options.station)
    return upper_case(station.name) == upper_case(*options.station) ||
           upper_case(station.channels.front().provenance.station) == upper_case(*options.station);
  if (!options.component) return true;
  return std::any_of(station.channels.begin(), station.channels.end(),
                     [&](const Record& record) { return is_component(record, *options.component); });
}

std::vector<Record> one_station(std::vector<Record> records, const ReadOptions& options,
                                const std::string& file) {
  std::vector<Station> stations = group_by_station(std::move(records));
  if (stations.size() == 1 && !options.station) return std::move(stations.front().channels);
  std::vector<Station*> asked;
  for (Station& station : stations)
    if (is_asked_for(station, options)) asked.push_back(&station);
  if (asked.size() == 1) return std::move(asked.front()->channels);
  throw InputError(file, 0,
                   asked.empty() ? "what was asked for (options station, component)"
                                 : "one station (option station, or component)",
                   names_of(stations));
}

std::size_t first_horizontal(const RecordSet& set) {
  for (std::size_t i = 0; i < set.components.size(); ++i)
    if (set.components[i].axis == Axis::horizontal) return i;
  return 0;
}

// The names themselves come before directions, so that "90" is never another component at 90 degrees.
std::vector<std::size_t> components_asked_for(const std::vector<Record>& records, const std::string& asked) {
  std::vector<std::size_t> exact, alike;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (upper_case(records[i].component) == upper_case(asked)) exact.push_back(i);
    if (is_component(records[i], asked)) alike.push_back(i);
  }
  return exact.empty() ? alike : exact;
}

void choose_component(RecordSet& set, const ReadOptions& options, const std::string& file) {
  if (options.component) {
    const auto found = components_asked_for(set.components, *options.component);
    if (found.size() != 1)
      throw InputError(file, 0, (found.empty() ? "component " : "one component ") + *options.component,
                       names_of(set.components));
    set.chosen = found.front();
    return;
  }
  if (set.horizontal().axis == Axis::horizontal) return;
  const std::size_t other = first_horizontal(set);
  if (other == set.chosen) return;
  const auto& given = set.components[set.chosen].provenance;
  const bool one_of_many = set.components.size() > 1 && set.components[1].provenance.file == given.file;
  set.chosen = other;
  if (one_of_many) return;
  set.warnings.push_back(fmt::format("{} is a vertical component: {} drives the horizontal axis",
                                     given.component, set.components[other].component));
}

// Components on one time base; one that is longer or shorter by a few samples is cut to the shortest.
void align(RecordSet& set) {
  std::size_t shortest = set.components.front().acceleration.size();
  for (const Record& record : set.components) shortest = std::min(shortest, record.acceleration.size());
  const double interval = set.components.front().interval;
  for (Record& record : set.components) {
    if (std::abs(record.interval - interval) > 1e-9 * interval) {
      throw InputError(record.provenance.file, 0, fmt::format("the time step of its station, {} s", interval),
                       fmt::format("{} s", record.interval));
    }
    if (record.provenance.start_time != set.components.front().provenance.start_time)
      set.warnings.push_back(fmt::format("{} starts at {}, {} at {}: not shifted", record.component,
                                         record.provenance.start_time, set.components.front().component,
                                         set.components.front().provenance.start_time));
    if (record.acceleration.size() == shortest) continue;
    set.warnings.push_back(fmt::format("{} has {} samples, cut to the {} of the shortest component",
                                       record.component, record.acceleration.size(), shortest));
    record.acceleration.resize(shortest);
  }
}

}  // namespace

std::vector<Record> read_bytes_as_record(const std::string& name, std::string bytes,
                                         const ReadOptions& options) {
  FileText text;
  set_bytes(name, std::move(bytes), text);
  return format_of(text, options).read(text, options);
}

Channels read_channels(const fs::path& path, const ReadOptions& options) {
  std::string bytes = read_bytes(path);
  Channels channels = is_archive(bytes) ? read_archive(path, bytes, options)
                                        : read_plain_file(path, std::move(bytes), options);
  number_repeated_components(channels.records);
  return channels;
}

RecordSet read_record(const fs::path& path, const ReadOptions& options) {
  Channels channels = read_channels(path, options);
  RecordSet set;
  set.warnings = std::move(channels.warnings);
  set.components = one_station(std::move(channels.records), options, path.string());
  align(set);
  choose_component(set, options, path.string());
  return set;
}

RecordSet read_records(std::span<const fs::path> paths, const ReadOptions& options) {
  if (paths.empty()) throw InputError("records", 0, "at least one file", "none");
  RecordSet set;
  ReadOptions alone = options;
  alone.siblings = false;
  for (const fs::path& path : paths)
    for (Record& record : read_channels(path, alone).records) set.components.push_back(std::move(record));
  align(set);
  choose_component(set, options, paths.front().string());
  return set;
}

}  // namespace dougong::seismic
