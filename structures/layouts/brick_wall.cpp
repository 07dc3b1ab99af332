#include "structures/layouts/brick_wall.h"

#include <fmt/format.h>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

// Dry brickwork taken as one material: E of the wall, its joints included, rather than of the brick. Each
// brick rests on two neighbours over the whole face; a ratio of 0.3 settles such faces without making the
// step as short as the plastic landing of a single corner (1) would.
engine::Material masonry() {
  engine::Material material;
  material.name = "masonry";
  material.density = 1800.0;
  material.young_modulus = 1e9;
  material.damping_ratio = 0.3;
  material.friction_coefficient = 0.65;
  return material;
}

struct Course {
  std::size_t number;  // from 1
  double bottom;       // m
  std::string prefix;  // "C03"
};

std::size_t add_brick(Building& building, const ParameterValues& values, const Course& course,
                      std::size_t number, double centre, double width) {
  return add_rectangle(building, values, fmt::format("{}.B{:02}", course.prefix, number), centre,
                       course.bottom, width, values("brick_height"));
}

std::vector<std::size_t> add_full_course(Building& building, const ParameterValues& values,
                                         const Course& course) {
  const std::size_t n = values.count("bricks_per_course");
  const double pitch = values("brick_length") + values("head_joint");
  std::vector<std::size_t> bricks;
  for (std::size_t j = 0; j < n; ++j) {
    const double centre = (static_cast<double>(j) - 0.5 * static_cast<double>(n - 1)) * pitch;
    bricks.push_back(add_brick(building, values, course, j + 1, centre, values("brick_length")));
  }
  return bricks;
}

std::vector<std::size_t> add_shifted_course(Building& building, const ParameterValues& values,
                                            const Course& course) {
  const std::size_t n = values.count("bricks_per_course");
  const double length = values("brick_length"), joint = values("head_joint"), pitch = length + joint;
  const double half = 0.5 * (length - joint);
  const double wall = static_cast<double>(n) * pitch - joint;
  std::vector<std::size_t> bricks;
  bricks.push_back(add_brick(building, values, course, 1, 0.5 * (half - wall), half));
  for (std::size_t j = 1; j < n; ++j) {
    const double centre = (static_cast<double>(j) - 0.5 * static_cast<double>(n)) * pitch;
    bricks.push_back(add_brick(building, values, course, j + 1, centre, length));
  }
  bricks.push_back(add_brick(building, values, course, n + 1, 0.5 * (wall - half), half));
  return bricks;
}

std::vector<std::size_t> add_course(Building& building, const ParameterValues& values, std::size_t number) {
  const Course course{number, static_cast<double>(number - 1) * values("brick_height"),
                      fmt::format("C{:02}", number)};
  return number % 2 == 1 ? add_full_course(building, values, course)
                         : add_shifted_course(building, values, course);
}

/// The courses dealt out to the levels from the bottom; where they do not divide, upper levels get more.
void add_level(Building& building, const ParameterValues& values, std::size_t level) {
  const std::size_t courses = values.count("courses"), levels = values.count("levels");
  const std::size_t first = (level - 1) * courses / levels + 1, last = level * courses / levels;
  Storey storey;
  storey.name = fmt::format("S{}", level);
  storey.base = static_cast<double>(first - 1) * values("brick_height");
  storey.height = static_cast<double>(last - first + 1) * values("brick_height");
  for (std::size_t number = first; number <= last; ++number) {
    storey.level_blocks = add_course(building, values, number);
    storey.storey_blocks.insert(storey.storey_blocks.end(), storey.level_blocks.begin(),
                                storey.level_blocks.end());
  }
  building.storeys.push_back(std::move(storey));
}

void require_fitting(const ParameterValues& values) {
  if (values("levels") > values("courses"))
    throw LayoutError("levels", "at most the number of courses, " + print_number(values("courses")),
                      print_number(values("levels")));
  const double most = 0.5 * values("brick_length");
  if (values("head_joint") > most)
    throw LayoutError("head_joint", "at most half a brick length, " + print_value(most, length),
                      print_value(values("head_joint"), length));
}

Building generate(const ParameterValues& values) {
  require_fitting(values);
  const double pitch = values("brick_length") + values("head_joint");
  const double half_wall = 0.5 * (values("bricks_per_course") * pitch - values("head_joint"));
  require_on_ground(values, -half_wall, half_wall);
  Building building = on_ground(masonry().name, values);
  for (std::size_t level = 1; level <= values.count("levels"); ++level) add_level(building, values, level);
  return building;
}

}  // namespace

Layout brick_wall() {
  Layout layout;
  layout.name = "brick-wall";
  layout.summary = "a masonry wall of dry bricks in running bond";
  layout.counting =
      "The courses are dealt out to the levels from the bottom, as evenly as they divide. A storey is the "
      "courses "
      "of one level, its level blocks are the bricks of its top course and its height is that of its "
      "courses.";
  layout.parameters = joined(
      {
          {"courses", count, 8, 1, 400, "number of courses"},
          {"bricks_per_course", count, 12, 1, 400, "whole bricks in the first, third ... course"},
          {"brick_length", length, 0.5, 0.01, 10, "length of a whole brick"},
          {"brick_height", length, 0.25, 0.01, 10, "height of a brick, joint included"},
          {"head_joint", length, 0.001, 0.0, 0.1, "open gap between the ends of neighbours in a course"},
          {"levels", count, 4, 1, 400, "storeys that the courses are dealt out to"},
          ground_width_parameter(12.0),
      },
      material_parameters(masonry()));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
