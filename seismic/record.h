// A recorded motion: one component as samples of acceleration, and the components of one station.
//
// Samples are in m/s2, `interval` apart, the motion linear between them. A dimensionless record is a
// shape (its author divided it by its peak): it has no PGA until one is chosen.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dougong::seismic {

enum class Axis { horizontal, vertical };

struct Place {
  double latitude = 0.0, longitude = 0.0;  // degrees, north and east positive
  std::optional<double> height;            // m above the sea; of a hypocentre negative
};

/// Where a record comes from and how it was written. Empty where the file does not say.
struct Provenance {
  std::string event;
  std::string station;
  std::string component;   // as the file says it
  std::string sensor;      // location code, or the borehole's 1 and the surface's 2 of KiK-net
  std::string units;       // as found in the file, or as the caller declared them
  std::string scale;       // what made m/s2 of the file's numbers
  std::string treatment;   // by the publisher, in the file's words: filters, baseline
  std::string start_time;  // of the first sample, ISO 8601, with its zone where the file names one
  std::optional<Place> station_place, hypocentre;
  std::string format;                 // title of the format
  std::string file;                   // path as given
  std::string member;                 // of the archive that the file is
  std::optional<double> stated_peak;  // m/s2, greatest |a| as the file itself states it
  std::string sha256;                 // of the file's bytes
  bool synthetic = false;             // the file says it is no recording
  bool processed = false;  // the file says, or its format implies, that it was filtered by its publisher
  std::vector<std::pair<std::string, std::string>> header;  // facts as found
};

struct Record {
  std::vector<double> acceleration;  // m/s2; of peak about 1 when dimensionless
  double interval = 0.0;             // s
  std::string component;             // "EW", "NS", "UD", "180" ...
  Axis axis = Axis::horizontal;
  std::optional<double> azimuth;  // degrees clockwise from north of the positive direction, where it is known
  bool dimensionless = false;
  Provenance provenance;
  std::vector<std::string> processing;  // what the reader did to the samples, with numbers
  std::vector<std::string> warnings;

  double duration() const {
    return acceleration.empty() ? 0.0 : interval * static_cast<double>(acceleration.size() - 1);
  }
};

/// The components of one station, on one time base. `chosen` drives the horizontal axis.
struct RecordSet {
  std::vector<Record> components;
  std::size_t chosen = 0;
  std::vector<std::string> warnings;

  const Record& horizontal() const { return components.at(chosen); }
  const Record* vertical() const {
    for (const Record& record : components) {
      if (record.axis == Axis::vertical) return &record;
    }
    return nullptr;
  }
};

/// Vertical for the names in use ("UD", "U-D", "UP", "V", "Z", "HNZ", "DWN" ...), else horizontal.
Axis axis_of(std::string_view component);

}  // namespace dougong::seismic
