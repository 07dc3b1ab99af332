#include "app/cli/model_picture.h"

#include "app/report/image.h"
#include "app/report/model_svg.h"
#include "app/report/safe_file.h"
#include "app/report/scene.h"

namespace dougong::app {

void refuse_picture(const std::filesystem::path& path, const std::string& option, bool force) {
  if (path.extension() != ".png" && path.extension() != ".svg")
    throw FileError(path, "write the picture", "expected a name that ends in .png or .svg");
  if (!force && std::filesystem::exists(path))
    throw FileError(path, "write the picture", "the file exists; give --force or another " + option);
}

void write_model_picture(const ModelSheet& model, const std::filesystem::path& path) {
  write_file(path, path.extension() == ".svg" ? model_svg(model) : png_of(draw_model(model)));
}

}  // namespace dougong::app
