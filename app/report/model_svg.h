// The building as an SVG drawing to scale, for print: blocks in the colours of their storeys, storey
// heights beside it, a scale bar.
#pragma once

#include <string>

#include "app/study/run_result.h"

namespace dougong::app {

std::string model_svg(const ModelSheet& model);

}  // namespace dougong::app
