#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/motion_file.h"
#include "app/cli/record_output.h"
#include "app/cli/record_tools.h"
#include "app/report/record_figures.h"
#include "app/report/safe_file.h"
#include "app/report/text.h"
#include "seismic/measures/fourier_spectrum.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t spectrum_points = 240, fourier_points = 240;
constexpr double smoothing = 40.0, lowest_frequency = 0.1, fourier_step = 0.01;  // Konno and Ohmachi; Hz

std::string picture_of(const PlotOptions& o) {
  if (!o.out.empty()) return o.out;
  const std::string stem = fs::path(o.source.record).filename().string();
  return (stem.empty() ? "record" : stem) + ".png";
}

SpectrumCurve fourier_curve(const SourceMotion& m) {
  const auto frequencies =
      seismic::log_spaced_periods(lowest_frequency, std::min(50.0, 0.5 / m.interval), fourier_points);
  const auto spectrum = seismic::fourier_spectrum(m.acceleration, m.interval, fourier_step);
  return {"", frequencies, seismic::konno_ohmachi(spectrum, frequencies, smoothing)};
}

RecordSheet sheet_of(const SourceMotion& m, double damping) {
  RecordSheet sheet;
  sheet.title = m.title;
  sheet.subtitle = fmt::format("{}{}; Fourier amplitude smoothed (Konno-Ohmachi, b = {:g})",
                               m.synthetic ? "SYNTHETIC, not a recording; " : "", m.state, smoothing);
  sheet.history = seismic::integrate(m.acceleration, m.interval);
  sheet.dimensionless = m.dimensionless;
  const auto strong = seismic::significant_duration(m.acceleration, m.interval);
  sheet.rise_start = strong.start, sheet.rise_end = strong.end;
  if (!m.dimensionless)
    sheet.arias = significant(seismic::arias_intensity(m.acceleration, m.interval), 3) + " m/s";
  sheet.damping_ratio = damping;
  const auto periods = seismic::log_spaced_periods(0.02, 10.0, spectrum_points);
  sheet.spectrum = {"", periods, seismic::pseudo_accelerations(m.acceleration, m.interval, periods, damping)};
  sheet.fourier = fourier_curve(m);
  return sheet;
}

std::string histories_csv(const RecordSheet& sheet) {
  const seismic::GroundHistory& h = sheet.history;
  std::vector<double> times(h.acceleration.size());
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = h.interval * static_cast<double>(k);
  return csv_of(
      {"time_s", "acceleration_m_s2", "velocity_m_s", "displacement_m", "husid"},
      {times, h.acceleration, h.velocity, h.displacement, seismic::husid(h.acceleration, h.interval)});
}

// The peaks that the sheet marks.
nlohmann::ordered_json json_of(const RecordSheet& sheet, const std::string& picture, const std::string& csv) {
  const seismic::GroundHistory& h = sheet.history;
  const auto peak = [&](const std::vector<double>& values) {
    const seismic::Peak top = seismic::peak(values, h.interval);
    return nlohmann::ordered_json{{"value", values[top.index]}, {"time_s", top.time}};
  };
  return {{"picture", picture},
          {"csv", csv.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(csv)},
          {"title", sheet.title},
          {"dimensionless", sheet.dimensionless},
          {"acceleration_m_s2", peak(h.acceleration)},
          {"velocity_m_s", peak(h.velocity)},
          {"displacement_m", peak(h.displacement)},
          {"d5_95_s", sheet.rise_end - sheet.rise_start}};
}

}  // namespace

int record_plot_command(const PlotOptions& o) {
  const std::string picture = picture_of(o);
  check_picture(picture, o.force);
  check_new_file(o.csv, o.force);
  const double damping = damping_of(o.damping);
  const RecordSheet sheet = sheet_of(motion_of(o.source), damping);
  if (!o.csv.empty()) write_file(o.csv, histories_csv(sheet));
  write_picture(picture, record_figure(sheet));
  if (o.json)
    print_json(json_of(sheet, picture, o.csv));
  else
    fmt::print("{}\n", picture);
  return exit_survived;
}

}  // namespace dougong::app
