#include "seismic/stations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace dougong::seismic {

std::string station_of(const Record& record) {
  const Provenance& from = record.provenance;
  return from.sensor.empty() ? from.station : from.station + "." + from.sensor;
}

std::vector<Station> group_by_station(std::vector<Record> records) {
  std::vector<Station> stations;
  for (Record& record : records) {
    const std::string name = station_of(record);
    auto station = std::find_if(stations.begin(), stations.end(),
                                [&](const Station& known) { return known.name == name; });
    if (station == stations.end()) station = stations.insert(stations.end(), Station{name, {}});
    station->channels.push_back(std::move(record));
  }
  return stations;
}

void number_repeated_components(std::vector<Record>& records) {
  std::map<std::pair<std::string, std::string>, int> met;
  for (Record& record : records) {
    const int count = ++met[{station_of(record), record.component}];
    if (count > 1) record.component += fmt::format("#{}", count);
  }
}

}  // namespace dougong::seismic
