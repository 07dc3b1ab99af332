#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "seismic/measures/rotated.h"
#include "seismic/rotate.h"

namespace dougong::app {
namespace {

using nlohmann::ordered_json;

double in_degrees(double angle) {
  return angle * 180.0 / std::numbers::pi;
}

double known_azimuth(const seismic::Record& record) {
  if (record.azimuth) return *record.azimuth;
  refuse("--azimuth",
         fmt::format("expected components that say theirs (NS, EW, 090), found \"{}\"; --angle turns from "
                     "the first component towards the second",
                     record.component));
}

seismic::NorthEast north_east_of(const seismic::Record& first, const seismic::Record& second) {
  const double z1 = known_azimuth(first), z2 = known_azimuth(second);
  try {
    return seismic::north_east(first.acceleration, z1, second.acceleration, z2);
  } catch (const std::invalid_argument& error) {
    refuse("--azimuth", fmt::format("{}: found {:g} and {:g} degrees", error.what(), z1, z2));
  }
}

struct Turned {
  std::vector<double> acceleration;
  std::string component;
  std::string how;
};

Turned at_azimuth(const seismic::Record& first, const seismic::Record& second, double azimuth) {
  const seismic::NorthEast motion = north_east_of(first, second);
  return {seismic::rotate(motion.north, motion.east, azimuth),
          fmt::format("{:03g}", std::fmod(azimuth + 360.0, 360.0)),
          fmt::format("azimuth {:g} degrees", azimuth)};
}

Turned turned(const RotateOptions& o, const seismic::Record& first, const seismic::Record& second) {
  if (!o.azimuth.empty())
    return at_azimuth(first, second, in_degrees(quantity_of(o.azimuth, Dimension::angle, "--azimuth")));
  const double angle = o.largest ? seismic::rotated_peaks(first.acceleration, second.acceleration).angle100
                                 : in_degrees(quantity_of(o.angle, Dimension::angle, "--angle"));
  return {seismic::rotated(first.acceleration, second.acceleration, angle), fmt::format("R{:03.0f}", angle),
          fmt::format("{:g} degrees from {} towards {}", angle, first.component, second.component)};
}

}  // namespace

int record_rotate_command(const RotateOptions& o) {
  if (!o.azimuth.empty() + !o.angle.empty() + o.largest != 1)
    refuse("record rotate", "expected one of --azimuth, --angle and --largest");
  if (o.source.condition || !o.source.set.empty())
    refuse("--condition", "a pair is turned as it was read; process the turned motion");
  if (!o.out.empty()) check_motion_file(o.out, o.force);
  const seismic::RecordSet set = read_source(o.source);
  const auto [first, second] = horizontal_pair(set);
  const Turned out = turned(o, *first, *second);
  const seismic::RotatedPeaks peaks = seismic::rotated_peaks(first->acceleration, second->acceleration);
  const double pga = seismic::peak(out.acceleration, first->interval).value;
  if (!o.out.empty()) {
    const std::string what =
        first->provenance.synthetic ? "SYNTHETIC motion, turned by dougong" : "Motion turned by dougong";
    write_motion(o.out, {what, first->provenance.event, first->provenance.station, out.component},
                 first->interval, out.acceleration, o.force);
  }
  if (o.json) {
    print_json({{"component", out.component},
                {"how", out.how},
                {"pga_m_s2", pga},
                {"rotd00_pga_m_s2", peaks.rotd00},
                {"rotd50_pga_m_s2", peaks.rotd50},
                {"rotd100_pga_m_s2", peaks.rotd100},
                {"rotd100_angle_deg", peaks.angle100},
                {"dt_s", first->interval},
                {"npts", out.acceleration.size()}});
    return exit_survived;
  }
  fmt::print(
      "{} and {} turned to {}\n  PGA {:.6g} m/s2; of all angles: RotD00 {:.6g}, RotD50 {:.6g}, RotD100 "
      "{:.6g} m/s2 "
      "(at {:g} degrees)\n",
      title_of(*first), second->component, out.how, pga, peaks.rotd00, peaks.rotd50, peaks.rotd100,
      peaks.angle100);
  return exit_survived;
}

}  // namespace dougong::app
