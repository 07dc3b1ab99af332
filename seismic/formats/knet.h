// K-NET and KiK-net ASCII: 17 header lines, each a label padded to 18 columns, then integer counts.
//
//   a [gal] = count * A / B,   "Scale Factor      A(gal)/B"
//
// The counts carry the instrument's offset, often far larger than the motion: the whole-record mean is
// taken off on reading (then the peak equals the header's "Max. Acc."), and the record says so. Times are of
// Japan; the record time is 15 s after the first sample (NIED, "About K-NET ASCII format").
// Components of a station lie side by side: .EW .NS .UD, borehole .EW1 ..., surface .EW2 ...
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "seismic/formats/file_text.h"
#include "seismic/read_record.h"
#include "seismic/record.h"

namespace dougong::seismic {

bool is_knet(const FileText& text);
Record read_knet(const FileText& text, const ReadOptions& options);
/// The given path and the paths of the other components of the same sensor, whether they exist or not.
std::vector<std::filesystem::path> knet_siblings(const std::filesystem::path& path);

/// The component of a "Dir." entry: "E-W" is EW, the digits of KiK-net are NS1 EW1 UD1 NS2 EW2 UD2.
std::string knet_component(const std::string& direction);
/// "1" (borehole) or "2" (surface) of KiK-net, empty for K-NET.
std::string knet_sensor(const std::string& component);

struct KnetSheet {
  std::string origin_time, latitude, longitude, depth, magnitude;
  std::string station_code, station_latitude, station_longitude, station_height;
  std::string record_time, direction, memo;
  int sampling_frequency = 100;  // Hz
  double scale_gal = 0.0;        // A of the scale factor
  long scale_counts = 0;         // B of the scale factor
  std::vector<long> counts;
};

/// The bytes of a K-NET ASCII file, LF line ends.
std::string write_knet(const KnetSheet& sheet);

}  // namespace dougong::seismic
