#include "app/cli/record_choice.h"

#include <filesystem>
#include <vector>

#include "app/study/motion_input.h"
#include "app/study/scene_build.h"

namespace dougong::app {
namespace {

// The channel that read_scenario_record would choose. Of several stations none is chosen.
std::optional<std::size_t> chosen_of(const RecordChoice& choice, const seismic::Channels& channels) {
  if (choice.component.empty() && choice.station.empty() &&
      seismic::group_by_station(channels.records).size() > 1)
    return std::nullopt;
  const seismic::Record driver = read_scenario_record(choice, records_directory()).horizontal();
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

AskedChannels read_asked_channels(const RecordInfoOptions& options) {
  const RecordChoice choice = record_choice(options);
  AskedChannels asked{read_scenario_channels(choice, records_directory()), std::nullopt};
  asked.chosen = chosen_of(choice, asked.channels);
  return asked;
}

}  // namespace dougong::app
