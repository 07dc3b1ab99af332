#include "seismic/read_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "seismic/formats/format.h"

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

const Format& format_of(const FileText& text, const ReadOptions& options) {
  if (options.format) return named_format(*options.format);
  for (const Format& format : formats()) {
    if (format.recognises(text)) return format;
  }
  throw InputError(text.name, 0, "a known format (tried: " + titles_tried() + ")",
                   in_quotes(trimmed(text.lines.front().substr(0, 60))));
}

struct OneFile {
  Record record;
  const Format* format = nullptr;
};

OneFile read_file(const fs::path& path, const ReadOptions& options) {
  FileText text;
  load_file(path, text);
  const Format& format = format_of(text, options);
  return {format.read(text, options), &format};
}

// "E-W", "EW2" and "ew" all ask for EW.
std::string plain_component(std::string_view name) {
  std::string plain;
  for (const char c : upper_case(name)) {
    if (c != '-' && c != '_' && c != '.' && c != ' ') plain += c;
  }
  if (plain.size() == 3 && (plain[2] == '1' || plain[2] == '2')) plain.pop_back();
  return plain;
}

bool is_asked_for(const Record& record, const std::string& component) {
  return upper_case(record.component) == upper_case(component) ||
         plain_component(record.component) == plain_component(component);
}

void choose_component(RecordSet& set, const ReadOptions& options, const std::string& file) {
  std::string found;
  for (std::size_t i = 0; i < set.components.size(); ++i) {
    found += (i ? ", " : "") + set.components[i].component;
    if (options.component && is_asked_for(set.components[i], *options.component)) {
      set.chosen = i;
      return;
    }
  }
  if (options.component) throw InputError(file, 0, "component " + *options.component, found);
  if (set.horizontal().axis == Axis::horizontal) return;
  for (std::size_t i = 0; i < set.components.size(); ++i) {
    if (set.components[i].axis == Axis::vertical) continue;
    set.warnings.push_back(fmt::format("{} is a vertical component: {} drives the horizontal axis",
                                       set.horizontal().component, set.components[i].component));
    set.chosen = i;
    return;
  }
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
    if (record.acceleration.size() == shortest) continue;
    set.warnings.push_back(fmt::format("{} has {} samples, cut to the {} of the shortest component",
                                       record.component, record.acceleration.size(), shortest));
    record.acceleration.resize(shortest);
  }
}

}  // namespace

RecordSet read_record(const fs::path& path, const ReadOptions& options) {
  RecordSet set;
  OneFile given = read_file(path, options);
  set.components.push_back(std::move(given.record));
  if (options.siblings && given.format->siblings) {
    for (const fs::path& sibling : given.format->siblings(path)) {
      std::error_code failed;
      if (sibling == path || !fs::is_regular_file(sibling, failed)) continue;
      set.components.push_back(read_file(sibling, options).record);
    }
  }
  align(set);
  choose_component(set, options, path.string());
  return set;
}

RecordSet read_records(std::span<const fs::path> paths, const ReadOptions& options) {
  if (paths.empty()) throw InputError("records", 0, "at least one file", "none");
  RecordSet set;
  for (const fs::path& path : paths) set.components.push_back(read_file(path, options).record);
  align(set);
  choose_component(set, options, paths.front().string());
  return set;
}

}  // namespace dougong::seismic
