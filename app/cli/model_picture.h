// A model drawn to a PNG or SVG file, by the file's ending.
#pragma once

#include <filesystem>

#include "app/study/run_result.h"

namespace dougong::app {

/// Throws FileError for another ending, or a file that exists and is not forced: before anything is printed.
void refuse_picture(const std::filesystem::path& path, const std::string& option, bool force);
void write_model_picture(const ModelSheet& model, const std::filesystem::path& path);

}  // namespace dougong::app
