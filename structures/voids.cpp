#include "structures/voids.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dougong::structures {
namespace {

using engine::Vec2;

constexpr double most_cells = 4e6;

enum class Cell : char { open, filled, covered };

struct Grid {
  Vec2 low;           // m, corner of the first cell
  double size = 0.0;  // m, of a cell
  std::ptrdiff_t columns = 0, rows = 0;
  std::vector<Cell> cells;  // row by row from below

  std::size_t index(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(row * columns + column);
  }
  Vec2 middle(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return low + size * Vec2{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
  }
  bool covered(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return column >= 0 && column < columns && row >= 0 && row < rows &&
           cells[index(column, row)] == Cell::covered;
  }
};

Grid empty_grid(const Extent& box) {
  Grid grid;
  grid.low = box.low;
  grid.size = std::max(0.1 * void_diameter, std::sqrt(box.width() * box.height() / most_cells));
  grid.columns = static_cast<std::ptrdiff_t>(std::ceil(box.width() / grid.size));
  grid.rows = static_cast<std::ptrdiff_t>(std::ceil(box.height() / grid.size));
  grid.cells.assign(static_cast<std::size_t>(grid.columns * grid.rows), Cell::open);
  return grid;
}

bool holds(const Outline& outline, Vec2 p) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (engine::cross(b - a, p - a) < 0.0) return false;
  }
  return true;
}

/// The cells whose middles lie in the outline.
void fill(const Outline& outline, Grid& grid) {
  const Extent box = extent_of(outline);
  const auto cell = [&](double distance, std::ptrdiff_t most) {
    return static_cast<std::ptrdiff_t>(std::clamp(distance / grid.size, 0.0, static_cast<double>(most)));
  };
  const std::ptrdiff_t right = std::min(cell(box.high.x - grid.low.x, grid.columns) + 1, grid.columns),
                       top = std::min(cell(box.high.y - grid.low.y, grid.rows) + 1, grid.rows);
  for (std::ptrdiff_t row = cell(box.low.y - grid.low.y, grid.rows); row < top; ++row)
    for (std::ptrdiff_t column = cell(box.low.x - grid.low.x, grid.columns); column < right; ++column)
      if (holds(outline, grid.middle(column, row))) grid.cells[grid.index(column, row)] = Cell::filled;
}

void cover(Grid& grid) {
  for (std::ptrdiff_t column = 0; column < grid.columns; ++column) {
    bool under = false;
    for (std::ptrdiff_t row = grid.rows; row-- > 0;) {
      Cell& cell = grid.cells[grid.index(column, row)];
      if (cell == Cell::filled)
        under = true;
      else if (under)
        cell = Cell::covered;
    }
  }
}

/// Squared distance transform of one line: d(p) = min over q of (p - q)^2 + f(q), the lower envelope of
/// parabolas.
void transform(std::vector<double>& f) {
  const std::size_t n = f.size();
  std::vector<std::size_t> roots(n);
  std::vector<double> from(n + 1), out(n);
  std::size_t k = 0;
  from[0] = -std::numeric_limits<double>::infinity();
  const auto x = [](std::size_t i) { return static_cast<double>(i); };
  for (std::size_t q = 1; q < n; ++q) {
    double s = 0.0;
    for (;;) {
      const std::size_t r = roots[k];
      s = ((f[q] + x(q) * x(q)) - (f[r] + x(r) * x(r))) / (2.0 * (x(q) - x(r)));
      if (s > from[k]) break;
      --k;
    }
    roots[++k] = q;
    from[k] = s;
  }
  from[k + 1] = std::numeric_limits<double>::infinity();
  std::size_t j = 0;
  for (std::size_t p = 0; p < n; ++p) {
    while (from[j + 1] < x(p)) ++j;
    out[p] = (x(p) - x(roots[j])) * (x(p) - x(roots[j])) + f[roots[j]];
  }
  f = std::move(out);
}

/// Squared distance (cells) of every void from the nearest cell that is none; what is outside is none.
std::vector<double> squared_distances(const Grid& grid) {
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  const double far = 1e12;
  std::vector<double> d(columns * rows);
  for (std::size_t column = 0; column < columns; ++column) {
    std::vector<double> line(rows + 2, 0.0);
    for (std::size_t row = 0; row < rows; ++row)
      line[row + 1] = grid.cells[row * columns + column] == Cell::covered ? far : 0.0;
    transform(line);
    for (std::size_t row = 0; row < rows; ++row) d[row * columns + column] = line[row + 1];
  }
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<double> line(columns + 2, 0.0);
    for (std::size_t column = 0; column < columns; ++column) line[column + 1] = d[row * columns + column];
    transform(line);
    for (std::size_t column = 0; column < columns; ++column) d[row * columns + column] = line[column + 1];
  }
  return d;
}

/// The space of one void, which is used up.
Void take_space(Grid& grid, const std::vector<double>& distance, std::ptrdiff_t column, std::ptrdiff_t row) {
  Void space;
  double farthest = 0.0;
  std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> open{{column, row}};
  grid.cells[grid.index(column, row)] = Cell::open;
  while (!open.empty()) {
    const auto [c, r] = open.back();
    open.pop_back();
    space.area += grid.size * grid.size;
    if (const double d = distance[grid.index(c, r)]; d > farthest)
      farthest = d, space.middle = grid.middle(c, r);
    for (const auto& [cc, rr] : {std::pair{c - 1, r}, {c + 1, r}, {c, r - 1}, {c, r + 1}}) {
      if (!grid.covered(cc, rr)) continue;
      grid.cells[grid.index(cc, rr)] = Cell::open;
      open.push_back({cc, rr});
    }
  }
  // From middle to middle; the space ends half a cell before.
  space.diameter = (2.0 * std::sqrt(farthest) - 1.0) * grid.size;
  return space;
}

}  // namespace

std::vector<Void> voids(const std::vector<Outline>& blocks, const Extent& within) {
  if (!(within.width() > 0.0 && within.height() > 0.0)) return {};
  Grid grid = empty_grid(within);
  for (const Outline& outline : blocks) fill(outline, grid);
  cover(grid);
  const std::vector<double> distance = squared_distances(grid);
  std::vector<Void> found;
  for (std::ptrdiff_t row = 0; row < grid.rows; ++row)
    for (std::ptrdiff_t column = 0; column < grid.columns; ++column)
      if (grid.covered(column, row)) found.push_back(take_space(grid, distance, column, row));
  std::erase_if(found, [](const Void& space) { return space.diameter < void_diameter; });
  std::ranges::stable_sort(found, std::ranges::greater{}, &Void::diameter);
  return found;
}

}  // namespace dougong::structures
