// The moments of a run that are worth a picture.
#pragma once

#include "app/study/run_result.h"

namespace dougong::app {

/// In order of time, none twice: strongest shaking, peak drift, first loss of support, storeys lost, end.
std::vector<Moment> moments_of(const RunResult& result);

}  // namespace dougong::app
