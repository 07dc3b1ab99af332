#include "app/study/import_outlines.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include "app/study/entries.h"
#include "engine/shape.h"

namespace dougong::app {
namespace {

using engine::Vec2;

const std::string terrain_word = "ground";

[[noreturn]] void fail(const std::string& where, const std::string& message) {
  throw ScenarioError({{where, message}});
}

// --- DXF -------------------------------------------------------------------------------------------------

/// What dxflib calls while it reads.
class Collector : public DL_CreationAdapter {
 public:
  Collector(std::string source, double unit) : source_(std::move(source)), unit_(unit) {}

  void addPolyline(const DL_PolylineData& data) override {
    constexpr int closed = 1;
    open_ = true;
    is_closed_ = (data.flags & closed) != 0;
    current_ = {"", getAttributes().getLayer(), {}};
  }
  void addVertex(const DL_VertexData& v) override {
    if (!open_) return;
    if (v.bulge != 0.0)
      fail(source_, fmt::format("polyline {}: expected straight segments, found an arc", number()));
    current_.corners.push_back({unit_ * v.x, unit_ * v.y});
  }
  void endSequence() override { finish(); }
  void endEntity() override { finish(); }
  void addLine(const DL_LineData&) override { ++found_.left_out; }
  void addCircle(const DL_CircleData&) override { ++found_.left_out; }
  void addArc(const DL_ArcData&) override { ++found_.left_out; }
  void addSpline(const DL_SplineData&) override { ++found_.left_out; }

  Outlines take() {
    finish();
    return std::move(found_);
  }

 private:
  std::size_t number() const { return found_.closed.size() + found_.left_out + 1; }

  /// A vertex of an old POLYLINE is an entity too: a polyline without corners has not begun.
  void finish() {
    if (!open_ || current_.corners.empty()) return;
    open_ = false;
    const Vec2 first = current_.corners.front(), last = current_.corners.back();
    const bool returns = current_.corners.size() > 3 && first.x == last.x && first.y == last.y;
    if (returns) current_.corners.pop_back();
    if (is_closed_ || returns)
      found_.closed.push_back(std::move(current_));
    else
      ++found_.left_out;
  }

  std::string source_;
  double unit_;
  bool open_ = false, is_closed_ = false;
  Outline current_;
  Outlines found_;
};

// --- CSV -------------------------------------------------------------------------------------------------

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cell.erase(0, cell.find_first_not_of(" \t\r\""));
    cell.erase(cell.find_last_not_of(" \t\r\"") + 1);
    cells.push_back(cell);
  }
  return cells;
}

double number_in(const std::string& cell, const std::string& where) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    fail(where, fmt::format("expected a number, found \"{}\"", cell));
  return value;
}

/// In m, from "x (mm)".
double unit_of(const std::string& heading, const std::string& axis, const std::string& where) {
  for (const auto& [name, metres] : {std::pair{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}})
    if (heading == fmt::format("{} ({})", axis, name)) return metres;
  fail(where,
       fmt::format("expected \"{0} (m)\", \"{0} (cm)\" or \"{0} (mm)\", found \"{1}\"", axis, heading));
}

// --- a building of them ----------------------------------------------------------------------------------

struct Extent {
  double low = 1e300, high = -1e300;  // m, upright
};

Extent extent_of(const Outline& outline) {
  Extent extent;
  for (const Vec2 p : outline.corners) {
    extent.low = std::min(extent.low, p.y);
    extent.high = std::max(extent.high, p.y);
  }
  return extent;
}

/// Names of the storeys, bottom up.
std::vector<std::pair<std::string, Extent>> storeys_of(const Outlines& outlines) {
  std::map<std::string, Extent> extents;
  for (const Outline& outline : outlines.closed) {
    if (outline.storey == terrain_word) continue;
    const Extent one = extent_of(outline);
    Extent& all = extents[outline.storey];
    all = {std::min(all.low, one.low), std::max(all.high, one.high)};
  }
  std::vector<std::pair<std::string, Extent>> storeys(extents.begin(), extents.end());
  std::ranges::stable_sort(storeys, {}, [](const auto& storey) { return storey.second.low; });
  return storeys;
}

ShapeChoice shape_of(const Outline& outline, const std::string& source) {
  try {
    const engine::PlacedPolygon placed = engine::make_polygon(outline.corners);
    ShapeChoice shape;
    shape.kind = "polygon";
    shape.corners = placed.polygon.vertices();
    shape.position = placed.centroid;
    return shape;
  } catch (const std::invalid_argument& error) {
    const Vec2 p = outline.corners.empty() ? Vec2{} : outline.corners.front();
    fail(source, fmt::format("outline {} of {} at ({:.3f}, {:.3f}) m: {}", outline.name, outline.storey, p.x,
                             p.y, error.what()));
  }
}

void name_blocks(Outlines& outlines) {
  std::map<std::string, std::size_t> counts;
  for (Outline& outline : outlines.closed) {
    const std::size_t number = ++counts[outline.storey];
    if (outline.name.empty()) outline.name = fmt::format("{}.{}", outline.storey, number);
  }
}

TerrainChoice level_ground(const Outlines& outlines, double y) {
  double low = 1e300, high = -1e300;
  for (const Outline& outline : outlines.closed)
    for (const Vec2 p : outline.corners) low = std::min(low, p.x), high = std::max(high, p.x);
  const double width = 2.0 * (high - low), depth = 1.0;
  TerrainChoice ground;
  ground.name = terrain_word;
  ground.shape.kind = "rectangle";
  ground.shape.width = width, ground.shape.height = depth;
  ground.shape.position = {0.5 * (low + high), y - 0.5 * depth};
  return ground;
}

}  // namespace

Outlines read_dxf_outlines(const std::filesystem::path& path, double unit) {
  std::istringstream text(load_text(path, "a DXF file"));
  Collector collector(path.string(), unit);
  DL_Dxf dxf;
  if (!dxf.in(text, &collector)) fail(path.string(), "expected a DXF file, found something else");
  return collector.take();
}

Outlines read_csv_outlines(const std::filesystem::path& path) {
  std::istringstream text(load_text(path, "a CSV file of outlines"));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> heading = cells_of(line);
  if (heading.size() != 4 || heading[0] != "block" || heading[1] != "storey")
    fail(path.string() + ":1",
         fmt::format("expected the heading \"block,storey,x (m),y (m)\", found \"{}\"", line));
  const double ux = unit_of(heading[2], "x", path.string() + ":1"),
               uy = unit_of(heading[3], "y", path.string() + ":1");
  Outlines found;
  for (std::size_t number = 2; std::getline(text, line); ++number) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.empty()) continue;
    const std::string where = fmt::format("{}:{}", path.string(), number);
    if (cells.size() != 4) fail(where, fmt::format("expected 4 values, found {}", cells.size()));
    if (found.closed.empty() || found.closed.back().name != cells[0])
      found.closed.push_back({cells[0], cells[1], {}});
    if (found.closed.back().storey != cells[1])
      fail(where, fmt::format("block {} is in storey {} above", cells[0], found.closed.back().storey));
    found.closed.back().corners.push_back({ux * number_in(cells[2], where), uy * number_in(cells[3], where)});
  }
  return found;
}

SceneDescription building_from(const Outlines& given, const std::string& source,
                               const std::string& material) {
  Outlines outlines = given;
  name_blocks(outlines);
  const auto storeys = storeys_of(outlines);
  if (storeys.empty()) fail(source, "expected closed outlines of blocks, found none");
  SceneDescription d;
  d.head.title = std::filesystem::path(source).stem().string();
  double base = storeys.front().second.low;
  const double ground = base;
  for (const auto& [name, extent] : storeys) {
    if (!(extent.high > base))
      fail(source,
           fmt::format("storey {}: expected blocks that rise above {:.3f} m, where the one below ends, found "
                       "{:.3f} m",
                       name, base, extent.high));
    d.storeys.push_back({name, base, extent.high - base, {}, {}, false});
    base = extent.high;
  }
  for (const Outline& outline : outlines.closed) {
    if (outline.storey == terrain_word) {
      d.terrains.push_back({outline.name, shape_of(outline, source), material, std::nullopt});
      continue;
    }
    BodyChoice body;
    body.name = outline.name;
    body.shape = shape_of(outline, source);
    body.material = material;
    d.bodies.push_back(std::move(body));
    StoreyChoice& storey = *std::ranges::find(d.storeys, outline.storey, &StoreyChoice::name);
    const bool reaches_top = extent_of(outline).high > storey.base + storey.height - 1e-6;
    (reaches_top ? storey.level : storey.blocks).push_back(outline.name);
  }
  if (d.terrains.empty()) {
    d.terrains.push_back(level_ground(outlines, ground));
    d.terrains.back().material = material;
  }
  d.solve.settle = true;
  return d;
}

}  // namespace dougong::app
