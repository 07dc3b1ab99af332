#include "seismic/formats/station_xml.h"

#include <fmt/format.h>

#include <cmath>
#include <pugixml.hpp>
#include <string_view>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"
#include "seismic/numerics/parse_number.h"
#include "seismic/units.h"

namespace dougong::seismic {
namespace {

std::optional<double> number_in(const pugi::xml_node& node) {
  return parse_number(node.child_value());
}

// Times of ISO 8601 compare as text, as far as both go.
bool holds(const pugi::xml_node& epoch, const std::string& time) {
  const std::string start = epoch.attribute("startDate").value(), end = epoch.attribute("endDate").value();
  const std::string at = time.substr(0, 19);
  return at.empty() ||
         ((start.empty() || start.substr(0, 19) <= at) && (end.empty() || at <= end.substr(0, 19)));
}

std::string name_of(const SeedChannel& c) {
  return fmt::format("{}.{}.{}.{}", c.network, c.station, c.location, c.channel);
}

pugi::xml_node find_channel(const pugi::xml_document& document, const SeedChannel& asked) {
  for (const auto& network : document.child("FDSNStationXML").children("Network")) {
    if (network.attribute("code").value() != asked.network) continue;
    for (const auto& station : network.children("Station")) {
      if (station.attribute("code").value() != asked.station) continue;
      for (const auto& channel : station.children("Channel"))
        if (channel.attribute("code").value() == asked.channel &&
            trimmed(channel.attribute("locationCode").value()) == asked.location &&
            holds(channel, asked.start_time))
          return channel;
    }
  }
  return {};
}

// "M/S**2" and its like.
std::optional<double> unit_of(std::string name) {
  for (auto at = name.find("**"); at != std::string::npos; at = name.find("**")) name.replace(at, 2, "^");
  return acceleration_unit(name);
}

}  // namespace

ChannelResponse read_response(const std::filesystem::path& path, const SeedChannel& asked) {
  const std::string bytes = read_bytes(path);
  pugi::xml_document document;
  const auto parsed = document.load_buffer(bytes.data(), bytes.size());
  if (!parsed) throw InputError(path.string(), 0, "StationXML", parsed.description());
  const pugi::xml_node channel = find_channel(document, asked);
  if (!channel)
    throw InputError(path.string(), 0, fmt::format("channel {} at {}", name_of(asked), asked.start_time),
                     "none");
  const pugi::xml_node stated = channel.child("Response").child("InstrumentSensitivity");
  const auto value = number_in(stated.child("Value"));
  const std::string units = stated.child("InputUnits").child_value("Name");
  const auto unit = unit_of(units);
  if (!value || *value == 0.0 || !unit)
    throw InputError(path.string(), 0,
                     "an InstrumentSensitivity of " + name_of(asked) + " to an acceleration",
                     value ? in_quotes(units) : "none");
  ChannelResponse response;
  response.sensitivity = *value / *unit;
  response.place = {number_in(channel.child("Latitude")).value_or(0.0),
                    number_in(channel.child("Longitude")).value_or(0.0),
                    number_in(channel.child("Elevation"))};
  response.azimuth = number_in(channel.child("Azimuth"));
  return response;
}

}  // namespace dougong::seismic
