#include "app/report/block_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/axis.h"
#include "app/report/histories.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr int width = 880, left = 20, top = 62, line_height = 20, scale_room = 110;  // px
constexpr double most_height = 560;                                                  // px of the drawing
constexpr double drawn_share = 0.1;  // of the drawing's size, of the greatest motion
constexpr std::size_t many = 300;    // blocks from which outlines are thinner

struct Sheet {
  Box box;
  double pixels;  // a metre
  int right, bottom, height;
};

Box box_of(const ModelSheet& model, const BlockDrawing& drawing) {
  Box box = model_bounds(model);
  const Box seen = stage(model);
  for (std::size_t i = 0; i < drawing.moved.size(); ++i)
    for (const auto& outline : outlines(model.blocks[i], drawing.moved[i]))
      for (const Vec2 p : outline)
        if (seen.holds(p))
          box = {{std::min(box.low.x, p.x), box.low.y},
                 {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
  return framed(box);
}

Sheet sheet_of(const ModelSheet& model, const BlockDrawing& drawing) {
  const double room = width - 2.0 * left - (drawing.scale_title.empty() ? 0 : scale_room);
  Box box = box_of(model, drawing);
  const double pixels = std::min(room / box.width(), most_height / box.height());
  const int high = static_cast<int>(std::lround(pixels * box.height()));
  const int bottom = top + high;
  return {box, pixels, left + static_cast<int>(std::lround(pixels * box.width())), bottom,
          bottom + line_height * static_cast<int>(drawing.legend.size() + 2)};
}

std::string points_of(const std::vector<Vec2>& outline) {
  std::string out;
  for (std::size_t k = 0; k <= outline.size() && !outline.empty(); ++k)
    out += fmt::format("{:.6g} {:.6g}\n", outline[k % outline.size()].x, outline[k % outline.size()].y);
  return out.empty() ? out : out + "\n";
}

std::string ground_of(const ModelSheet& model, const Box& box) {
  std::string out;
  for (const DrawnShape& terrain : model.terrains)
    for (const auto& outline : outlines(terrain, described_pose(terrain)))
      out += points_of(clipped_outline(outline, box));
  return out;
}

/// Outlines by the colour that fills them.
std::map<std::string, std::string> filled(const ModelSheet& model, const BlockDrawing& drawing) {
  std::map<std::string, std::string> out;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Pose pose = drawing.moved.empty() ? described_pose(model.blocks[i]) : drawing.moved[i];
    for (const auto& outline : outlines(model.blocks[i], pose))
      out[to_hex(i < drawing.fill.size() ? drawing.fill[i] : ink::block)] += points_of(outline);
  }
  return out;
}

std::string still(const ModelSheet& model) {
  std::string out;
  for (const DrawnShape& block : model.blocks)
    for (const auto& outline : outlines(block, described_pose(block))) out += points_of(outline);
  return out;
}

std::string plots(const ModelSheet& model, const BlockDrawing& drawing, const Sheet& sheet, Figure& figure) {
  const double line = model.blocks.size() > many ? 0.45 : 0.7;
  std::string out = "plot NaN notitle";
  const auto add = [&](const std::string& name, const std::string& data, const std::string& how) {
    if (data.empty()) return;
    figure.data[name] = data;
    out += fmt::format(", '{}' {} notitle", name, how);
  };
  add("ground.txt", ground_of(model, sheet.box),
      fmt::format("with filledcurves closed fc rgb '{}' fs solid noborder", to_hex(ink::terrain)));
  if (!drawing.moved.empty())
    add("still.txt", still(model), fmt::format("with lines lw {} lc rgb '{}'", line, to_hex(ink::pale)));
  int group = 0;
  for (const auto& [colour, data] : filled(model, drawing)) {
    const std::string name = fmt::format("blocks{}.txt", group++);
    add(name, data, fmt::format("with filledcurves closed fc rgb '{}' fs solid noborder", colour));
    out += fmt::format(", '{}' with lines lw {} lc rgb '{}' notitle", name, line, to_hex(ink::outline));
  }
  return out + "\n";
}

std::string arrow(Vec2 from, Vec2 to, Colour colour, bool headed, double thick) {
  return fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} {} front lw {} lc rgb '{}'\n", from.x,
                     from.y, to.x, to.y, headed ? "head filled size screen 0.008,22" : "nohead", thick,
                     to_hex(colour));
}

std::string mark(const DrawingMark& m, const Sheet& sheet) {
  const double size = 11.0 / sheet.pixels;  // m
  if (m.shape == MarkShape::dot)
    return fmt::format(
        "set object circle at {:.6g},{:.6g} size {:.6g} front fc rgb '#ffffff' fs solid border lc rgb '{}' "
        "lw 1.6\n",
        m.place.x, m.place.y, 0.4 * size, to_hex(m.colour));
  const Vec2 along = (size / engine::norm(m.direction)) * m.direction;
  const Vec2 aside = 0.28 * engine::turned(along);
  if (m.shape == MarkShape::arrows)
    return arrow(m.place - along + aside, m.place + along + aside, m.colour, true, 1.4) +
           arrow(m.place + along - aside, m.place - along - aside, m.colour, true, 1.4);
  const Vec2 a = 0.5 * (along + engine::turned(along)), b = 0.5 * (along - engine::turned(along));
  return arrow(m.place - a, m.place + a, m.colour, false, 1.6) +
         arrow(m.place - b, m.place + b, m.colour, false, 1.6);
}

std::string scale_bar(const Sheet& sheet) {
  const double metres = round_below(0.25 * sheet.box.width());
  const double from = left / double(width), to = (left + metres * sheet.pixels) / double(width);
  const double y = 1.0 - (sheet.bottom + 0.9 * line_height) / double(sheet.height);
  return fmt::format(
             "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} heads size screen 0.004,90 lw 1 lc "
             "rgb '{}'\n",
             from, y, to, y, to_hex(ink::outline)) +
         fmt::format("set label {} at screen {:.5f},{:.5f} left tc rgb '{}'\n",
                     gnuplot_text(fmt::format("{:g} m", metres)), to + 0.009, y, to_hex(ink::text));
}

std::string legend(const BlockDrawing& drawing, const Sheet& sheet) {
  std::string out;
  for (std::size_t i = 0; i < drawing.legend.size(); ++i)
    out += fmt::format("set label {} at screen {:.5f},{:.5f} left tc rgb '{}'\n",
                       gnuplot_text(drawing.legend[i]), left / double(width),
                       1.0 - (sheet.bottom + (static_cast<double>(i) + 1.9) * line_height) / sheet.height,
                       to_hex(ink::quiet));
  return out;
}

std::string colour_scale(const BlockDrawing& drawing, const Sheet& sheet) {
  if (drawing.scale_title.empty()) return "";
  constexpr int steps = 48;
  const double x = (width - scale_room + 20) / double(width), wide = 16 / double(width);
  const double low = 1.0 - (top + 190.0) / sheet.height, high = 1.0 - (top + 30.0) / sheet.height;
  std::string out;
  for (int i = 0; i < steps; ++i)
    out += fmt::format(
        "set object rectangle from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} fc rgb '{}' fs solid "
        "noborder\n",
        x, low + (high - low) * i / steps, x + wide, low + (high - low) * (i + 1.05) / steps,
        to_hex(viridis((i + 0.5) / steps)));
  for (const double share : {0.0, 0.5, 1.0})
    out += fmt::format("set label '{:g}' at screen {:.5f},{:.5f} left tc rgb '{}'\n",
                       drawing.scale_start + share * (drawing.scale_end - drawing.scale_start),
                       x + wide + 0.006, low + (high - low) * share, to_hex(ink::text));
  return out + fmt::format("set label {} at screen {:.5f},{:.5f} left tc rgb '{}'\n",
                           gnuplot_text(drawing.scale_title), x, 1.0 - (top + 14.0) / sheet.height,
                           to_hex(ink::text));
}

std::string lines(const BlockDrawing& drawing) {
  std::string out;
  for (const DrawingLine& line : drawing.lines)
    out += arrow(line.from, line.to, line.colour, false, line.width);
  return out;
}

}  // namespace

Figure block_figure(const ModelSheet& model, const BlockDrawing& drawing) {
  const Sheet sheet = sheet_of(model, drawing);
  Figure figure{width, sheet.height, "", {}};
  std::string marks;
  for (const DrawingMark& m : drawing.marks) marks += mark(m, sheet);
  figure.script = "unset key\nunset border\nunset tics\n" +
                  margins({left, sheet.right, top, sheet.bottom}, width, sheet.height) +
                  fmt::format("set xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\n", sheet.box.low.x,
                              sheet.box.high.x, sheet.box.low.y, sheet.box.high.y) +
                  heading(drawing.title, drawing.subtitle, width, sheet.height) + scale_bar(sheet) +
                  legend(drawing, sheet) + colour_scale(drawing, sheet) + lines(drawing) + marks;
  const std::string what = plots(model, drawing, sheet, figure);
  figure.script += what;
  return figure;
}

double drawn_magnification(const ModelSheet& model, const std::vector<Vec2>& motions) {
  const Box box = model_bounds(model);
  double greatest = 0.0;
  for (const Vec2 motion : motions) greatest = std::max(greatest, engine::norm(motion));
  return greatest > 0.0 ? round_below(drawn_share * std::max(box.width(), box.height()) / greatest) : 1.0;
}

std::string factor_text(double factor) {
  return fmt::format("{:g}", factor);
}

}  // namespace dougong::app
