// Invented but plausible runs, made by formula: what a RunResult looks like without running anything.
#pragma once

#include "app/study/run_result.h"

namespace dougong::app::fixtures {

RunResult survived();     // four storeys of two columns and a slab
RunResult repeated();     // the collapsed one, with an ensemble
RunResult collapsed();    // the same, the two lowest storeys lost
RunResult brick_wall();   // 1000 bricks, 20 storeys in name
RunResult partial();      // interrupted
RunResult motionless();   // one storey, a ground that never moves, empty histories where allowed
RunResult long_record();  // 20000 output samples

}  // namespace dougong::app::fixtures
