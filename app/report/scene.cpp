#include "app/report/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/lettering.h"
#include "app/report/raster.h"
#include "app/report/text.h"
#include "app/study/output_times.h"

namespace dougong::app {
namespace {

using engine::Vec2;

constexpr std::size_t most_frames = 8;
constexpr double outline_width = 0.7;      // px at 1x; less on tiny blocks
constexpr double small_motion = 0.015;     // of the building's height: below, displacement is magnified
constexpr double magnified_motion = 0.06;  // of the building's height, after magnification
constexpr double lightened = 0.22;         // share of white in viridis, so that dark outlines still show
constexpr double strip_width = 900, single_height = 620, narrow_height = 440;  // px at 1x
constexpr double narrow = 600;  // px at 1x; below, annotation is stacked
constexpr double page_margin = 14, cell_gap = 12, legend_width = 170;

/// First and last stay; of the others as many as fit, evenly.
std::vector<Frame> thinned(const std::vector<Frame>& frames) {
  if (frames.size() <= most_frames) return frames;
  std::vector<Frame> out;
  for (std::size_t i = 0; i < most_frames; ++i)
    out.push_back(frames[i * (frames.size() - 1) / (most_frames - 1)]);
  return out;
}

double size_of(const ModelSheet& model) {
  const Box box = model_bounds(model);
  return std::max(box.height(), 0.3 * box.width());
}

// Of the blocks that are on the stage.
double largest_movement(const RunResult& run, const std::vector<Frame>& frames) {
  const Box shown = stage(run.model);
  double largest = 0.0;
  for (const Frame& frame : frames) {
    for (std::size_t i = 0; i < run.trajectory.blocks; ++i) {
      const double distance = moved(run.trajectory, frame.step, i);
      if (!std::isfinite(distance) || !shown.holds(pose_at(run.trajectory, frame.step, i, 1.0).position))
        continue;
      largest = std::max(largest, distance);
    }
  }
  return largest;
}

double magnification_for(double movement, double size) {
  if (movement <= 1e-9 * size || movement >= small_motion * size) return 1.0;
  return round_below(magnified_motion * size / movement);
}

// ---- the world ----

void draw_hatch(Drawing& drawing, Vec2 from, Vec2 to, double scale) {
  const double spacing = 7.0 * scale, length = 6.0 * scale;
  const double span = engine::norm(to - from);
  if (span <= 0.0) return;
  const Vec2 along = (1.0 / span) * (to - from), inwards = engine::turned(along);
  for (double s = spacing; s < std::min(span, 20000.0); s += spacing) {
    const Vec2 p = from + s * along;
    drawing.line(p, p + length * (inwards - 0.7 * along), 0.8 * scale, ink::hatch);
  }
  drawing.line(from, to, 1.3 * scale, ink::outline);
}

/// A flat mid-grey, hatched along every edge that faces up.
void draw_ground(Drawing& drawing, const std::vector<Vec2>& outline, double scale) {
  if (outline.size() < 3) return;
  drawing.polygon(outline, ink::terrain);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (a.x - b.x > 0.3 * engine::norm(b - a)) draw_hatch(drawing, a, b, scale);
  }
}

std::vector<Vec2> in_pixels(const std::vector<Vec2>& world, const Camera& camera) {
  std::vector<Vec2> out;
  for (const Vec2 p : world) out.push_back(camera.to_pixels(p));
  return out;
}

/// Cut a little outside the picture, so that no cut edge is seen.
void draw_terrain(Drawing& drawing, const DrawnShape& terrain, const Camera& camera, double scale,
                  Vec2 displacement = {}) {
  const Pose pose{terrain.position + displacement, terrain.angle};
  const Box box = camera.box.grown(20.0 * scale / camera.pixels_per_metre);
  for (const auto& outline : outlines(terrain, pose))
    draw_ground(drawing, in_pixels(clipped_outline(outline, box), camera), scale);
}

double smallest_side(const std::vector<Vec2>& outline) {
  double side = INFINITY;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    side = std::min(side, engine::norm(outline[(i + 1) % outline.size()] - outline[i]));
  }
  return side;
}

bool drawable(const std::vector<Vec2>& outline) {
  return outline.size() > 2 && std::all_of(outline.begin(), outline.end(), [](Vec2 p) {
           return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6;  // false for NaN too
         });
}

void draw_piece(Drawing& drawing, const std::vector<Vec2>& outline, bool round, Colour fill, double scale) {
  const double width =
      round ? outline_width : std::clamp(0.1 * smallest_side(outline) / scale, 0.35, outline_width);
  drawing.polygon(outline, fill);
  drawing.outline(outline, width * scale, ink::outline);
}

/// A circle too small to be seen is drawn as a dot.
DrawnShape seen(const DrawnShape& block, const Camera& camera, double scale) {
  constexpr double dot = 3.0;  // px at 1x
  DrawnShape larger = block;
  if (block.radius > 0.0) larger.radius = std::max(block.radius, dot * scale / camera.pixels_per_metre);
  return larger;
}

/// A line from the centre of a circle shows how far it has turned.
void draw_block(Drawing& drawing, const DrawnShape& described, const Pose& pose, const Camera& camera,
                Colour fill, double scale) {
  const DrawnShape block = seen(described, camera, scale);
  const bool round = block.outline.empty() && block.parts.empty();
  std::vector<Vec2> last;
  for (const auto& outline : outlines(block, pose)) {
    last = in_pixels(outline, camera);
    if (!drawable(last)) return;
    draw_piece(drawing, last, round, fill, scale);
  }
  if (round && block.radius == described.radius)
    drawing.line(camera.to_pixels(pose.position), last[0], outline_width * scale, ink::outline);
}

Colour scale_colour(double value, double largest) {
  return mixed(viridis(1.0 - (largest > 0 ? std::min(1.0, value / largest) : 0.0)), ink::white, lightened);
}

void draw_undeformed(Drawing& drawing, const RunResult& run, const Camera& camera, double scale) {
  for (std::size_t i = 0; i < run.trajectory.blocks; ++i) {
    for (const auto& world : outlines(run.model.blocks[i], pose_at(run.trajectory, 0, i, 1.0))) {
      const auto outline = in_pixels(world, camera);
      if (drawable(outline)) drawing.outline(outline, 0.6 * scale, ink::pale);
    }
  }
}

/// The way of every body so far, in a colour of its own.
void draw_trails(Drawing& drawing, const RunResult& run, const Frame& frame, const Camera& camera,
                 double scale) {
  constexpr std::size_t segments = 240;
  const std::size_t stride = frame.step / segments + 1;
  for (std::size_t i = 0; i < run.trajectory.blocks; ++i) {
    for (std::size_t from = 0; from < frame.step; from += stride) {
      const std::size_t to = std::min(from + stride, frame.step);
      const Vec2 a = camera.to_pixels(pose_at(run.trajectory, from, i, 1.0).position),
                 b = camera.to_pixels(pose_at(run.trajectory, to, i, 1.0).position);
      if (drawable({a, b, a})) drawing.line(a, b, 1.2 * scale, mixed(category(i), ink::white, 0.35));
    }
  }
}

Vec2 terrain_displacement(const RunResult& run, std::size_t step, std::size_t terrain) {
  const std::size_t index = step * run.model.terrains.size() + terrain;
  return index < run.terrain_displacement.size() ? run.terrain_displacement[index] : Vec2{};
}

/// Joints: a line between the anchors, a ring at each; of a pin, whose anchors coincide, one ring.
template <class PoseOf>
void draw_links(Drawing& drawing, const ModelSheet& model, const Camera& camera, double scale,
                PoseOf pose_of) {
  DrawnShape ring;
  ring.radius = 2.6 * scale;
  for (const DrawnLink& link : model.links) {
    const auto end = [&](std::size_t owner, Vec2 anchor) {
      const Pose pose = pose_of(owner);
      return camera.to_pixels(pose.position + engine::rotated(anchor, pose.angle));
    };
    const Vec2 a = end(link.a, link.anchor_a), b = end(link.b, link.anchor_b);
    if (!drawable({a, b, a})) continue;
    if (engine::norm(b - a) > scale) drawing.line(a, b, 1.2 * scale, ink::outline);
    for (const Vec2 p : {a, b}) {
      drawing.polygon(corners(ring, {p, 0.0}), ink::white);
      drawing.outline(corners(ring, {p, 0.0}), 1.0 * scale, ink::outline);
    }
  }
}

/// Bonds: the bonded face in blue, cracked in orange, crushed in violet, broken as a thin red line.
template <class PoseOf>
void draw_bonds(Drawing& drawing, const ModelSheet& model, const Camera& camera, double scale, double time,
                PoseOf pose_of) {
  for (const DrawnBond& bond : model.bonded) {
    const Pose pose = pose_of(bond.owner);
    const auto at = [&](Vec2 local) {
      return camera.to_pixels(pose.position + engine::rotated(local, pose.angle));
    };
    const Vec2 a = at(bond.start), b = at(bond.end);
    if (!drawable({a, b, a})) continue;
    const bool broken = bond.broken <= time, cracked = bond.cracked <= time;
    const bool crushed = bond.crushed <= time;
    const Colour colour = broken ? ink::lost : crushed ? ink::crushed : cracked ? ink::cracked : ink::bond;
    drawing.line(a, b, (broken ? 0.9 : 2.4) * scale, colour);
  }
}

Image world_image(const RunResult& run, const Frame& frame, const SceneView& view, int width, int height) {
  Camera camera{view.box, width / view.box.width()};
  Drawing drawing;
  for (std::size_t i = 0; i < run.model.terrains.size(); ++i)
    draw_terrain(drawing, run.model.terrains[i], camera, view.scale,
                 terrain_displacement(run, frame.step, i));
  if (run.model.trails) draw_trails(drawing, run, frame, camera, view.scale);
  if (view.magnification != 1.0) draw_undeformed(drawing, run, camera, view.scale);
  for (std::size_t i = 0; i < std::min(run.trajectory.blocks, run.model.blocks.size()); ++i) {
    const Colour fill = scale_colour(coloured_by(run, view.colour, frame.step, i), view.largest);
    draw_block(drawing, run.model.blocks[i], pose_at(run.trajectory, frame.step, i, view.magnification),
               camera, fill, view.scale);
  }
  const auto pose_of = [&](std::size_t owner) {
    if (owner < run.trajectory.blocks) return pose_at(run.trajectory, frame.step, owner, view.magnification);
    const std::size_t terrain = owner - run.trajectory.blocks;
    const Pose pose = described_pose(run.model.terrains[terrain]);
    return Pose{pose.position + terrain_displacement(run, frame.step, terrain), pose.angle};
  };
  draw_bonds(drawing, run.model, camera, view.scale, frame.time, pose_of);
  draw_links(drawing, run.model, camera, view.scale, pose_of);
  return drawing.render(width, height);
}

/// Blocks that cannot be seen: out of the box, or nowhere because the numbers failed.
std::size_t out_of_sight(const RunResult& run, const Frame& frame, const SceneView& view) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(run.trajectory.blocks, run.model.blocks.size()); ++i) {
    const Vec2 p = pose_at(run.trajectory, frame.step, i, view.magnification).position;
    const bool inside =
        p.x > view.box.low.x && p.x < view.box.high.x && p.y > view.box.low.y && p.y < view.box.high.y;
    count += inside ? 0 : 1;
  }
  return count;
}

// ---- the annotation ----

int px(double at_1x, double scale) {
  return static_cast<int>(std::lround(at_1x * scale));
}

struct Fonts {
  Lettering title, text, small;
  explicit Fonts(double scale) : title(15 * scale), text(12.5 * scale), small(11 * scale) {}
};

std::string length_text(double metres) {
  return metres < 1.0 ? fmt::format("{:g} cm", 100 * metres) : fmt::format("{:g} m", metres);
}

void draw_scale_bar(Image& image, const Fonts& fonts, double x, double y, double pixels_per_metre,
                    double scale) {
  const double metres = round_below(130.0 * scale / pixels_per_metre), length = metres * pixels_per_metre;
  const int half = px(length / scale / 2, scale), thick = px(4, scale), left = static_cast<int>(x),
            up = static_cast<int>(y);
  image.fill_rectangle(left, up, 2 * half, thick, ink::outline);
  image.fill_rectangle(left + half, up + px(1, scale), half - px(1, scale), thick - 2 * px(1, scale),
                       ink::white);
  fonts.small.draw(image, length_text(metres), x + length + 7 * scale, y + 6.5 * scale, ink::text);
}

bool stacked(const Image& image, double scale) {
  return image.width < narrow * scale;
}

/// "250 mm", "1.2 m/s".
std::string end_of_scale(const SceneView& view) {
  if (!view.unit.empty()) return fmt::format("{:.4g} {}", view.largest, view.unit);
  return view.largest >= 1.0 ? fmt::format("{:.4g} m", view.largest)
                             : fmt::format("{:.4g} mm", 1e3 * view.largest);
}

/// "0 .. 250 mm" as a coloured bar with its meaning.
void draw_legend(Image& image, const Fonts& fonts, double right, double y, const SceneView& view) {
  const double scale = view.scale;
  const int width = px(legend_width, scale), left = static_cast<int>(right) - width;
  for (int i = 0; i < width; ++i) {
    image.fill_rectangle(left + i, static_cast<int>(y), 1, px(8, scale), scale_colour(i, width - 1));
  }
  const double below = y + 20 * scale;
  fonts.small.draw(image, "0", left, below, ink::text);
  fonts.small.draw(image, end_of_scale(view), right, below, ink::text, Align::right);
  if (stacked(image, scale)) return fonts.small.draw(image, view.meaning, left, y - 6 * scale, ink::text);
  fonts.small.draw(image, view.meaning, left - 9 * scale, y + 8 * scale, ink::text, Align::right);
}

std::string camera_note(const SceneView& view) {
  std::string note = view.camera;
  if (view.magnification != 1.0) {
    note += fmt::format("{}Displacement × {:g}; pale outline: undeformed.", note.empty() ? "" : " ",
                        view.magnification);
  }
  return note;
}

constexpr double note_line_height = 14;  // px at 1x

std::vector<std::string> note_lines(const Fonts& fonts, const SceneView& view, double width) {
  return fonts.small.wrapped(camera_note(view), (width - 2 * page_margin) * view.scale);
}

/// px at 1x, with room for every line of the note.
double footer_height(const Fonts& fonts, const SceneView& view, double width) {
  const double lines = static_cast<double>(note_lines(fonts, view, width).size());
  return width < narrow ? 88 + note_line_height * std::max(2.0, lines)
                        : 36 + note_line_height * std::max(1.0, lines);
}

/// On a narrow picture the legend stands below the scale bar, its meaning above it.
void draw_footer(Image& image, const Fonts& fonts, const SceneView& view, double pixels_per_metre) {
  const double s = view.scale, left = page_margin * s;
  const double y = image.height - (footer_height(fonts, view, image.width / s) - 8) * s;
  draw_scale_bar(image, fonts, left, y + 2 * s, pixels_per_metre, s);
  double note_line = y + 34 * s;
  if (stacked(image, s)) {
    draw_legend(image, fonts, left + legend_width * s, y + 40 * s, view);
    note_line = y + 84 * s;
  } else {
    draw_legend(image, fonts, image.width - left, y, view);
  }
  for (const std::string& line : note_lines(fonts, view, image.width / s)) {
    fonts.small.draw(image, line, left, note_line, ink::quiet);
    note_line += note_line_height * s;
  }
}

void draw_header(Image& image, const Fonts& fonts, const std::string& title, const std::string& line,
                 double right_room, double s) {
  const double most = image.width - 2 * page_margin * s - right_room;
  fonts.title.draw(image, fonts.title.cut(title, most), page_margin * s, 24 * s, ink::text);
  fonts.text.draw(image, fonts.text.cut(line, most), page_margin * s, 42 * s, ink::quiet);
}

/// The fonts of pictures have no raised digits: stars are written plainly.
std::string drawn_mass(double kilograms) {
  return kilograms < 1e9 ? mass_text(kilograms) : fmt::format("{:.3g} kg", kilograms);
}

/// What shakes it; of a scene that stands still, what it is.
std::string shaken_by(const RunResult& run) {
  if (!run.motion.title.empty() || !run.model.free_scene) return "on " + run.motion.title;
  return plural(run.model.blocks.size(), "body") + ", " + drawn_mass(run.model.mass);
}

constexpr double header_height = 54;  // px at 1x

double single_header(double width) {
  return width < narrow ? 72 : header_height;
}

/// Time and event at the right; on a narrow picture the event has a line of its own.
void draw_single_header(Image& image, const RunResult& run, const Frame& frame, const Fonts& fonts,
                        double s) {
  const std::string stamp = "t = " + seconds(frame.time);
  const double right = image.width - page_margin * s;
  const double caption_room = stacked(image, s) ? 0.0 : 0.33 * image.width;
  fonts.title.draw(image, stamp, right, 24 * s, ink::text, Align::right);
  const double title_room = image.width - 3 * page_margin * s - fonts.title.width(stamp);
  fonts.title.draw(image, fonts.title.cut(run.model.layout, title_room), page_margin * s, 24 * s, ink::text);
  const double line_room = image.width - 2 * page_margin * s - caption_room;
  fonts.text.draw(image, fonts.text.cut(shaken_by(run), line_room), page_margin * s, 42 * s, ink::quiet);
  if (caption_room > 0) {
    fonts.text.draw(image, fonts.text.cut(frame.caption, caption_room), right, 42 * s, ink::quiet,
                    Align::right);
  } else {
    fonts.text.draw(image, fonts.text.cut(frame.caption, line_room), page_margin * s, 60 * s, ink::text);
  }
}

std::string frame_note(const RunResult& run, const Frame& frame, const SceneView& view) {
  const std::size_t missing = out_of_sight(run, frame, view);
  return missing == 0 ? "" : plural(missing, "block") + " outside the picture";
}

// ---- the film strip ----

int columns_for(std::size_t frames, double aspect) {
  const int n = static_cast<int>(frames);
  if (n == 4) return aspect > 1.25 ? 2 : 4;
  if (aspect > 1.9) return std::min(n, 2);
  if (aspect > 1.25) return n > 6 && aspect < 1.6 ? 4 : std::min(n, 3);
  if (aspect > 0.62) return n == 5 || n == 6 ? 3 : std::min(n, 4);
  return n <= 6 ? n : (n + 1) / 2;
}

struct Grid {
  int columns, rows, cell_width, picture_height, caption_height;
  int cell_height() const { return picture_height + caption_height; }
};

Grid grid_for(const RunResult&, const std::vector<Frame>& frames, const SceneView& view, const Fonts& fonts) {
  Grid grid{};
  const double s = view.scale;
  grid.columns = columns_for(frames.size(), view.box.aspect());
  grid.rows = (static_cast<int>(frames.size()) + grid.columns - 1) / grid.columns;
  const double room = (strip_width - 2 * page_margin - cell_gap * (grid.columns - 1)) * s;
  grid.cell_width = static_cast<int>(room / grid.columns);
  grid.picture_height = static_cast<int>(grid.cell_width / view.box.aspect());
  std::size_t lines = 1;
  for (const Frame& f : frames)
    lines = std::max(lines, fonts.text.wrapped(f.caption, grid.cell_width).size());
  grid.caption_height = static_cast<int>((26 + 16 * static_cast<double>(lines)) * s);
  return grid;
}

void draw_cell(Image& image, const RunResult& run, const Frame& frame, const SceneView& view,
               const Fonts& fonts, const Grid& grid, int x, int y) {
  const double s = view.scale;
  fonts.text.draw(image, "t = " + seconds(frame.time), x, y + 15 * s, ink::text);
  double baseline = y + 31 * s;
  for (const std::string& line : fonts.text.wrapped(frame.caption, grid.cell_width)) {
    fonts.text.draw(image, line, x, baseline, ink::quiet);
    baseline += 16 * s;
  }
  image.paste(world_image(run, frame, view, grid.cell_width, grid.picture_height), x,
              y + grid.caption_height);
  const std::string note = frame_note(run, frame, view);
  if (!note.empty()) fonts.small.draw(image, note, x + 3 * s, y + grid.caption_height + 13 * s, ink::lost);
}

// ---- the model ----

Colour storey_colour(int storey) {
  return storey < 0 ? ink::block : mixed(category(static_cast<std::size_t>(storey)), ink::white, 0.66);
}

void label_storeys(Image& image, const Fonts& fonts, const ModelSheet& model, const Camera& camera,
                   double top, double left, double s) {
  std::vector<double> lettered;  // px: neighbours' storeys may lie at one height
  for (std::size_t i = model.storeys.size(); i-- > 0;) {
    const StoreySheet& storey = model.storeys[i];
    const double middle = storey.base + 0.5 * storey.height;
    const double y = top + camera.pixels_per_metre * (camera.box.high.y - middle);
    if (std::ranges::any_of(lettered, [&](double other) { return std::abs(y - other) < 15 * s; })) continue;
    fonts.small.draw(image, storey.name + ", h " + significant(storey.height, 3) + " m", left, y + 4 * s,
                     ink::text);
    lettered.push_back(y);
  }
}

/// A picture's size for a box: as wide as allowed, as tall as allowed.
std::pair<int, int> picture_size(const Box& box, double most_width, double scale) {
  const double most_height = most_width < narrow ? narrow_height : single_height;
  const double width = std::min(most_width - 2 * page_margin, most_height * box.aspect());
  return {px(width, scale), px(width / box.aspect(), scale)};
}

}  // namespace

std::vector<Frame> frames_of(const RunResult& run) {
  const auto& times = run.trajectory.times;
  if (times.empty() || run.trajectory.poses.size() < 3 * times.size() * run.trajectory.blocks) return {};
  std::vector<Moment> moments = run.moments;
  std::stable_sort(moments.begin(), moments.end(),
                   [](const Moment& a, const Moment& b) { return a.time < b.time; });
  std::vector<Frame> frames;
  const auto add = [&](double time, const std::string& caption) {
    const std::size_t step = nearest_step(times, time);
    if (frames.empty() || frames.back().step != step)
      frames.push_back({step, times[step], caption});
    else if (frames.back().caption != caption)
      frames.back().caption += "; " + caption;
  };
  if (moments.empty() || nearest_step(times, moments.front().time) != 0) add(times.front(), "before");
  for (const Moment& moment : moments) add(moment.time, moment.caption);
  if (frames.back().step + 1 != times.size())
    add(times.back(), run.partial ? "where the run was interrupted" : "end");
  return thinned(frames);
}

const Frame& telling_frame(const RunResult& run, const std::vector<Frame>& frames) {
  if (run.verdict.kind != structures::VerdictKind::survived) return frames.back();
  const auto largest = [&](const Frame& f) {
    double d = 0.0;
    for (std::size_t i = 0; i < run.trajectory.blocks; ++i) d = std::max(d, moved(run.trajectory, f.step, i));
    return d;
  };
  return *std::max_element(frames.begin(), frames.end(),
                           [&](const Frame& a, const Frame& b) { return largest(a) < largest(b); });
}

std::string bonds_text(const ModelSheet& model) {
  const bool crushed = std::ranges::any_of(
      model.bonded, [](const DrawnBond& bond) { return bond.crushed < DrawnBond::never; });
  return std::string("Bonds: blue; cracked orange, ") + (crushed ? "crushed violet, " : "") + "broken red.";
}

SceneView view_of(const RunResult& run, const std::vector<Frame>& frames) {
  SceneView view;
  const double movement = largest_movement(run, frames);
  view.magnification = magnification_for(movement, size_of(run.model));
  view.largest = movement > 0 ? round_up(movement) : 1e-3;
  std::vector<std::size_t> steps;
  for (const Frame& frame : frames) steps.push_back(frame.step);
  if (run.model.free_scene) {
    const bool rides =
        std::ranges::any_of(run.trajectory.ground_displacement, [](Vec2 d) { return d != Vec2{}; });
    view.camera = rides ? "Camera fixed to the ground." : "";
    view.meaning =
        rides ? "displacement relative to the ground since the start" : "displacement since the start";
  }
  if (!run.model.bonded.empty())
    view.camera += std::string(view.camera.empty() ? "" : " ") + bonds_text(run.model);
  view.box = framed(run_bounds(run, steps, view.magnification));
  return view;
}

Image draw_scene(const RunResult& run, const Frame& frame, const SceneView& view) {
  const Fonts fonts(view.scale);
  const double s = view.scale, head = single_header(view.width);
  const auto [width, height] = picture_size(view.box, view.width, s);
  Image image(px(view.width, s), px(head + footer_height(fonts, view, view.width), s) + height);
  draw_single_header(image, run, frame, fonts, s);
  image.paste(world_image(run, frame, view, width, height), (image.width - width) / 2, px(head, s));
  fonts.small.draw(image, frame_note(run, frame, view), page_margin * s, (head + 14) * s, ink::lost);
  draw_footer(image, fonts, view, width / view.box.width());
  return image;
}

Image draw_scene(const RunResult& run, std::size_t step) {
  std::vector<Frame> frames = frames_of(run);
  const Frame frame{step, run.trajectory.times.at(step), ""};
  frames.push_back(frame);
  return draw_scene(run, frame, view_of(run, frames));
}

Image draw_film_strip(const RunResult& run, const std::vector<Frame>& frames, const SceneView& view) {
  const Fonts fonts(view.scale);
  const double s = view.scale;
  const Grid grid = grid_for(run, frames, view, fonts);
  const int row_height = grid.cell_height() + px(cell_gap, s);
  Image image(px(strip_width, s),
              px(header_height + footer_height(fonts, view, strip_width), s) + grid.rows * row_height);
  draw_header(image, fonts, run.model.layout, shaken_by(run), 0.0, s);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const int column = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
    draw_cell(image, run, frames[i], view, fonts, grid,
              px(page_margin, s) + column * (grid.cell_width + px(cell_gap, s)),
              px(header_height, s) + row * row_height);
  }
  draw_footer(image, fonts, view, grid.cell_width / view.box.width());
  return image;
}

Image draw_model(const ModelSheet& model) {
  const double s = SceneView{}.scale;
  const Fonts fonts(s);
  const Box box = framed(model_bounds(model));
  const auto [width, height] = picture_size(box, SceneView{}.width, s);
  const Camera camera{box, width / box.width()};
  Drawing drawing;
  for (const DrawnShape& terrain : model.terrains) draw_terrain(drawing, terrain, camera, s);
  for (const DrawnShape& block : model.blocks)
    draw_block(drawing, block, described_pose(block), camera, storey_colour(block.storey), s);
  const auto pose_of = [&](std::size_t owner) {
    return described_pose(owner < model.blocks.size() ? model.blocks[owner]
                                                      : model.terrains[owner - model.blocks.size()]);
  };
  draw_bonds(drawing, model, camera, s, 0.0, pose_of);
  draw_links(drawing, model, camera, s, pose_of);
  const double label_room = model.storeys.empty() ? 14 : 120, least_width = 460, footer = 50;
  Image image(std::max(width + px(label_room + page_margin, s), px(least_width, s)),
              px(header_height + footer, s) + height);
  draw_header(image, fonts, model.layout, model.title, 0.0, s);
  image.paste(drawing.render(width, height), px(page_margin, s), px(header_height, s));
  label_storeys(image, fonts, model, camera, header_height * s, width + 2 * page_margin * s, s);
  const double foot = image.height - (footer - 8) * s;
  draw_scale_bar(image, fonts, page_margin * s, foot, camera.pixels_per_metre, s);
  const std::string counts = model.free_scene ? plural(model.blocks.size(), "body")
                                              : "Colour: storey. " + plural(model.blocks.size(), "block");
  std::string line = counts + ", " + drawn_mass(model.mass);
  if (!model.links.empty()) line += ", " + plural(model.links.size(), "joint") + " (rings)";
  if (!model.bonded.empty()) line += ", " + plural(model.bonded.size(), "bond") + " (blue)";
  fonts.small.draw(image, line + ".", page_margin * s, foot + 32 * s, ink::quiet);
  return image;
}

}  // namespace dougong::app
