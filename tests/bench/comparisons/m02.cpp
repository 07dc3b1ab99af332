// M02: the 81-brick graphite array on a shaking table.
//
//     comparisons M02 FOLDER [sweep rate in Hz/s] [restitution of a brick's point] [step as a part of the
//     bound]
//                            [restitution of a key's point] [friction] [Young's modulus, Pa]
//                            [of the keys, over that]
#include <fmt/format.h>

#include <algorithm>

#include "tests/bench/comparisons/comparison.h"
#include "tests/scenes/brick_array.h"

namespace dougong::comparisons {
namespace {

struct MeasuredBrick {
  const char* name;
  double peak, at;                // -, Hz
  double four, six, seven, nine;  // ratio near 4, 6, 7.5 and 9.5 Hz
};

constexpr MeasuredBrick bricks[] = {
    {"FB1(3)(4)", 1.33, 4.97, 1.2, 0.9, 0.9, 0.7},   {"FB2(1)(2)", 1.91, 5.00, 1.6, 1.2, 0.9, 0.6},
    {"FB2(2)(2)", 2.12, 5.04, 1.6, 1.05, 0.68, 0.8}, {"FB2(2)(3)", 1.88, 5.06, 1.5, 0.75, 0.6, 0.3},
    {"IB2(1)(0)", 2.18, 7.63, 1.2, 1.75, 1.7, 1.6},  {"IB2(3)(2)", 3.23, 5.03, 1.45, 1.3, 0.8, 0.15}};

/// Mean over the windows within 0.2 Hz.
double near(const scenes::BrickVelocities& v, const std::vector<double>& ratio, double frequency) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < ratio.size(); ++i)
    if (std::abs(v.frequency[i] - frequency) < 0.2) sum += ratio[i], ++count;
  return count > 0 ? sum / count : 0.0;
}

std::string table_row(const MeasuredBrick& brick, const scenes::BrickVelocities& v) {
  const std::vector<double>& ratio = v.ratio.at(brick.name);
  const auto peak = std::max_element(ratio.begin(), ratio.end());
  const double at = v.frequency[static_cast<std::size_t>(peak - ratio.begin())];
  return fmt::format(
      "| {} | {:.2f} at {:.2f} | {:.2f} at {:.2f} | {:.2f} / {:.2f} | {:.2f} / {:.2f} | {:.2f} / "
      "{:.2f} | {:.2f} / {:.2f} |\n",
      brick.name, brick.peak, brick.at, *peak, at, brick.four, near(v, ratio, 4.0), brick.six,
      near(v, ratio, 6.0), brick.seven, near(v, ratio, 7.5), brick.nine, near(v, ratio, 9.5));
}

/// Of the five bricks that share a resonance: the highest mean of their ratios, and where.
std::string common_peak(const scenes::BrickVelocities& v) {
  double highest = 0.0, at = 0.0;
  for (std::size_t i = 0; i < v.frequency.size(); ++i) {
    double sum = 0.0;
    for (const MeasuredBrick& brick : bricks)
      if (brick.at < 6.0) sum += v.ratio.at(brick.name)[i] / 5.0;
    if (sum > highest) highest = sum, at = v.frequency[i];
  }
  return fmt::format("\nMean of the five that peak together: {:.2f} at {:.2f} Hz.\n", highest, at);
}

}  // namespace

Comparison brick_array(const Arguments& arguments) {
  const double sweep_rate = arguments.empty() ? 0.1 : std::stod(arguments[0]);  // Hz/s, the test's
  const double window = 0.1 / sweep_rate;                                       // s, 0.1 Hz
  const auto motion = std::make_shared<const scenes::SweptSine>(0.3 * 9.81, 3.0, 10.0, sweep_rate, 2.0);
  scenes::BrickArrayOptions options;
  if (arguments.size() > 1) options.restitution = std::stod(arguments[1]);
  const double step_fraction = arguments.size() > 2 ? std::stod(arguments[2]) : 0.5;
  if (arguments.size() > 3) options.key_restitution = std::stod(arguments[3]);
  if (arguments.size() > 4) options.friction = std::stod(arguments[4]);
  if (arguments.size() > 5) options.young_modulus = std::stod(arguments[5]);
  if (arguments.size() > 6) options.key_stiffness = std::stod(arguments[6]);
  std::vector<std::string> names;
  for (const MeasuredBrick& brick : bricks) names.emplace_back(brick.name);
  const auto v = scenes::measured_velocities(scenes::brick_array(motion, options), *motion, names,
                                             motion->end(), window, step_fraction);
  Comparison comparison;
  comparison.table =
      "| brick | peak, measured (Hz) | peak, ours (Hz) | 4 Hz: measured / ours | 6 Hz | 7.5 Hz | 9.5 Hz |\n"
      "|---|---|---|---|---|---|---|\n";
  app::Figure& figure = comparison.figure;
  figure.height = 420;
  figure.script =
      look +
      "set xlabel 'frequency (Hz)'\nset ylabel 'velocity over that of the frame'\nset yrange [0:4]\n"
      "plot ";
  std::vector<std::vector<double>> curves{v.frequency}, peaks(2);
  for (std::size_t i = 0; i < std::size(bricks); ++i) {
    const MeasuredBrick& brick = bricks[i];
    comparison.table += table_row(brick, v);
    curves.push_back(v.ratio.at(brick.name));
    figure.data["measured" + std::to_string(i)] = columns(
        {{brick.at, 4.0, 6.0, 7.5, 9.5}, {brick.peak, brick.four, brick.six, brick.seven, brick.nine}});
    figure.script += fmt::format(
        "'curves' using 1:{0} with lines lw 1.3 lc rgb '{1}' title '{2}', 'measured{3}' with points pt 6 ps "
        "0.9 lc "
        "rgb '{1}' notitle{4}",
        i + 2, app::to_hex(app::category(i)), brick.name, i, i + 1 < std::size(bricks) ? ", " : "\n");
  }
  figure.data["curves"] = columns(curves);
  comparison.table += common_peak(v);
  comparison.table +=
      fmt::format("\n{} steps, the smallest {:.2g} s.\n", v.outcome.steps, v.outcome.smallest_step);
  return comparison;
}

}  // namespace dougong::comparisons
