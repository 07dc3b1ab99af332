// The results of a comparison's cases, each in a folder of its own as `dougong run` writes them: results.h5,
// summary.json, and inputs.sha256, written last, which says that they are complete and what they follow from.
#pragma once

#include <filesystem>

#include "app/study/compare/comparison.h"

namespace dougong::app {

/// folder: of the comparison. force: a run from other inputs is written over; without it `has` throws
/// FileError for one.
RunStore store_in(const std::filesystem::path& folder, const std::filesystem::path& records, bool force);

}  // namespace dougong::app
