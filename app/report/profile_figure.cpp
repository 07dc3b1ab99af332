// The peak drift profile: how far each storey drifted to either side, at its true height.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/colour.h"
#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/levels.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using structures::Peak;

constexpr int width = 540, left = 78, right = 34, top = 74, bottom = 56;  // px
constexpr int label_height = 17;                                          // px a line of text needs
constexpr double label_room = 2.9;                                        // drift axis over the largest peak
const Colour positive_colour = category(0), negative_colour = category(1);

double percent(const Peak& peak) {
  return 100.0 * peak.value;
}

double largest(const std::vector<Level>& levels) {
  double size = 0.0;
  for (const Level& l : levels) {
    size = std::max({size, percent(l.storey->peak_drift.positive), -percent(l.storey->peak_drift.negative)});
  }
  return size;
}

/// The staircase of one sign, closed along the zero line.
std::string staircase(const std::vector<Level>& levels, bool positive) {
  std::string out = fmt::format("0 {:.6g}\n", levels.front().base);
  for (const Level& l : levels) {
    const double x = percent(positive ? l.storey->peak_drift.positive : l.storey->peak_drift.negative);
    out += fmt::format("{0:.6g} {1:.6g}\n{0:.6g} {2:.6g}\n", x, l.base, l.top);
  }
  return out + fmt::format("0 {:.6g}\n", levels.back().top);
}

/// Every how many storeys a label fits.
std::size_t label_stride(std::size_t storeys, double plot_height) {
  const double each = plot_height / static_cast<double>(storeys);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(label_height / each)));
}

std::string peak_label(const Peak& peak, double middle, int decimals) {
  const bool positive = peak.value > 0;
  return fmt::format("set label {} at {:.6g},{:.6g} {} offset character {},0 front tc rgb '{}'\n",
                     gnuplot_text(signed_fixed(percent(peak), decimals) + " % at " + seconds(peak.time)),
                     percent(peak), middle, positive ? "left" : "right", positive ? 0.6 : -0.6,
                     to_hex(positive ? category_ink(0) : category_ink(1)));
}

std::string lost_band(const Level& l, std::size_t tag) {
  const double middle = 0.5 * (l.base + l.top);
  return fmt::format(
             "set object {} rectangle from graph 0, first {:.6g} to graph 1, first {:.6g} behind "
             "fc rgb '#fbe3e1' fs solid noborder\n",
             tag, l.base, l.top) +
         fmt::format("set label {} at graph 0.985, first {:.6g} right offset 0,-0.9 front tc rgb '{}'\n",
                     gnuplot_text("lost at " + seconds(*l.storey->lost_at)), middle, to_hex(ink::lost));
}

std::string storey_labels(const std::vector<Level>& levels, double plot_height, int decimals) {
  const std::size_t stride = label_stride(levels.size(), plot_height);
  std::string out;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Level& l = levels[i];
    if (l.storey->lost_at) out += lost_band(l, i + 1);
    if (i % stride != 0) continue;
    const double middle = 0.5 * (l.base + l.top);
    out += fmt::format("set label {} at graph 1.012, first {:.6g} left front tc rgb '{}'\n",
                       gnuplot_text(l.storey->name), middle, to_hex(ink::quiet));
    const auto& e = l.storey->peak_drift;
    if (e.positive.value > 0) out += peak_label(e.positive, middle, decimals);
    if (e.negative.value < 0) out += peak_label(e.negative, middle, decimals);
  }
  return out;
}

/// The raft does not drift; it is drawn with how far it went over the isolators.
std::string raft_band(const Level& raft) {
  const auto [least, most] = std::ranges::minmax(raft.storey->floor_displacement);
  return fmt::format(
             "set object 100 rectangle from graph 0, first {:.6g} to graph 1, first {:.6g} behind fc rgb "
             "'{}' fs solid noborder\n",
             raft.base, raft.top, to_hex(mixed(ink::terrain, ink::white, 0.35))) +
         fmt::format("set label {} at graph 0.5, first {:.6g} center front tc rgb '{}'\n",
                     gnuplot_text(raft.storey->name + " on isolators: " + displacement(most) + " and " +
                                  displacement(least)),
                     0.5 * (raft.base + raft.top), to_hex(ink::text));
}

std::string floor_lines(const std::vector<Level>& levels, double low) {
  std::string out = fmt::format("set ytics ({:.6g}", low);
  const double least = 0.045 * (levels.back().top - low);
  double last = low;
  for (const Level& l : levels) {
    if (l.top - last < least) continue;
    out += fmt::format(", {:.6g}", l.top);
    last = l.top;
  }
  return out + ")\nset format y '%.2f'\n";
}

std::string curves() {
  std::string out = "plot NaN notitle";
  for (const auto& [name, colour] :
       {std::pair{"positive.txt", positive_colour}, {"negative.txt", negative_colour}}) {
    out += fmt::format(
        ", '{0}' with filledcurves closed fc rgb '{1}' fs transparent solid 0.16 noborder notitle, "
        "'{0}' with lines lw 2 lc rgb '{1}' notitle",
        name, to_hex(colour));
  }
  return out + "\n";
}

int plot_height_for(std::size_t storeys) {
  return static_cast<int>(std::clamp(84.0 * static_cast<double>(storeys), 220.0, 460.0));
}

std::string frame(const std::vector<Level>& levels, double low, double reach, int height) {
  return plain_style() +
         fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / double(width),
                     1.0 - right / double(width)) +
         fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                     1.0 - top / double(height), bottom / double(height)) +
         fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:.6g}\n", -reach,
                     reach, low, levels.back().top, round_step(2 * reach, 8)) +
         "set yzeroaxis lt 1 lw 0.8 lc rgb '#8a8a8a'\nset xlabel 'Peak interstorey drift ratio, θ (%)'\n"
         "set ylabel 'Height above ground, z (m)'\n";
}

}  // namespace

Figure drift_profile_figure(const RunResult& run) {
  const std::vector<Level> levels = levels_of(run);
  const std::optional<Level> raft = raft_of(run);
  const bool drawn = raft && !raft->storey->floor_displacement.empty();
  const double low = drawn ? raft->base : levels.front().base;
  const int plot_height = plot_height_for(levels.size());
  Figure figure{width, top + bottom + plot_height, "", {}};
  const double size = largest(levels);
  const int decimals = size >= 0.1 || size <= 0.0 ? 2 : size >= 0.01 ? 3 : 4;
  figure.data = {{"positive.txt", staircase(levels, true)}, {"negative.txt", staircase(levels, false)}};
  figure.script = frame(levels, low, size > 0 ? label_room * size : 1.0, figure.height) +
                  heading("Peak drift of each storey, both directions", run_line(run), width, figure.height) +
                  floor_lines(levels, low) + (drawn ? raft_band(*raft) : "") +
                  storey_labels(levels, plot_height, decimals) + curves();
  return figure;
}

}  // namespace dougong::app
