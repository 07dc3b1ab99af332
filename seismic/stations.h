// Channels of one station belong together: the same station and the same sensor (borehole and surface are
// two).
#pragma once

#include <string>
#include <vector>

#include "seismic/record.h"

namespace dougong::seismic {

/// "AOM001", "TKYH12.2": station and sensor.
std::string station_of(const Record& record);

struct Station {
  std::string name;
  std::vector<Record> channels;  // in the order found
};

/// In the order in which the stations first appear.
std::vector<Station> group_by_station(std::vector<Record> records);

/// Gives every channel of a station a name of its own: the second "90" becomes "90#2".
void number_repeated_components(std::vector<Record>& records);

}  // namespace dougong::seismic
