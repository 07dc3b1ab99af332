// Where the energy is and went, stacked over time; what came in, and the error, as lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/text.h"
#include "app/study/output_times.h"

namespace dougong::app {
namespace {

constexpr int width = 880, height = 420, left = 84, right = 150, top = 66, bottom = 56;  // px
constexpr std::size_t most_rows = 1500;                                                  // of a drawn history

constexpr double unseen = 0.002;  // of the greatest sum: such a band is left out

struct Band {
  const char* name;
  std::vector<double> values;  // J
  Colour colour;
};

std::vector<double> at_least_zero(std::vector<double> values, double sign) {
  for (double& v : values) v = std::max(0.0, sign * v);
  return values;
}

/// From below: what is gone for good first, then what is stored.
std::vector<Band> bands_of(const EnergyHistory& e) {
  std::vector<Band> bands{{"friction", e.friction, category(1)}, {"damping", e.damping, category(4)}};
  if (std::ranges::any_of(e.fracture, [](double v) { return v > 0.0; }))
    bands.push_back({"yield, fracture", e.fracture, category(5)});
  bands.push_back({"strain", since_start(e.elastic), category(3)});
  bands.push_back({"kinetic", since_start(e.kinetic), category(0)});
  bands.push_back({"lifted", at_least_zero(since_start(e.gravity), 1.0), category(2)});
  return bands;
}

std::string row_of(double time, const std::vector<Band>& bands, std::size_t k, double factor) {
  std::string row = fmt::format("{:.7g} 0", time);
  double sum = 0.0;
  for (const Band& band : bands) row += fmt::format(" {:.6g}", factor * (sum += band.values[k]));
  return row;
}

struct Lines {
  std::vector<double> input, supply, error;
};

Lines lines_of(const EnergyHistory& e) {
  Lines lines{e.input, at_least_zero(since_start(e.gravity), -1.0), e.error};
  for (std::size_t k = 0; k < lines.supply.size(); ++k) lines.supply[k] += e.input[k];
  return lines;
}

double largest(const std::vector<Band>& bands, const Lines& lines) {
  double most = 0.0;
  for (std::size_t k = 0; k < lines.supply.size(); ++k) {
    double sum = 0.0;
    for (const Band& band : bands) sum += band.values[k];
    most = std::max({most, sum, lines.supply[k]});
  }
  return most;
}

/// Columns: time, 0, the sums of the bands one by one, input, supply, error.
std::string data_of(const RunResult& run, const std::vector<Band>& bands, const Lines& lines, double factor) {
  const auto& times = output_times(run);
  const std::size_t rows = std::min(times.size(), lines.input.size()), stride = rows / most_rows + 1;
  std::string out;
  for (std::size_t k = 0; k < rows; k += stride)
    out +=
        row_of(times[k], bands, k, factor) + fmt::format(" {:.6g} {:.6g} {:.6g}\n", factor * lines.input[k],
                                                         factor * lines.supply[k], factor * lines.error[k]);
  return out;
}

std::string plot_of(const std::vector<Band>& bands, bool gravity_gave) {
  std::string plot = "plot NaN notitle";
  for (std::size_t i = bands.size(); i-- > 0;)
    plot += fmt::format(
        ", 'stack.txt' using 1:{}:{} with filledcurves fc rgb '{}' fs solid 0.75 noborder title "
        "'{}'",
        i + 2, i + 3, to_hex(bands[i].colour), bands[i].name);
  const std::size_t input = bands.size() + 3;
  plot += fmt::format(", 'stack.txt' using 1:{} with lines lw 1.6 lc rgb '{}' title 'input'", input,
                      to_hex(ink::black));
  if (gravity_gave)
    plot += fmt::format(", 'stack.txt' using 1:{} with lines lw 1.6 dt (6,4) lc rgb '{}' title 'and gravity'",
                        input + 1, to_hex(ink::black));
  return plot + fmt::format(", 'stack.txt' using 1:{} with lines lw 1.2 lc rgb '{}' title 'error'\n",
                            input + 2, to_hex(ink::lost));
}

}  // namespace

Figure energy_stack_figure(const RunResult& run) {
  std::vector<Band> bands = bands_of(run.energy);
  const Lines lines = lines_of(run.energy);
  const double most = largest(bands, lines);
  std::erase_if(bands, [&](const Band& b) { return std::ranges::max(b.values) < unseen * most; });
  const auto [factor, unit] = energy_unit(most);
  const bool gravity_gave = std::ranges::max(lines.supply) > 1.01 * std::ranges::max(lines.input);
  const auto& times = output_times(run);
  Figure figure{width, height, "", {{"stack.txt", data_of(run, bands, lines, factor)}}};
  figure.script = plain_style() + margins({left, width - right, top, height - bottom}, width, height) +
                  fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.6g}:{:.6g}]\n", times.front(),
                              std::max(times.back(), times.front() + 1e-9), -0.03 * most * factor,
                              most > 0.0 ? 1.05 * most * factor : 1.0) +
                  heading("Where the energy is and went", run_line(run), width, height) +
                  "set xlabel 'Time, t (s)'\n" + fmt::format("set ylabel 'Energy, E ({})'\n", unit) +
                  "set key at graph 1.02, graph 1 left top Left reverse samplen 1.2 noautotitle\n" +
                  plot_of(bands, gravity_gave);
  return figure;
}

}  // namespace dougong::app
