// The files of a report as they are written, and the pictures that its page shows.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/figures.h"
#include "app/report/html.h"
#include "app/report/image.h"

namespace dougong::app {

/// Writes files and remembers them.
class Output {
 public:
  explicit Output(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void write(const std::string& name, std::string_view bytes);
  const std::vector<std::string>& names() const { return names_; }
  std::vector<std::filesystem::path> paths() const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> names_;
};

/// As SVG and PNG in figures/; the page shows the SVG. Throws PlotError.
void write_figure(const NamedFigure& figure, Output& output, std::vector<Picture>& pictures);
/// As PNG. scale: pixels of the image per pixel at 1x.
void write_image(const std::string& name, const Image& image, double scale, const std::string& alt,
                 Output& output, std::vector<Picture>& pictures);

}  // namespace dougong::app
