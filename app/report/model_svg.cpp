#include "app/report/model_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/camera.h"
#include "app/report/colour.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr double most_width = 640, most_height = 520;  // px of the drawing
constexpr double label_width = 150, footer = 40;       // px beside and below it

struct Sheet {
  Camera camera;
  double width, height;
  Vec2 at(Vec2 world) const {
    const Vec2 p = camera.to_pixels(world);
    return {p.x, height - p.y};
  }
};

Sheet sheet_for(const ModelSheet& model) {
  const Box box = framed(model_bounds(model));
  const double width = std::min(most_width, most_height * box.aspect());
  return {{box, width / box.width()}, width, width / box.aspect()};
}

std::string path_of(const std::vector<Vec2>& world, const Sheet& sheet) {
  std::string out;
  for (const Vec2 p : world) {
    const Vec2 q = sheet.at(p);
    out += fmt::format("{}{:.2f} {:.2f}", out.empty() ? "M" : "L", q.x, q.y);
  }
  return out + "Z";
}

/// Ground is cut a little outside the picture, so that no cut edge is seen.
double hatched_beyond(const Sheet& sheet) {
  return 20.0 / sheet.camera.pixels_per_metre;
}

std::string ground_part(const std::vector<Vec2>& outline, const Sheet& sheet) {
  if (outline.size() < 3) return "";
  std::string out =
      fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path_of(outline, sheet), to_hex(ink::terrain));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = sheet.at(outline[i]), b = sheet.at(outline[(i + 1) % outline.size()]);
    const double length = engine::norm(b - a);
    if (a.x - b.x <= 0.3 * length) continue;
    const Vec2 along = (1.0 / length) * (b - a);
    for (double s = 7.0; s < std::min(length, 5000.0); s += 7.0) {
      const Vec2 p = a + s * along, q = p + Vec2{5.0, 6.0};
      out += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"0.8\"/>\n",
                         p.x, p.y, q.x, q.y, to_hex(ink::hatch));
    }
    out += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"1.3\"/>\n", a.x,
                       a.y, b.x, b.y, to_hex(ink::outline));
  }
  return out;
}

std::string terrain_part(const DrawnShape& terrain, const Sheet& sheet) {
  std::string out;
  for (const auto& outline : outlines(terrain, described_pose(terrain)))
    out += ground_part(clipped_outline(outline, sheet.camera.box.grown(hatched_beyond(sheet))), sheet);
  return out;
}

std::string block_part(const DrawnShape& block, const Sheet& sheet) {
  const Colour tint = block.storey < 0
                          ? ink::block
                          : mixed(category(static_cast<std::size_t>(block.storey)), ink::white, 0.66);
  std::string paths;
  for (const auto& outline : outlines(block, described_pose(block))) paths += path_of(outline, sheet);
  return fmt::format("<path d=\"{}\" fill=\"{}\"><title>{}: {}</title></path>\n", paths, to_hex(tint),
                     escape_markup(block.name), escape_markup(mass_text(block.mass)));
}

/// Joints: a line between the anchors and a ring at each.
std::string links_part(const ModelSheet& model, const Sheet& sheet) {
  std::string out;
  const auto end = [&](std::size_t owner, Vec2 anchor) {
    const Pose pose = described_pose(
        owner < model.blocks.size() ? model.blocks[owner] : model.terrains[owner - model.blocks.size()]);
    return sheet.at(pose.position + engine::rotated(anchor, pose.angle));
  };
  for (const DrawnLink& link : model.links) {
    const Vec2 a = end(link.a, link.anchor_a), b = end(link.b, link.anchor_b);
    out += fmt::format(
        "<path d=\"M{0:.2f} {1:.2f}L{2:.2f} {3:.2f}\"/><circle cx=\"{0:.2f}\" cy=\"{1:.2f}\" r=\"2.6\"/>"
        "<circle cx=\"{2:.2f}\" cy=\"{3:.2f}\" r=\"2.6\"/>\n",
        a.x, a.y, b.x, b.y);
  }
  return out.empty() ? ""
                     : fmt::format("<g fill=\"#ffffff\" stroke=\"{}\">\n{}</g>\n", to_hex(ink::outline), out);
}

/// Bonds: the bonded face in blue.
std::string bonds_part(const ModelSheet& model, const Sheet& sheet) {
  std::string path;
  for (const DrawnBond& bond : model.bonded) {
    const Pose pose =
        described_pose(bond.owner < model.blocks.size() ? model.blocks[bond.owner]
                                                        : model.terrains[bond.owner - model.blocks.size()]);
    const auto at = [&](Vec2 local) { return sheet.at(pose.position + engine::rotated(local, pose.angle)); };
    const Vec2 a = at(bond.start), b = at(bond.end);
    path += fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", a.x, a.y, b.x, b.y);
  }
  return path.empty() ? ""
                      : fmt::format("<path class=\"bonds\" d=\"{}\" stroke=\"{}\" stroke-width=\"1.8\"/>\n",
                                    path, to_hex(ink::bond));
}

std::string text_part(double x, double y, const std::string& text, Colour colour = ink::text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", x, y, to_hex(colour),
                     escape_markup(text));
}

/// A dimension line beside each storey; names only where they fit.
std::string storeys_part(const ModelSheet& model, const Sheet& sheet) {
  const double x = sheet.width + 14.0;
  std::vector<double> lettered;  // px: neighbours' storeys may lie at one height
  std::string out;
  for (const StoreySheet& storey : model.storeys) {
    const double low = sheet.at({0.0, storey.base}).y, high = sheet.at({0.0, storey.base + storey.height}).y;
    out += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}h8M{0:.1f} {2:.1f}h8M{3:.1f} {1:.1f}V{2:.1f}\" stroke=\"{4}\" "
        "stroke-width=\"0.8\" fill=\"none\"/>\n",
        x, low, high, x + 4.0, to_hex(ink::quiet));
    const double middle = 0.5 * (low + high) + 4.0;
    const auto too_near = [&](double y) { return std::abs(y - middle) < 15.0; };
    if (std::ranges::any_of(lettered, too_near)) continue;
    out += text_part(x + 14.0, middle, storey.name + ", h = " + significant(storey.height, 3) + " m");
    lettered.push_back(middle);
  }
  return out;
}

std::string scale_bar_part(const Sheet& sheet) {
  const double metres = round_below(130.0 / sheet.camera.pixels_per_metre),
               length = metres * sheet.camera.pixels_per_metre;
  const double y = sheet.height + 16.0;
  const std::string text =
      metres < 1.0 ? fmt::format("{:g} cm", 100 * metres) : fmt::format("{:g} m", metres);
  return fmt::format(
             "<path d=\"M4 {0:.1f}h{1:.2f}v4h-{1:.2f}zM{2:.2f} {0:.1f}h{3:.2f}v4h-{3:.2f}z\" fill=\"{4}\" "
             "fill-rule=\"evenodd\" stroke=\"{4}\" stroke-width=\"0.8\"/>\n",
             y, length, 4 + length / 2, length / 2, to_hex(ink::outline)) +
         text_part(length + 14.0, y + 6.0, text);
}

}  // namespace

std::string model_svg(const ModelSheet& model) {
  const Sheet sheet = sheet_for(model);
  const double width = std::ceil(sheet.width + label_width), height = std::ceil(sheet.height + footer);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Arial, Liberation Sans, Helvetica, sans-serif\" font-size=\"13\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      width, height, escape_markup(model.layout));
  out += fmt::format(
      "<clipPath id=\"frame\"><rect width=\"{:.2f}\" height=\"{:.2f}\"/></clipPath>\n<g "
      "clip-path=\"url(#frame)\">\n",
      sheet.width, sheet.height);
  for (const DrawnShape& terrain : model.terrains) out += terrain_part(terrain, sheet);
  const double line = model.blocks.size() > 300 ? 0.45 : 0.7;
  out += fmt::format("<g stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\">\n",
                     to_hex(ink::outline), line);
  for (const DrawnShape& block : model.blocks) out += block_part(block, sheet);
  return out + "</g>\n" + bonds_part(model, sheet) + links_part(model, sheet) + "</g>\n" +
         storeys_part(model, sheet) + scale_bar_part(sheet) + "</svg>\n";
}

}  // namespace dougong::app
