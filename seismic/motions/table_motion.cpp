#include "seismic/motions/table_motion.h"

#include <cmath>
#include <stdexcept>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"
#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

using engine::Vec2;

// The right-hand sides 6 d'' of the spline's equations; the ends have slope zero.
std::vector<Vec2> curvatures(const std::vector<Vec2>& d, double h) {
  const std::size_t last = d.size() - 1;
  std::vector<Vec2> r(d.size());
  const double factor = 6.0 / (h * h);
  r[0] = factor * (d[1] - d[0]);
  for (std::size_t k = 1; k < last; ++k) r[k] = factor * ((d[k - 1] - d[k]) + (d[k + 1] - d[k]));
  r[last] = factor * (d[last - 1] - d[last]);
  return r;
}

// Thomas' algorithm on the rows (2 1), (1 4 1) ... (1 2): diagonally dominant, so no pivoting.
std::vector<Vec2> solve_spline(std::vector<Vec2> r) {
  const std::size_t n = r.size();
  std::vector<double> above(n);
  double pivot = 2.0;
  r[0] = (1.0 / pivot) * r[0];
  for (std::size_t k = 1; k < n; ++k) {
    above[k - 1] = 1.0 / pivot;
    pivot = (k + 1 == n ? 2.0 : 4.0) - above[k - 1];
    r[k] = (1.0 / pivot) * (r[k] - r[k - 1]);
  }
  for (std::size_t k = n - 1; k-- > 0;) r[k] -= above[k] * r[k + 1];
  return r;
}

struct Row {
  double time = 0.0;
  Vec2 displacement;
};

bool is_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

// One line of the table; false for a blank one, a comment or the head.
bool read_row(const FileText& text, std::size_t line, bool first, Row& row) {
  const std::string_view words = trimmed(text.lines[line]);
  if (words.empty() || words.front() == '#' || (first && !is_number(words.front()))) return false;
  const NumberLine numbers = parse_numbers(words);
  const bool sound = numbers.numeric && numbers.culprit.empty() &&
                     (numbers.values.size() == 2 || numbers.values.size() == 3);
  if (!sound)
    throw InputError(text.name, line + 1, "time, displacement x and, if any, displacement y as numbers",
                     in_quotes(words));
  row.time = numbers.values[0];
  row.displacement = {numbers.values[1], numbers.values.size() == 3 ? numbers.values[2] : 0.0};
  return true;
}

void check_times(const std::string& file, const std::vector<Row>& rows) {
  if (rows.size() < 2) throw InputError(file, 0, "at least two rows of a table", std::to_string(rows.size()));
  const double h = rows[1].time - rows[0].time;
  if (rows[0].time != 0.0)
    throw InputError(file, 0, "a table that starts at time 0", std::to_string(rows[0].time));
  if (!(h > 0.0)) throw InputError(file, 0, "times that grow", std::to_string(h));
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (std::abs(rows[k].time - h * static_cast<double>(k)) > 1e-3 * h)
      throw InputError(file, 0, "equal intervals of " + std::to_string(h) + " s",
                       "the time " + std::to_string(rows[k].time) + " s in row " + std::to_string(k + 1));
}

}  // namespace

TableMotion::TableMotion(std::vector<Vec2> displacements, double interval)
    : displacements_(std::move(displacements)), interval_(interval) {
  if (displacements_.size() < 2 || !(interval_ > 0.0) || !std::isfinite(interval_))
    throw std::invalid_argument("a table of motion needs two rows and a positive interval");
  accelerations_ = solve_spline(curvatures(displacements_, interval_));
}

engine::MotionSample TableMotion::at(double t) const {
  if (!(t > 0.0)) return {displacements_.front(), {}, t == 0.0 ? accelerations_.front() : Vec2{}};
  const std::size_t last = displacements_.size() - 1;
  const double steps = t / interval_;
  if (steps >= static_cast<double>(last)) return {displacements_.back(), {}, {}};
  const auto k = static_cast<std::size_t>(steps);
  const double h = interval_, s = t - h * static_cast<double>(k);
  const Vec2 d0 = displacements_[k], d1 = displacements_[k + 1], m0 = accelerations_[k],
             jerk = (1.0 / h) * (accelerations_[k + 1] - m0);
  const Vec2 slope = (1.0 / h) * (d1 - d0) - h * (0.5 * m0 + (h / 6.0) * jerk);
  return {d0 + s * (slope + s * (0.5 * m0 + (s / 6.0) * jerk)), slope + s * (m0 + (0.5 * s) * jerk),
          m0 + s * jerk};
}

MotionTable read_motion_table(const std::filesystem::path& path) {
  FileText text;
  load_file(path, text);
  std::vector<Row> rows;
  for (std::size_t line = 0; line < text.lines.size(); ++line)
    if (Row row; read_row(text, line, rows.empty(), row)) rows.push_back(row);
  check_times(text.name, rows);
  MotionTable table{{}, rows[1].time - rows[0].time, text.sha256};
  for (const Row& row : rows) table.displacements.push_back(row.displacement);
  return table;
}

}  // namespace dougong::seismic
