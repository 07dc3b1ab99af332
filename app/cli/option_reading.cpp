#include "app/cli/option_reading.h"

#include <fmt/format.h>

#include "app/study/key.h"

namespace dougong::app {

double OptionReading::number(const std::string& option, const std::string& text, double otherwise,
                             Dimension dimension, double least, double most) {
  if (text.empty()) return otherwise;
  double value = otherwise;
  attempt(option, [&] {
    value = parse_quantity(text, dimension);
    if (!(value >= least && value <= most))
      throw std::invalid_argument(fmt::format("expected {} to {:g}, found {}",
                                              least == above_zero ? "above 0" : fmt::format("{:g}", least),
                                              most, text));
  });
  return value;
}

void OptionReading::finish() {
  if (!errors_.empty()) throw ScenarioError(std::move(errors_));
}

}  // namespace dougong::app
