// A file of every format, made here: recordings belong to their owners. The same decaying sine everywhere, so
// that each reader can be asked for the same samples.
#pragma once

#include <string>
#include <vector>

#include "seismic/read_record.h"

namespace dougong::seismic::testing {

/// Sample k of the motion that all files hold: a peak of 1 m/s2 at k = 5, negative ones too; decaying to
/// k = 100, and never at rest beyond.
double sample(std::size_t k);

/// Of every file that is made; a bench of the readers asks for more.
inline std::size_t samples = 101;

struct GeneratedFile {
  std::string format;  // id in the table
  std::string bytes;
  ReadOptions options;             // what the file does not say
  std::vector<std::string> names;  // of its components, in order
  double interval = 0.01;          // s
  double precision = 1e-5;         // m/s2, of its last digit
  bool offset_removed = false;     // its reader takes the mean off
  bool takes_step = false;         // has times of its own, which another step resamples
};

GeneratedFile at2_file();
GeneratedFile knet_file();
GeneratedFile knet_csv_file();
GeneratedFile kiknet_csv_file();
GeneratedFile csmnc_file();
GeneratedFile rec_file();
GeneratedFile dyna_file();
GeneratedFile nsmn_file();
GeneratedFile csmip_v1_file();
/// Data format on the title line, or left out as older files do.
GeneratedFile csmip_v2_file(bool stated_format = true);
GeneratedFile usc_v1_file();
GeneratedFile usc_v2_file();
GeneratedFile renadic_file();
GeneratedFile bhrc_file();
GeneratedFile cosmos_v0_file();
GeneratedFile cosmos_v1_file();
GeneratedFile cosmos_v2_file();
GeneratedFile geonet_v1_file();
GeneratedFile geonet_v2_file();
/// Types 0 and 2 eight to a line; one value of 14 columns a line when `narrow` is false.
GeneratedFile smc_file(int type, bool narrow = true);
/// Type 1: (time, value) pairs, unevenly spaced when asked for.
GeneratedFile smc_pairs_file(bool even);
GeneratedFile cwa_file();
GeneratedFile unam_file();
GeneratedFile sac_file(bool big_endian);
GeneratedFile miniseed_file();
GeneratedFile record_csv_file();
GeneratedFile columns_file();

/// One of each, all variants.
std::vector<GeneratedFile> generated_files();

}  // namespace dougong::seismic::testing
