#include "app/cli/record_output.h"

#include <fmt/format.h>

#include "app/report/safe_file.h"

namespace dougong::app {

namespace fs = std::filesystem;

void check_new_file(const std::string& path, bool force) {
  if (!path.empty() && !force && fs::exists(path))
    throw FileError(path, "write", "the file exists; choose another name, or --force");
}

void check_picture(const std::string& path, bool force) {
  if (path.empty()) return;
  const std::string extension = fs::path(path).extension().string();
  if (extension != ".png" && extension != ".svg")
    throw FileError(path, "draw", "expected a name that ends in .png or .svg");
  check_new_file(path, force);
}

void write_picture(const std::string& path, const Figure& figure) {
  const DrawnFigure drawn = draw(figure);
  write_file(path, fs::path(path).extension() == ".svg" ? drawn.svg : drawn.png);
}

void print_json(const nlohmann::ordered_json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace dougong::app
