#include "app/report/report_output.h"

#include "app/report/safe_file.h"

namespace dougong::app {

void Output::write(const std::string& name, std::string_view bytes) {
  write_file(folder_ / name, bytes);
  names_.push_back(name);
}

std::vector<std::filesystem::path> Output::paths() const {
  std::vector<std::filesystem::path> out;
  for (const std::string& name : names_) out.push_back(folder_ / name);
  return out;
}

void write_figure(const NamedFigure& named, Output& output, std::vector<Picture>& pictures) {
  const DrawnFigure drawn = draw(named.figure);
  const std::string name = "figures/" + named.name;
  output.write(name + ".svg", drawn.svg);
  output.write(name + ".png", drawn.png);
  pictures.push_back({name + ".svg", "image/svg+xml", drawn.svg, named.alt, named.figure.width});
}

void write_image(const std::string& name, const Image& image, double scale, const std::string& alt,
                 Output& output, std::vector<Picture>& pictures) {
  const std::string bytes = png_of(image);
  output.write(name, bytes);
  pictures.push_back({name, "image/png", bytes, alt, static_cast<int>(image.width / scale)});
}

}  // namespace dougong::app
