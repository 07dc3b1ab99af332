#include "app/cli/record_facts.h"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

ordered_json place_json(const std::optional<seismic::Place>& place) {
  if (!place) return nullptr;
  const ordered_json height = place->height ? ordered_json(*place->height) : ordered_json(nullptr);
  return {{"latitude_deg", place->latitude}, {"longitude_deg", place->longitude}, {"height_m", height}};
}

std::string place_text(const std::optional<seismic::Place>& place) {
  if (!place) return {};
  const std::string height = place->height ? fmt::format(", {:g} m", *place->height) : "";
  return fmt::format("{:g} N {:g} E{}", place->latitude, place->longitude, height);
}

}  // namespace

ordered_json facts_json(const seismic::Record& record) {
  const seismic::Provenance& from = record.provenance;
  const ordered_json azimuth = record.azimuth ? ordered_json(*record.azimuth) : ordered_json(nullptr);
  return {{"azimuth_deg", azimuth},
          {"sensor", from.sensor},
          {"member", from.member},
          {"start_time", from.start_time},
          {"scale", from.scale},
          {"treatment", from.treatment},
          {"stated_peak_m_s2", from.stated_peak ? ordered_json(*from.stated_peak) : ordered_json(nullptr)},
          {"station_place", place_json(from.station_place)},
          {"hypocentre", place_json(from.hypocentre)}};
}

void print_facts(const seismic::Record& record) {
  const seismic::Provenance& from = record.provenance;
  const auto row = [](const char* name, const std::string& value) {
    if (!value.empty()) fmt::print("  {:<12}{}\n", name, value);
  };
  row("direction", record.azimuth ? fmt::format("{:g} degrees from north", *record.azimuth) : "");
  row("sensor", from.sensor);
  row("member", from.member);
  row("start", from.start_time);
  row("scale", from.scale);
  row("stated peak", from.stated_peak ? fmt::format("{:.6g} m/s2", *from.stated_peak) : "");
  row("publisher", from.treatment);
  row("station at", place_text(from.station_place));
  row("hypocentre", place_text(from.hypocentre));
}

}  // namespace dougong::app
