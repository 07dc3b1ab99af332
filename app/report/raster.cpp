#include "app/report/raster.h"

#include <GL/osmesa.h>

#include <cmath>
#include <stdexcept>

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr int samples_each_way = 4;
constexpr double mitre_limit = 3.0;  // of half the width, at sharp corners

/// An off-screen OpenGL context with its buffer, current while in scope.
class Context {
 public:
  Context(int width, int height)
      : context_(OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr)),
        pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    if (context_ == nullptr ||
        !OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width, height)) {
      if (context_ != nullptr) OSMesaDestroyContext(context_);
      throw std::runtime_error("cannot start OSMesa for a picture of " + std::to_string(width) + " x " +
                               std::to_string(height));
    }
  }
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  const std::vector<GLubyte>& pixels() const { return pixels_; }

 private:
  OSMesaContext context_;
  std::vector<GLubyte> pixels_;
};

void set_view(int width, int height, double shift_x, double shift_y) {
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(shift_x, width + shift_x, shift_y, height + shift_y, -1.0, 1.0);
}

void paint(const std::vector<FilledPolygon>& shapes) {
  for (const FilledPolygon& shape : shapes) {
    glColor3d(shape.colour.red, shape.colour.green, shape.colour.blue);
    glBegin(GL_TRIANGLE_FAN);
    for (const Vec2 p : shape.outline) glVertex2d(p.x, p.y);
    glEnd();
  }
}

GLuint recorded(const std::vector<FilledPolygon>& shapes) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  paint(shapes);
  glEndList();
  return list;
}

void add_pixels(const std::vector<GLubyte>& rgba, std::vector<unsigned>& sums) {
  for (std::size_t i = 0, n = rgba.size() / 4; i < n; ++i) {
    for (std::size_t c = 0; c < 3; ++c) sums[3 * i + c] += rgba[4 * i + c];
  }
}

/// The mean of the samples, turned so that the first row is the top one.
Image averaged(const std::vector<unsigned>& sums, int width, int height) {
  constexpr unsigned n = samples_each_way * samples_each_way;
  Image image(width, height);
  const std::size_t row_size = 3 * static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = image.at(0, height - 1 - y);
    const unsigned* from = &sums[static_cast<std::size_t>(y) * row_size];
    for (std::size_t i = 0; i < row_size; ++i) row[i] = static_cast<std::uint8_t>((from[i] + n / 2) / n);
  }
  return image;
}

Vec2 unit(Vec2 v) {
  const double length = engine::norm(v);
  return length > 0 ? (1.0 / length) * v : Vec2{1.0, 0.0};
}

/// Within a pixel, -0.5 .. 0.5: a grid turned a little, so that no two samples share a row or a column
/// and edges close to an axis get all the grey levels.
Vec2 sample_place(int sample) {
  constexpr int n = samples_each_way;
  const int i = sample % n, j = sample / n;
  constexpr double fine = 1.0 / (n * n);
  return {(n * i + j + 0.5) * fine - 0.5, (n * j + i + 0.5) * fine - 0.5};
}

/// Where the corner goes when both edges move out by one.
Vec2 mitre(Vec2 before, Vec2 corner, Vec2 after) {
  const Vec2 a = -engine::turned(unit(corner - before)), b = -engine::turned(unit(after - corner));
  const double sharpness = 1.0 + engine::dot(a, b);
  return sharpness < 2.0 / (mitre_limit * mitre_limit) ? unit(a + b) * mitre_limit
                                                       : (1.0 / sharpness) * (a + b);
}

}  // namespace

void Drawing::polygon(std::vector<Vec2> convex, Colour colour) {
  shapes_.push_back({std::move(convex), colour});
}

void Drawing::outline(const std::vector<Vec2>& convex, double width, Colour colour) {
  const std::size_t n = convex.size();
  std::vector<Vec2> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = (0.5 * width) * mitre(convex[(i + n - 1) % n], convex[i], convex[(i + 1) % n]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    polygon({convex[i] + out[i], convex[j] + out[j], convex[j] - out[j], convex[i] - out[i]}, colour);
  }
}

void Drawing::line(Vec2 from, Vec2 to, double width, Colour colour) {
  const Vec2 side = (0.5 * width) * engine::turned(unit(to - from));
  polygon({from - side, to - side, to + side, from + side}, colour);
}

Image Drawing::render(int width, int height, Colour background) const {
  const Context context(width, height);
  std::vector<unsigned> sums(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0u);
  const GLuint list = recorded(shapes_);
  glClearColor(static_cast<float>(background.red), static_cast<float>(background.green),
               static_cast<float>(background.blue), 1.0f);
  for (int i = 0; i < samples_each_way * samples_each_way; ++i) {
    const Vec2 shift = sample_place(i);
    set_view(width, height, shift.x, shift.y);
    glClear(GL_COLOR_BUFFER_BIT);
    glCallList(list);
    glFinish();
    add_pixels(context.pixels(), sums);
  }
  return averaged(sums, width, height);
}

}  // namespace dougong::app
