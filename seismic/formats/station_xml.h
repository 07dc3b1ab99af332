// FDSN StationXML 1.x, as far as counts need it: the overall sensitivity of one channel at one time.
//
//   <Network code="CI"><Station code="CLC"><Channel code="HNE" locationCode="">
//     <Response><InstrumentSensitivity><Value>213945.0</Value><InputUnits><Name>M/S**2</Name> ...
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "seismic/record.h"

namespace dougong::seismic {

struct SeedChannel {
  std::string network, station, location, channel;
  std::string start_time;  // ISO 8601: which of the channel's epochs
};

struct ChannelResponse {
  double sensitivity = 0.0;  // counts per m/s2
  Place place;
  std::optional<double> azimuth;  // degrees clockwise from north
};

/// The epoch of the channel that holds its start time. Throws InputError: no XML, no such channel, no
/// sensitivity, or one to something else than an acceleration.
ChannelResponse read_response(const std::filesystem::path& path, const SeedChannel& channel);

}  // namespace dougong::seismic
