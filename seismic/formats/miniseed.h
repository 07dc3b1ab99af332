// miniSEED 2, by libmseed: any encoding it decodes, records of any number of channels.
//
// The samples carry no unit. Counts need their sensitivity: from the caller (count_scale), from a StationXML
// file the caller names, or from NET.STA.xml beside the file; the response is taken as flat, as
// accelerometers are within their band. Files of physical units need the option units. A channel with a gap
// is refused.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_miniseed(const FileText& text);
std::vector<Record> read_miniseed(const FileText& text, const ReadOptions& options);

struct MiniseedChannel {
  std::string network, station, location, channel;  // at most 2, 5, 2 and 3 characters
  std::string start_time;                           // ISO 8601; empty: 1970
  double interval = 0.0;                            // s
  std::vector<double> samples;
};

/// The bytes of a miniSEED file of 64-bit floating-point samples, exactly as given.
std::string write_miniseed(std::span<const MiniseedChannel> channels);

}  // namespace dougong::seismic
