// What runs along in a film of a building: the drifts of its storeys, and the motion of the ground.
#pragma once

#include "app/report/image.h"
#include "app/study/run_result.h"

namespace dougong::app {

inline constexpr int drift_bars_width = 200, motion_strip_height = 120;  // px

/// True of a building with a motion; a free scene has none.
bool has_instruments(const RunResult& run);

/// A bar for each storey, top first, from the left edge `x` on down to `bottom`: its drift at this time,
/// ticks at its extremes so far. A lost storey says so.
void draw_drift_bars(Image& image, const RunResult& run, double time, int x, int bottom);
/// Ground acceleration over the whole run from `top` on, a cursor at this time.
void draw_motion_strip(Image& image, const RunResult& run, double time, int top);

}  // namespace dougong::app
