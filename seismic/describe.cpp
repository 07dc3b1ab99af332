#include "seismic/describe.h"

#include <fmt/format.h>

#include "seismic/measures/fourier_spectrum.h"
#include "seismic/measures/integrate.h"
#include "seismic/measures/intensity.h"
#include "seismic/measures/peaks.h"
#include "seismic/measures/response_spectrum.h"
#include "seismic/measures/spectrum_intensity.h"

namespace dougong::seismic {
namespace {

constexpr double bracket = 0.05;  // g, the usual threshold

void copy_facts(const Record& record, RecordInfo& info) {
  const Provenance& from = record.provenance;
  info.event = from.event;
  info.station = from.station;
  info.component = record.component;
  info.axis = record.axis == Axis::vertical ? "vertical" : "horizontal";
  info.units = from.units;
  info.format = from.format;
  info.file = from.file;
  info.sha256 = from.sha256;
  info.dimensionless = record.dimensionless;
  info.synthetic = from.synthetic;
  info.processed = from.processed;
  info.samples = record.acceleration.size();
  info.interval = record.interval;
  info.duration = record.duration();
  info.header = from.header;
  info.processing = record.processing;
  info.warnings = record.warnings;
}

void measure_drift(const Record& record, RecordInfo& info) {
  std::vector<double> a = record.acceleration;
  const double offset = mean(a);
  for (double& value : a) value -= offset;
  const GroundHistory history = integrate(a, record.interval);
  info.pgv = peak(history.velocity, record.interval).value;
  info.pgd = peak(history.displacement, record.interval).value;
}

}  // namespace

RecordInfo describe(const Record& record, double gravity) {
  RecordInfo info;
  copy_facts(record, info);
  const auto& a = record.acceleration;
  const double h = record.interval;
  const Peak top = peak(a, h);
  info.pga = top.value;
  info.pga_time = top.time;
  info.peak = a.empty() ? 0.0 : a[top.index];
  measure_drift(record, info);
  info.arias = arias_intensity(a, h, gravity);
  info.cav = cumulative_absolute_velocity(a, h);
  const SignificantDuration strong = significant_duration(a, h);
  info.t5 = strong.start;
  info.t95 = strong.end;
  info.d5_95 = strong.duration();
  info.d5_75 = significant_duration(a, h, 0.05, 0.75).duration();
  info.bracketed = bracketed_duration(a, h, bracket * gravity);
  info.rms = rms_acceleration(a, h);
  info.housner = housner_intensity(a, h);
  const auto psa = [&](double period) { return spectral_point(a, h, period).pseudo_acceleration; };
  info.psa_0_2 = psa(0.2);
  info.psa_0_5 = psa(0.5);
  info.psa_1_0 = psa(1.0);
  info.psa_2_0 = psa(2.0);
  return info;
}

std::vector<Measure> measures(std::span<const double> a, double h, const MeasureOptions& o) {
  const GroundHistory history = integrate(a, h);
  const SignificantDuration strong = significant_duration(a, h);
  const std::string threshold = fmt::format("{:.3g} g", o.threshold / o.gravity);
  const std::string damping = fmt::format("{:g} % damping", 100.0 * o.damping_ratio);
  return {
      {"PGA", peak(a, h).value, "m/s2",
       fmt::format("peak ground acceleration, at {:.2f} s", peak(a, h).time)},
      {"PGV", peak(history.velocity, h).value, "m/s", "peak ground velocity"},
      {"PGD", peak(history.displacement, h).value, "m", "peak ground displacement"},
      {"Arias", arias_intensity(a, h, o.gravity), "m/s", "Arias intensity, trapezoid of a^2"},
      {"CAV", cumulative_absolute_velocity(a, h), "m/s", "cumulative absolute velocity"},
      {"CAV standardised", standardised_cav(a, h, o.cav_threshold), "m/s",
       fmt::format("CAV of the seconds that reach {:.3g} g", o.cav_threshold / o.gravity)},
      {"D5-95", strong.duration(), "s",
       fmt::format("5-95 % of the Arias intensity, from {:.2f} s", strong.start)},
      {"D5-75", significant_duration(a, h, 0.05, 0.75).duration(), "s", "5-75 % of the Arias intensity"},
      {"bracketed", bracketed_duration(a, h, o.threshold), "s", "first to last " + threshold},
      {"uniform", uniform_duration(a, h, o.threshold), "s", "in all at or above " + threshold},
      {"rms", rms_acceleration(a, h), "m/s2", "root mean square over the whole motion"},
      {"Housner", housner_intensity(a, h, o.damping_ratio), "m",
       "integral of PSv over 0.1-2.5 s, " + damping},
      {"ASI", acceleration_spectrum_intensity(a, h, o.damping_ratio), "m/s",
       "integral of Sa over 0.1-0.5 s, " + damping},
      {"VSI", velocity_spectrum_intensity(a, h, o.damping_ratio), "m",
       "integral of Sv over 0.1-2.5 s, " + damping},
      {"mean period", mean_period(a, h), "s", "Rathje et al. 1998, 0.25-20 Hz"},
      {"predominant period", predominant_period(a, h, log_spaced_periods(0.02, 10.0, 300), o.damping_ratio),
       "s", "of the greatest Sa, " + damping},
  };
}

}  // namespace dougong::seismic
