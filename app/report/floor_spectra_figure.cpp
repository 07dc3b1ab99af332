// The response spectra of the floors, over that of the ground.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/log_axes.h"
#include "app/report/text.h"
#include "app/study/floor_spectra.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

constexpr int width = 880, height = 440, left = 84, right = 100, top = 66, bottom = 56;  // px
constexpr std::size_t most_floors = 7;  // as many as have colours of their own

std::string data_of(const std::vector<double>& periods, const std::vector<double>& psa) {
  std::string out;
  for (std::size_t i = 0; i < periods.size(); ++i)
    if (psa[i] > 0.0) out += fmt::format("{:.6g} {:.6g}\n", periods[i], psa[i] / engine::standard_gravity);
  return out;
}

/// The roof, and the others evenly down.
std::vector<std::size_t> drawn_floors(std::size_t floors) {
  std::vector<std::size_t> chosen;
  const std::size_t drawn = std::min(floors, most_floors);
  for (std::size_t i = 0; i < drawn; ++i) chosen.push_back(drawn > 1 ? i * (floors - 1) / (drawn - 1) : 0);
  return chosen;
}

Range psa_range(const FloorSpectra& spectra) {
  std::vector<double> all = spectra.ground;
  for (const FloorSpectrum& floor : spectra.floors) all.insert(all.end(), floor.psa.begin(), floor.psa.end());
  for (double& value : all) value /= engine::standard_gravity;
  return log_range(all);
}

std::string period_line(double period, Range x) {
  if (period < x.low || period > x.high) return "";
  return fmt::format(
      "set arrow from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead dt (6,4) lw 1 lc rgb '{1}'\n"
      "set label {2} at {0:.6g}, graph 0.05 left offset character 0.8,0 front tc rgb '{1}'\n",
      period, to_hex(ink::quiet), gnuplot_text("T₁ = " + significant(period, 3) + " s"));
}

std::string curves(const FloorSpectra& spectra, Figure& figure) {
  std::string plot = "plot NaN notitle";
  const auto add = [&](const std::string& name, const std::string& file, const std::vector<double>& psa,
                       Colour colour, const char* dash) {
    const std::string data = data_of(spectra.periods, psa);
    if (data.empty()) return;
    figure.data[file] = data;
    plot += fmt::format(", '{}' with lines lw 1.6 dt {} lc rgb '{}' title {}", file, dash, to_hex(colour),
                        gnuplot_text(name));
  };
  auto chosen = drawn_floors(spectra.floors.size());
  std::ranges::reverse(chosen);
  for (const std::size_t i : chosen)
    add(spectra.floors[i].name, fmt::format("floor{}.txt", i), spectra.floors[i].psa, category(i), "1");
  add("ground", "ground.txt", spectra.ground, ink::black, "(6,4)");
  return plot + "\n";
}

}  // namespace

Figure floor_spectra_figure(const RunResult& run) {
  const FloorSpectra spectra = floor_spectra(run);
  const Range x{spectra.periods.front(), spectra.periods.back()}, y = psa_range(spectra);
  Figure figure{width, height, "", {}};
  const std::string plot = curves(spectra, figure);
  figure.script =
      plain_style() + "set logscale xy\n" +
      margins({left, width - right, top, height - bottom}, width, height) +
      fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", x.low, x.high, y.low, y.high) +
      log_tics("x", x) + log_tics("y", y) +
      heading("Floor acceleration spectra, 5 % damping", run_line(run), width, height) +
      "set xlabel 'Period, T (s)'\nset ylabel 'Pseudo-acceleration, PSa (g)'\n"
      "set key at graph 1.02, graph 1 left top Left reverse samplen 1.2 noautotitle\n" +
      period_line(run.model.period, x) + plot;
  return figure;
}

}  // namespace dougong::app
