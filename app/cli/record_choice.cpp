#include "app/cli/record_choice.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "app/study/motion_input.h"
#include "app/study/scene_build.h"

namespace dougong::app {
namespace {

// The channel that a run would choose. Of several stations none is chosen.
std::optional<std::size_t> chosen_of(const RecordInfoOptions& options, const seismic::Channels& channels) {
  if (options.component.empty() && options.station.empty() && options.more.empty() &&
      seismic::group_by_station(channels.records).size() > 1)
    return std::nullopt;
  const seismic::Record driver = read_asked_record(options).horizontal();
  for (std::size_t i = 0; i < channels.records.size(); ++i) {
    const seismic::Record& record = channels.records[i];
    if (record.component == driver.component && seismic::station_of(record) == seismic::station_of(driver))
      return i;
  }
  return std::nullopt;
}

}  // namespace

Override record_override(const std::string& text) {
  std::error_code error;
  if (std::filesystem::exists(text, error) || names_a_file(text)) return {"record.file", text, "--record"};
  return {"record.name", text, "--record"};
}

RecordChoice record_choice(const RecordInfoOptions& options) {
  std::vector<Override> overrides{record_override(options.record)};
  const auto add = [&](const char* key, const std::string& value, const char* flag) {
    if (!value.empty()) overrides.push_back({key, value, flag});
  };
  add("record.component", options.component, "--component");
  add("record.station", options.station, "--station");
  add("record.member", options.member, "--member");
  add("record.response", options.response, "--response");
  add("record.units", options.units, "--units");
  add("record.interval", options.interval, "--interval");
  add("record.count_scale", options.count_scale, "--count-scale");
  return scenario_from(overrides).record;
}

seismic::RecordSet read_asked_record(const RecordInfoOptions& options) {
  const RecordChoice choice = record_choice(options);
  if (options.more.empty()) return read_scenario_record(choice, records_directory());
  std::vector<std::filesystem::path> paths{options.record};
  paths.insert(paths.end(), options.more.begin(), options.more.end());
  return seismic::read_records(paths, read_options(choice));
}

AskedChannels read_asked_channels(const RecordInfoOptions& options) {
  const RecordChoice choice = record_choice(options);
  if (!options.more.empty()) {
    seismic::RecordSet set = read_asked_record(options);
    return {{std::move(set.components), std::move(set.warnings)}, set.chosen};
  }
  AskedChannels asked{read_scenario_channels(choice, records_directory()), std::nullopt};
  asked.chosen = chosen_of(options, asked.channels);
  return asked;
}

}  // namespace dougong::app
