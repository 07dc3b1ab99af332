// Text on pictures: glyphs by FreeType from the sans-serif font that fontconfig finds. OSMesa has no
// text of its own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/report/image.h"

namespace dougong::app {

enum class Align { left, centre, right };

/// One font at one size. Throws std::runtime_error naming the package when no font is installed.
class Lettering {
 public:
  explicit Lettering(double pixels);
  ~Lettering();
  Lettering(const Lettering&) = delete;
  Lettering& operator=(const Lettering&) = delete;

  double width(std::string_view utf8) const;
  double line_height() const;
  /// `y` is the baseline.
  void draw(Image& image, std::string_view utf8, double x, double y, Colour colour,
            Align align = Align::left) const;
  /// Words on lines no wider than `most` pixels.
  std::vector<std::string> wrapped(std::string_view utf8, double most) const;
  /// The text, cut with an ellipsis where it would not fit.
  std::string cut(std::string_view utf8, double most) const;

 private:
  struct Face;
  Face* face_;
};

}  // namespace dougong::app
