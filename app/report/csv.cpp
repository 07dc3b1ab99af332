#include "app/report/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "app/report/text.h"
#include "app/study/floor_spectra.h"
#include "app/study/output_times.h"

namespace dougong::app {
namespace {

using structures::StoreyResponse;

/// A column: its header and the text of its cell in a row.
struct Column {
  std::string header;
  std::function<std::string(std::size_t)> cell;
};

std::string cell_at(const std::vector<double>& values, std::size_t row) {
  return row < values.size() ? exact(values[row]) : "";
}

Column numbers(const std::string& header, const std::vector<double>& values) {
  return {header, [&values](std::size_t row) { return cell_at(values, row); }};
}

std::string table(const std::vector<Column>& columns, std::size_t rows) {
  std::string out;
  for (std::size_t i = 0; i < columns.size(); ++i) out += (i == 0 ? "" : ",") + csv_text(columns[i].header);
  out += "\n";
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) out += (i == 0 ? "" : ",") + columns[i].cell(row);
    out += "\n";
  }
  return out;
}

using History = std::vector<double> StoreyResponse::*;

/// For every storey its history, empty once lost, and the flag.
std::string histories_csv(const RunResult& run, const std::string& quantity, History history) {
  const auto& times = run.response.times;
  std::vector<Column> columns{numbers("time (s)", times)};
  for (const StoreyResponse& storey : run.response.storeys) {
    const auto lost = [&](std::size_t row) { return storey.lost_at && times[row] >= *storey.lost_at; };
    columns.push_back({storey.name + " " + quantity, [&storey, lost, history](std::size_t row) {
                         return lost(row) ? "" : cell_at(storey.*history, row);
                       }});
    columns.push_back({storey.name + " lost", [lost](std::size_t row) { return lost(row) ? "1" : "0"; }});
  }
  return table(columns, times.size());
}

}  // namespace

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string drift_csv(const RunResult& run) {
  return histories_csv(run, "interstorey drift ratio (1)", &StoreyResponse::drift);
}

std::string shear_drift_csv(const RunResult& run) {
  return histories_csv(run, "drift ratio without base rotation (1)", &StoreyResponse::shear_drift);
}

std::string acceleration_csv(const RunResult& run) {
  return histories_csv(run, "floor acceleration absolute (m/s2)", &StoreyResponse::floor_acceleration);
}

std::string roof_and_base_shear_csv(const RunResult& run) {
  const auto& r = run.response;
  const Column ratio{"base shear over weight (1)", [&r](std::size_t row) {
                       return row < r.base_shear.size() && r.weight > 0 ? exact(r.base_shear[row] / r.weight)
                                                                        : "";
                     }};
  return table(
      {numbers("time (s)", r.times), numbers("roof displacement relative to ground (m)", r.roof_displacement),
       numbers("base shear (N)", r.base_shear), ratio,
       numbers("overturning moment (N m)", r.overturning_moment)},
      r.times.size());
}

std::string damage_csv(const RunResult& run) {
  const auto time = [](double t) { return t < DrawnBond::never ? exact(t) : std::string(); };
  std::string text = "bond,storey,mode,cracked (s),crushed (s),broken (s)\n";
  for (const DrawnBond& bond : run.model.bonded)
    text += csv_text(bond.name) + "," + csv_text(storey_of(run.model, bond)) + "," + bond.mode + "," +
            time(bond.cracked) + "," + time(bond.crushed) + "," + time(bond.broken) + "\n";
  return text;
}

std::string floor_spectra_csv(const FloorSpectra& spectra) {
  std::vector<Column> columns{numbers("period (s)", spectra.periods),
                              numbers("ground PSa 5 % (m/s2)", spectra.ground)};
  for (const FloorSpectrum& floor : spectra.floors)
    columns.push_back(numbers(floor.name + " PSa 5 % (m/s2)", floor.psa));
  return table(columns, spectra.periods.size());
}

std::string energy_csv(const RunResult& run) {
  const EnergyHistory& e = run.energy;
  std::vector<Column> columns{numbers("time (s)", output_times(run)), numbers("input (J)", e.input),
                              numbers("kinetic (J)", e.kinetic),      numbers("gravity (J)", e.gravity),
                              numbers("elastic (J)", e.elastic),      numbers("friction (J)", e.friction),
                              numbers("damping (J)", e.damping),      numbers("error (J)", e.error)};
  if (run.model.bonds > 0) columns.insert(columns.end() - 1, numbers("fracture (J)", e.fracture));
  if (std::ranges::any_of(e.field, [](double value) { return value != 0.0; }))
    columns.insert(columns.end() - 1, numbers("field (J)", e.field));
  return table(columns, output_times(run).size());
}

std::string storeys_csv(const RunResult& run) {
  std::string text =
      "storey,height (m),peak drift + (1),at (s),peak drift - (1),at (s),residual drift (1),"
      "peak drift without base rotation + (1),peak drift without base rotation - (1),"
      "peak floor acceleration + (m/s2),at (s),peak floor acceleration - (m/s2),at (s),lost at (s)\n";
  const auto peak = [](const structures::Peak& p) { return exact(p.value) + "," + exact(p.time); };
  for (const StoreyResponse& s : run.response.storeys)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_text(s.name), exact(s.height),
                        peak(s.peak_drift.positive), peak(s.peak_drift.negative), exact(s.residual_drift),
                        exact(s.peak_shear_drift.positive.value), exact(s.peak_shear_drift.negative.value),
                        peak(s.peak_acceleration.positive), peak(s.peak_acceleration.negative),
                        s.lost_at ? exact(*s.lost_at) : "");
  return text;
}

std::string overlap_csv(const RunResult& run) {
  const Numerics& n = run.numerics;
  return table({numbers("time (s)", output_times(run)), numbers("deepest overlap ratio (1)", n.overlap_ratio),
                numbers("mean overlap ratio (1)", n.mean_overlap_ratio)},
               output_times(run).size());
}

// Sd = PSa / omega^2.
std::string spectrum_csv(const MotionSheet& m) {
  const Column displacement{"Sd 5 % (m)", [&m](std::size_t row) {
                              const double omega = 2.0 * std::numbers::pi / m.spectrum_periods[row];
                              return exact(m.spectrum_psa[row] / (omega * omega));
                            }};
  return table(
      {numbers("period (s)", m.spectrum_periods), numbers("PSa 5 % (m/s2)", m.spectrum_psa), displacement},
      m.spectrum_periods.size());
}

std::string motion_csv(const RunResult& run) {
  const MotionSheet& m = run.motion;
  std::vector<Column> columns{
      numbers("time (s)", m.times), numbers("acceleration x (m/s2)", m.acceleration_x),
      numbers("velocity x (m/s)", m.velocity_x), numbers("displacement x (m)", m.displacement_x)};
  if (!m.acceleration_y.empty()) {
    columns.push_back(numbers("acceleration y (m/s2)", m.acceleration_y));
    columns.push_back(numbers("velocity y (m/s)", m.velocity_y));
    columns.push_back(numbers("displacement y (m)", m.displacement_y));
  }
  return table(columns, m.times.size());
}

}  // namespace dougong::app
