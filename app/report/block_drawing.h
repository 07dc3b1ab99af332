// Blocks drawn to scale by gnuplot, as SVG and PNG of one script: mechanisms, mode shapes, utilisation.
//
// Equal axes, ground in grey, a scale bar in round metres. What is moved is magnified, the factor is written
// below, and the blocks as they stand remain as pale outlines.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/report/camera.h"
#include "app/report/colour.h"
#include "app/report/gnuplot.h"

namespace dougong::app {

enum class MarkShape { dot, arrows, cross };

struct DrawingMark {
  MarkShape shape = MarkShape::dot;
  engine::Vec2 place;                // m
  engine::Vec2 direction{1.0, 0.0};  // of arrows
  Colour colour = ink::lost;
};

/// A line of colour between two points, as of a bonded face.
struct DrawingLine {
  engine::Vec2 from, to;  // m
  Colour colour;
  double width = 3.2;  // px
};

struct BlockDrawing {
  std::string title, subtitle;
  std::vector<std::string> legend;  // lines below the drawing
  std::vector<Colour> fill;         // of each block
  std::vector<Pose> moved;          // of each block, magnified already; empty: as described
  std::vector<DrawingMark> marks;
  std::vector<DrawingLine> lines;
  std::string scale_title = {};  // of a colour scale on the right; empty: none
  double scale_start = 0.0;      // its least value, that of viridis(0)
  double scale_end = 1.0;        // its greatest, that of viridis(1)
};

Figure block_figure(const ModelSheet& model, const BlockDrawing& drawing);

/// How many times the motions (m) are drawn so that the greatest is a tenth of the drawing's size; a round
/// number.
double drawn_magnification(const ModelSheet& model, const std::vector<engine::Vec2>& motions);
/// "12", "0.5", "1.2e4".
std::string factor_text(double factor);

}  // namespace dougong::app
