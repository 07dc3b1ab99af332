// Fewer points of a long history, with every peak kept: of each bin of samples the smallest and the
// largest, in their order of time. First and last samples are always kept.
#pragma once

#include <vector>

namespace dougong::app {

struct Points {
  std::vector<double> x, y;
};

/// At most 2 x bins + 2 points; the history itself when it is already short enough.
Points decimated(const std::vector<double>& x, const std::vector<double>& y, std::size_t bins);

}  // namespace dougong::app
