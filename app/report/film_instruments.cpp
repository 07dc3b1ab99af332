#include "app/report/film_instruments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/lettering.h"
#include "app/report/text.h"
#include "app/study/output_times.h"
#include "engine/scene.h"

namespace dougong::app {
namespace {

using structures::StoreyResponse;

constexpr int margin = 14, head = 72;         // px
constexpr int least_row = 16, most_row = 56;  // px, of a storey
constexpr double font_size = 12.0;

int round_px(double x) {
  return static_cast<int>(std::lround(x));
}

std::vector<const StoreyResponse*> drifting(const RunResult& run) {
  std::vector<const StoreyResponse*> storeys;
  for (auto s = run.response.storeys.rbegin(); s != run.response.storeys.rend(); ++s)
    if (!s->is_base) storeys.push_back(&*s);
  return storeys;
}

/// The end of the bars' scale: the largest peak before a loss.
double scale_of(const std::vector<const StoreyResponse*>& storeys) {
  double most = 1e-6;
  for (const StoreyResponse* s : storeys) most = std::max(most, std::abs(s->peak_drift.largest().value));
  return most;
}

bool lost_by(const StoreyResponse& storey, const RunResult& run, std::size_t step) {
  return storey.lost_at && run.response.times[step] >= *storey.lost_at;
}

struct Row {
  int middle, half;  // px: of the bar, across and of the scale
  int y, height;     // px
};

void draw_tick(Image& image, const Row& row, double share) {
  const int x = row.middle + round_px(std::clamp(share, -1.0, 1.0) * row.half);
  image.fill_rectangle(x, row.y, 1, row.height, ink::outline);
}

void draw_bar(Image& image, const StoreyResponse& storey, std::size_t step, double scale, const Row& row,
              Colour colour) {
  const double share = std::clamp(storey.drift[step] / scale, -1.0, 1.0);
  const int length = round_px(std::abs(share) * row.half);
  image.fill_rectangle(share < 0 ? row.middle - length : row.middle, row.y, length, row.height, colour);
  image.fill_rectangle(row.middle, row.y - 2, 1, row.height + 4, ink::hatch);
  const auto so_far = storey.drift.begin() + static_cast<std::ptrdiff_t>(step) + 1;
  draw_tick(image, row, *std::max_element(storey.drift.begin(), so_far) / scale);
  draw_tick(image, row, *std::min_element(storey.drift.begin(), so_far) / scale);
}

/// Greatest size in each column of pixels.
std::vector<Range> columns_of(const MotionSheet& motion, double end, int width) {
  std::vector<Range> columns(static_cast<std::size_t>(width));
  for (std::size_t k = 0; k < motion.times.size() && motion.times[k] <= end; ++k) {
    const auto i = static_cast<std::size_t>(end > 0.0 ? motion.times[k] / end * (width - 1.0) : 0.0);
    const double a = motion.acceleration_x[k];
    columns[i] = {std::min(columns[i].low, a), std::max(columns[i].high, a)};
  }
  return columns;
}

double acceleration_at(const MotionSheet& motion, double time) {
  const auto after = std::ranges::lower_bound(motion.times, time) - motion.times.begin();
  return after < static_cast<std::ptrdiff_t>(motion.acceleration_x.size())
             ? motion.acceleration_x[static_cast<std::size_t>(after)]
             : 0.0;
}

}  // namespace

bool has_instruments(const RunResult& run) {
  return !run.model.free_scene && !run.trajectory.times.empty() && run.motion.times.size() > 1 &&
         !drifting(run).empty() && run.response.storeys.front().drift.size() == run.response.times.size();
}

void draw_drift_bars(Image& image, const RunResult& run, double time, int x, int bottom) {
  const std::size_t step = nearest_step(run.response.times, time);
  const Lettering font(font_size);
  const auto storeys = drifting(run);
  const double scale = scale_of(storeys);
  const int count = static_cast<int>(storeys.size());
  const int pitch = std::clamp((bottom - head - margin) / std::max(1, count), 1, most_row);
  const int middle = x + drift_bars_width / 2, half = drift_bars_width / 2 - margin;
  font.draw(image, "Interstorey drift, θ", middle, 24, ink::text, Align::centre);
  font.draw(image, fmt::format("scale ±{:.3g} %", 100.0 * scale), middle, 42, ink::quiet, Align::centre);
  for (int i = 0; i < count; ++i) {
    const StoreyResponse& storey = *storeys[static_cast<std::size_t>(i)];
    const int y = head + i * pitch;
    const bool lost = lost_by(storey, run, step), lettered = pitch >= 2 * least_row;
    const Row row{middle, half, y + (lettered ? least_row : 1), std::max(1, std::min(14, pitch - 2))};
    draw_bar(image, storey, step, scale, row,
             lost ? ink::pale : category(static_cast<std::size_t>(count - 1 - i)));
    if (!lettered) continue;
    font.draw(image, storey.name, middle - half, y + 11, ink::text);
    font.draw(image, lost ? "lost" : drift_percent(storey.drift[step]), middle + half, y + 11,
              lost ? ink::lost : ink::text, Align::right);
  }
}

void draw_motion_strip(Image& image, const RunResult& run, double time, int top) {
  const MotionSheet& motion = run.motion;
  const Lettering font(font_size);
  const int width = image.width - 2 * margin, middle = top + 68, half = 40;
  const double end = run.trajectory.times.back();
  const Range all = range_of(motion.acceleration_x);
  const double most = std::max({std::abs(all.low), std::abs(all.high), 1e-12});
  const auto columns = columns_of(motion, end, width);
  for (int i = 0; i < width; ++i) {
    const Range& c = columns[static_cast<std::size_t>(i)];
    const int up = round_px(c.high / most * half), down = round_px(c.low / most * half);
    image.fill_rectangle(margin + i, middle - up, 1, up - down + 1, category(0));
  }
  const double share = end > 0.0 ? std::clamp(time / end, 0.0, 1.0) : 0.0;
  image.fill_rectangle(margin + round_px(share * (width - 1)), middle - half - 6, 2, 2 * half + 12,
                       ink::lost);
  font.draw(image, "Ground acceleration, peak " + acceleration_g(most).substr(1), margin, top + 16,
            ink::text);
  font.draw(image, "now " + acceleration_g(acceleration_at(motion, time)), image.width - margin, top + 16,
            ink::text, Align::right);
}

}  // namespace dougong::app
