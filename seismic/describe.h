// What there is to know of one record: facts of the file and measures of the motion.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "seismic/constants.h"
#include "seismic/record.h"

namespace dougong::seismic {

/// Measures are of the record as read (a K-NET offset is off already). PGV and PGD come from integration from
/// rest after the whole-record mean is removed and nothing else: PGD still holds the long-period drift that
/// conditioning takes out. Of a dimensionless record, accelerations are multiples of its peak.
struct RecordInfo {
  std::string event, station, component, axis, units, format, file, sha256;
  bool dimensionless = false, synthetic = false, processed = false;
  std::size_t samples = 0;
  double interval = 0.0;                                              // s
  double duration = 0.0;                                              // s
  double pga = 0.0, pga_time = 0.0;                                   // m/s2, s
  double peak = 0.0;                                                  // m/s2, the PGA with its sign
  double pgv = 0.0, pgd = 0.0;                                        // m/s, m
  double arias = 0.0;                                                 // m/s, trapezoid of a^2
  double cav = 0.0;                                                   // m/s
  double d5_95 = 0.0, t5 = 0.0, t95 = 0.0;                            // s
  double d5_75 = 0.0;                                                 // s
  double bracketed = 0.0;                                             // s, 0.05 g
  double rms = 0.0;                                                   // m/s2
  double housner = 0.0;                                               // m
  double psa_0_2 = 0.0, psa_0_5 = 0.0, psa_1_0 = 0.0, psa_2_0 = 0.0;  // m/s2, 5 %, at those periods (s)
  std::vector<std::pair<std::string, std::string>> header;
  std::vector<std::string> processing, warnings;
};

RecordInfo describe(const Record& record, double gravity = standard_gravity);

struct Measure {
  std::string name;     // "PGA"
  double value = 0.0;   // SI
  std::string unit;     // "m/s2"
  std::string meaning;  // one line
};

struct MeasureOptions {
  double gravity = standard_gravity;
  double damping_ratio = 0.05;                      // of the spectral ones
  double threshold = 0.05 * standard_gravity;       // m/s2, of bracketed and uniform duration
  double cav_threshold = 0.025 * standard_gravity;  // m/s2, of the standardised CAV
};

/// Of any history that starts from rest (the motion applied): PGA, PGV, PGD, Arias, CAV and standardised CAV,
/// D5-95, D5-75, bracketed and uniform duration, rms, Housner, ASI, VSI, mean and predominant period.
std::vector<Measure> measures(std::span<const double> acceleration, double interval,
                              const MeasureOptions& options = {});

}  // namespace dougong::seismic
