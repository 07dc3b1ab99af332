#include "engine/collision/broad_phase.h"

#include <algorithm>
#include <limits>

namespace dougong::engine {
namespace {

struct Box {
  Vec2 low, high;
  double extent() const { return std::max(high.x - low.x, high.y - low.y); }
  Vec2 centre() const { return 0.5 * (low + high); }
};

constexpr double infinity = std::numeric_limits<double>::infinity();

Box box_of(const Collider& collider, const Frame& frame, double grow) {
  const Vec2 centre = frame.to_world(collider.centre);
  Box box{centre, centre};
  if (const auto* polygon = std::get_if<ConvexPolygon>(&collider.shape)) {
    box = {{infinity, infinity}, {-infinity, -infinity}};
    for (const Vec2 v : polygon->vertices()) {
      const Vec2 p = frame.to_world(v);
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  } else {
    grow += collider.radius;
  }
  return {box.low - Vec2{grow, grow}, box.high + Vec2{grow, grow}};
}

class Sieve {
 public:
  Sieve(const Model& model, std::span<const Frame> frames, double skin)
      : model_(model), frames_(frames), skin_(skin) {
    for (const Collider& collider : model.colliders) {
      boxes_.push_back(box_of(collider, frames[collider.owner], 0.5 * skin));
      centres_.push_back(frames[collider.owner].to_world(collider.centre));
    }
  }
  const std::vector<Box>& boxes() const { return boxes_; }

  void test(Index i, Index j, std::vector<BodyPair>& pairs) const {
    const Index owner_i = model_.colliders[i].owner, owner_j = model_.colliders[j].owner;
    if (owner_i == owner_j || (model_.is_terrain(owner_i) && model_.is_terrain(owner_j))) return;
    if (is_plane(i) ? above(i, j) : is_plane(j) ? above(j, i) : circles_apart(i, j)) return;
    if (boxes_apart(boxes_[i], boxes_[j])) return;
    pairs.push_back({std::min(i, j), std::max(i, j)});
  }

 private:
  bool is_plane(Index i) const { return std::holds_alternative<HalfPlane>(model_.colliders[i].shape); }
  bool above(Index plane, Index other) const {
    const Frame& frame = frames_[model_.colliders[plane].owner];
    return frame.to_local(centres_[other]).y > model_.colliders[other].radius + skin_;
  }
  bool circles_apart(Index i, Index j) const {
    const double reach = model_.colliders[i].radius + model_.colliders[j].radius + skin_;
    const Vec2 d = centres_[i] - centres_[j];
    return dot(d, d) > reach * reach;
  }
  static bool boxes_apart(const Box& a, const Box& b) {
    return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
  }

  const Model& model_;
  std::span<const Frame> frames_;
  double skin_;
  std::vector<Box> boxes_;
  std::vector<Vec2> centres_;
};

double median_extent(const std::vector<Box>& boxes) {
  std::vector<double> extents;
  for (const Box& box : boxes)
    if (box.extent() < infinity) extents.push_back(box.extent());
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  return *middle;
}

// Cells at least as large as any shape in them, so that neighbours of a shape lie in the 3 x 3 cells
// around its own.
struct Grid {
  Vec2 low;
  double cell = 1.0;
  std::size_t columns = 1, rows = 1;
  std::vector<std::size_t> first;  // of each cell, into members; one past the end too
  std::vector<Index> members;

  std::size_t column(double x) const { return clamp_to((x - low.x) / cell, columns); }
  std::size_t row(double y) const { return clamp_to((y - low.y) / cell, rows); }
  std::size_t cell_of(Vec2 p) const { return row(p.y) * columns + column(p.x); }
  static std::size_t clamp_to(double value, std::size_t count) {
    return value <= 0.0 ? 0 : std::min(static_cast<std::size_t>(value), count - 1);
  }
};

Grid size_grid(const std::vector<Box>& boxes, const std::vector<Index>& small, double cell) {
  Grid grid;
  Vec2 high = grid.low = boxes[small[0]].centre();
  for (const Index i : small) {
    const Vec2 c = boxes[i].centre();
    grid.low = {std::min(grid.low.x, c.x), std::min(grid.low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
  // Far-flung debris must not make a huge empty grid: at most about four cells a shape.
  const double budget = 4.0 * static_cast<double>(small.size()) + 16.0;
  const Vec2 span = high - grid.low;
  grid.cell = std::max({cell, std::sqrt(span.x * span.y / budget), std::max(span.x, span.y) / budget});
  grid.columns = static_cast<std::size_t>(span.x / grid.cell) + 1;
  grid.rows = static_cast<std::size_t>(span.y / grid.cell) + 1;
  return grid;
}

Grid fill_grid(const std::vector<Box>& boxes, const std::vector<Index>& small, double cell) {
  Grid grid = size_grid(boxes, small, cell);
  grid.first.assign(grid.columns * grid.rows + 1, 0);
  for (const Index i : small) ++grid.first[grid.cell_of(boxes[i].centre()) + 1];
  for (std::size_t k = 1; k < grid.first.size(); ++k) grid.first[k] += grid.first[k - 1];
  std::vector<std::size_t> next(grid.first.begin(), grid.first.end() - 1);
  grid.members.resize(small.size());
  for (const Index i : small) grid.members[next[grid.cell_of(boxes[i].centre())]++] = i;
  return grid;
}

void test_neighbours(const Sieve& sieve, const Grid& grid, Index i, std::vector<BodyPair>& pairs) {
  const Vec2 centre = sieve.boxes()[i].centre();
  const std::size_t column = grid.column(centre.x), row = grid.row(centre.y);
  for (std::size_t r = row == 0 ? 0 : row - 1; r <= std::min(row + 1, grid.rows - 1); ++r)
    for (std::size_t c = column == 0 ? 0 : column - 1; c <= std::min(column + 1, grid.columns - 1); ++c)
      for (std::size_t k = grid.first[r * grid.columns + c]; k < grid.first[r * grid.columns + c + 1]; ++k)
        if (grid.members[k] > i) sieve.test(i, grid.members[k], pairs);
}

}  // namespace

std::vector<BodyPair> find_pairs(const Model& model, std::span<const Frame> frames, double skin) {
  std::vector<BodyPair> pairs;
  if (model.body_count == 0) return pairs;
  const Sieve sieve(model, frames, skin);
  const double cell = 2.0 * median_extent(sieve.boxes());
  std::vector<Index> small, large;
  for (Index i = 0; i < model.colliders.size(); ++i)
    (sieve.boxes()[i].extent() <= cell ? small : large).push_back(i);

  if (!small.empty()) {
    const Grid grid = fill_grid(sieve.boxes(), small, cell);
    for (const Index i : small) {
      const auto first = static_cast<std::ptrdiff_t>(pairs.size());
      test_neighbours(sieve, grid, i, pairs);
      std::sort(pairs.begin() + first, pairs.end());
    }
  }
  const auto of_large = static_cast<std::ptrdiff_t>(pairs.size());
  for (std::size_t k = 0; k < large.size(); ++k) {
    for (const Index i : small) sieve.test(large[k], i, pairs);
    for (std::size_t l = k + 1; l < large.size(); ++l) sieve.test(large[k], large[l], pairs);
  }
  std::sort(pairs.begin() + of_large, pairs.end());
  std::inplace_merge(pairs.begin(), pairs.begin() + of_large, pairs.end());
  return pairs;
}

}  // namespace dougong::engine
