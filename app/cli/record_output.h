// What the commands of `dougong record` leave behind besides text.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "app/report/gnuplot.h"

namespace dougong::app {

/// Throws FileError when it exists and is not forced; of a picture also when it is neither PNG nor SVG. An
/// empty name is none.
void check_new_file(const std::string& path, bool force);
void check_picture(const std::string& path, bool force);
/// By the ending of the name.
void write_picture(const std::string& path, const Figure& figure);
/// On standard output; bytes that are no text are replaced.
void print_json(const nlohmann::ordered_json& json);

}  // namespace dougong::app
