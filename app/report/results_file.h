// results.h5: everything a run leaves behind, so that a figure can be redrawn and two runs compared
// without running again. Every field comes back bit for bit. The layout is in docs/results-file.md.
#pragma once

#include <filesystem>

#include "app/study/run_result.h"

namespace dougong::app {

/// Raised when a field is added, renamed or changes its meaning.
inline constexpr int results_format_version = 2;

/// Written under a temporary name and renamed. Throws FileError with the path and the reason.
void write_results(const RunResult& run, const std::filesystem::path& path);
/// Throws FileError when the file is missing, damaged, of another kind or of a newer format.
RunResult read_results(const std::filesystem::path& path);

}  // namespace dougong::app
