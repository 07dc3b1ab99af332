// Records in the formats that others read.
//
//   format     a file for each   precision of a sample                     what is lost
//   AT2        component         8 digits, 5e-8 of it                      -
//   K-NET      component         half a count: 6e-8 of the peak            the mean, on reading
//   CSMNC      component         7 digits, 5e-7 of it                      -
//   CSV        station           exact                                     -
//   miniSEED   station           exact; holds no unit: m/s2                -
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "seismic/record.h"

namespace dougong::seismic {

enum class WrittenFormat { at2, knet, csmnc, csv, miniseed };

/// "at2", "knet", "csmnc", "csv", "miniseed" or "mseed", any case.
std::optional<WrittenFormat> written_format(std::string_view name);

struct WrittenFile {
  std::string suffix;  // behind the stem of the name: "-EW.AT2", ".EW", ".csv"
  std::string bytes;
  std::vector<std::string> components;
};

/// Components of one station, of one step and length. Throws InputError for what the format cannot hold: a
/// dimensionless record anywhere; in K-NET a direction other than north, east and up, and a rate that is no
/// whole number of hertz.
std::vector<WrittenFile> write_records(std::span<const Record> components, WrittenFormat format);

}  // namespace dougong::seismic
