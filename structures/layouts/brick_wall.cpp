#include "structures/layouts/brick_wall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "structures/layouts/mortar.h"
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

/// A stretch of a course without a break: where its ends are at its bottom and at its top.
struct Stretch {
  double left, right;          // m, at the bottom
  double left_top, right_top;  // m
};

/// An opening or a lintel, which a course stops at.
struct Hole {
  double left, right;  // m
};

class Wall {
 public:
  explicit Wall(const ParameterValues& values)
      : values_(values),
        pitch_(values("brick_length") + values("head_joint")),
        half_width_(0.5 * (values("bricks_per_course") * pitch_ - values("head_joint"))),
        shortest_(0.25 * values("brick_length")) {}

  Building build() {
    require_fitting();
    require_on_ground(values_, -half_width_, half_width_);
    building_ = on_ground(masonry().name, values_);
    for (std::size_t level = 1; level <= values_.count("levels"); ++level) add_level(level);
    if (values_.count("gable_courses") > 0) add_gable();
    if (values_.is("joints", "mortar")) lay_in_mortar(building_, values_, values_("head_joint"));
    return std::move(building_);
  }

 private:
  double height() const { return values_("brick_height"); }
  double bottom_of(std::size_t course) const { return static_cast<double>(course - 1) * height(); }
  std::size_t first_course(std::size_t level) const {
    return (level - 1) * values_.count("courses") / values_.count("levels") + 1;
  }

  // --- openings ---------------------------------------------------------------------------------------

  std::vector<Hole> openings(double beyond = 0.0) const {
    const std::size_t n = values_.count("openings");
    std::vector<Hole> holes;
    for (std::size_t i = 0; i < n; ++i) {
      const double place = static_cast<double>(i) - 0.5 * static_cast<double>(n - 1);
      const double centre = values_("opening_centre") + place * values_("opening_spacing");
      const double half = 0.5 * values_("opening_width") + beyond;
      holes.push_back({centre - half, centre + half});
    }
    return holes;
  }

  bool has_openings(std::size_t level) const {
    return values_.count("openings") > 0 && level <= values_.count("opening_levels");
  }
  std::size_t lintel_course(std::size_t level) const {
    return first_course(level) + values_.count("sill_courses") + values_.count("opening_courses");
  }
  bool is_open(std::size_t level, std::size_t course) const {
    return has_openings(level) && course >= first_course(level) + values_.count("sill_courses") &&
           course < lintel_course(level);
  }
  bool has_lintels(std::size_t level, std::size_t course) const {
    return has_openings(level) && course == lintel_course(level);
  }

  std::vector<Stretch> stretches(const std::vector<Hole>& holes) const {
    std::vector<Stretch> rest;
    double from = -half_width_;
    const auto close = [&](double to) { rest.push_back({from, to, from, to}); };
    for (const Hole& hole : holes) {
      close(hole.left);
      from = hole.right;
    }
    close(half_width_);
    return rest;
  }

  // --- courses ----------------------------------------------------------------------------------------

  /// Middles of the head joints of a whole course.
  std::vector<double> joints(std::size_t course) const {
    const std::size_t n = values_.count("bricks_per_course");
    const bool even = course % 2 == 0;
    const auto at = [&](double bricks) { return (bricks - 0.5 * static_cast<double>(n)) * pitch_; };
    std::vector<double> places;
    if (even && values_.is("bond_pattern", "English")) {
      places.push_back(at(0.5));
      for (std::size_t q = 3; q + 2 < 4 * n; q += 2) places.push_back(at(0.25 * static_cast<double>(q)));
      places.push_back(at(static_cast<double>(n) - 0.5));
      return places;
    }
    const bool shifted = even && values_.is("bond_pattern", "running");
    for (std::size_t k = 1; k < n + shifted; ++k)
      places.push_back(at(static_cast<double>(k) - 0.5 * shifted));
    return places;
  }

  void add_stretch(std::size_t course, const Stretch& s, std::vector<std::size_t>& bricks) {
    const double half_joint = 0.5 * values_("head_joint");
    const double left = std::max(s.left, s.left_top), right = std::min(s.right, s.right_top);
    double from = s.left, from_top = s.left_top;
    const auto add = [&](double to, double to_top) {
      const double y = bottom_of(course), top = bottom_of(course + 1);
      bricks.push_back(add_outline(building_, values_,
                                   fmt::format("C{:02}.B{:02}", course, bricks.size() + 1),
                                   {{from, y}, {to, y}, {to_top, top}, {from_top, top}}));
    };
    for (const double joint : joints(course)) {
      if (joint - left < shortest_ || right - joint < shortest_) continue;
      add(joint - half_joint, joint - half_joint);
      from = from_top = joint + half_joint;
    }
    add(s.right, s.right_top);
  }

  std::vector<std::size_t> add_course(std::size_t level, std::size_t course) {
    std::vector<Hole> holes;
    if (is_open(level, course)) holes = openings();
    if (has_lintels(level, course)) holes = openings(values_("lintel_bearing"));
    std::vector<std::size_t> bricks;
    const double gap = has_lintels(level, course) ? values_("head_joint") : 0.0;
    for (Stretch& s : stretches(holes)) {
      // A lintel's ends have head joints, the jambs of an opening none.
      if (s.left > -half_width_) s.left += gap, s.left_top += gap;
      if (s.right < half_width_) s.right -= gap, s.right_top -= gap;
      add_stretch(course, s, bricks);
    }
    if (has_lintels(level, course)) add_lintels(course, holes, bricks);
    return bricks;
  }

  void add_lintels(std::size_t course, const std::vector<Hole>& holes, std::vector<std::size_t>& bricks) {
    for (std::size_t i = 0; i < holes.size(); ++i)
      bricks.push_back(add_rectangle(building_, values_, fmt::format("C{:02}.lintel{}", course, i + 1),
                                     0.5 * (holes[i].left + holes[i].right), bottom_of(course),
                                     holes[i].right - holes[i].left, height()));
  }

  /// The courses dealt out to the levels from the bottom; where they do not divide, upper levels get more.
  void add_level(std::size_t level) {
    const std::size_t first = first_course(level), last = first_course(level + 1) - 1;
    Storey storey;
    storey.name = fmt::format("S{}", level);
    storey.base = bottom_of(first);
    storey.height = static_cast<double>(last - first + 1) * height();
    for (std::size_t course = first; course <= last; ++course) {
      storey.level_blocks = add_course(level, course);
      storey.storey_blocks.insert(storey.storey_blocks.end(), storey.level_blocks.begin(),
                                  storey.level_blocks.end());
    }
    building_.storeys.push_back(std::move(storey));
  }

  void add_gable() {
    const std::size_t first = values_.count("courses") + 1, rows = values_.count("gable_courses");
    Storey storey{fmt::format("S{}", building_.storeys.size() + 1),
                  bottom_of(first),
                  static_cast<double>(rows) * height(),
                  {},
                  {}};
    const auto reach = [&](std::size_t row) {
      return half_width_ * static_cast<double>(rows - row) / static_cast<double>(rows);
    };
    for (std::size_t row = 0; row < rows; ++row) {
      std::vector<std::size_t> bricks;
      add_stretch(first + row, {-reach(row), reach(row), -reach(row + 1), reach(row + 1)}, bricks);
      storey.storey_blocks.insert(storey.storey_blocks.end(), bricks.begin(), bricks.end());
    }
    storey.level_blocks = storey.storey_blocks;
    building_.storeys.push_back(std::move(storey));
  }

  // --- what fits --------------------------------------------------------------------------------------

  void require_fitting() const {
    require(values_("levels") <= values_("courses"), values_, "levels",
            "at most the number of courses, " + print_number(values_("courses")), count);
    const double most = 0.5 * values_("brick_length");
    require(values_("head_joint") <= most, values_, "head_joint",
            "at most half a brick length, " + print_value(most, length));
    require(!values_.is("bond_pattern", "English") || values_("bricks_per_course") >= 2.0, values_,
            "bricks_per_course", "at least 2 in English bond", count);
    if (values_.is("joints", "mortar")) require_mortar(values_, values_("brick_height"));
    if (values_.count("openings") > 0) require_openings();
  }

  void require_openings() const {
    const std::size_t levels = values_.count("opening_levels");
    require(levels <= values_.count("levels"), values_, "opening_levels",
            "at most the number of levels, " + print_number(values_("levels")), count);
    for (std::size_t level = 1; level <= levels; ++level) {
      const std::size_t courses = first_course(level + 1) - first_course(level);
      const std::size_t needed = values_.count("sill_courses") + values_.count("opening_courses") + 1;
      require(needed <= courses, values_, "opening_courses",
              fmt::format("sill, opening and lintel in the {} courses of level {}", courses, level), count);
    }
    const double bearing = values_("lintel_bearing");
    require(bearing >= shortest_, values_, "lintel_bearing",
            "at least a quarter brick, " + print_value(shortest_, length));
    const double pier = 2.0 * (bearing + values_("head_joint")) + shortest_;
    const double least = values_("opening_width") + pier;
    require(values_.count("openings") < 2 || values_("opening_spacing") >= least, values_, "opening_spacing",
            "room for two bearings and a quarter brick between openings, " + print_value(least, length));
    const std::vector<Hole> holes = openings(bearing + values_("head_joint") + shortest_);
    require(holes.front().left >= -half_width_ && holes.back().right <= half_width_, values_, "opening_width",
            "openings, lintels and a quarter brick at either end within a wall of " +
                print_value(2.0 * half_width_, length));
  }

  const ParameterValues& values_;
  double pitch_, half_width_;
  double shortest_;  // m, piece of a brick
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Wall(values).build();
}

std::vector<Parameter> wall_parameters() {
  return {
      {"courses", count, 8, 1, 400, "number of courses"},
      {"bricks_per_course", count, 12, 1, 400, "whole bricks in the first, third ... course"},
      {"brick_length", length, 0.5, 0.01, 10, "length of a whole brick"},
      {"brick_height", length, 0.25, 0.01, 10, "height of a brick, joint included"},
      {"head_joint", length, 0.001, 0.0, 0.1, "open gap between the ends of neighbours in a course"},
      {"levels", count, 4, 1, 400, "storeys that the courses are dealt out to"},
      choice("bond_pattern", {"running", "stack", "English"}, "how the head joints of the courses lie"),
      choice("joints", {"dry", "mortar"}, "laid dry, or in mortar that may break"),
      {"openings", count, 0, 0, 50, "doors or windows side by side in a level"},
      {"opening_levels", count, 1, 1, 400, "levels that have them, from the lowest"},
      {"opening_width", length, 1.0, 0.01, 100, "width of an opening"},
      {"opening_courses", count, 4, 1, 400, "height of an opening, in courses; the lintel is the next one"},
      {"sill_courses", count, 0, 0, 400, "courses of the level below an opening; 0: a door"},
      {"opening_centre", length, 0.0, -1e3, 1e3, "middle of the row of openings"},
      {"opening_spacing", length, 3.0, 0.01, 1e3, "distance between the middles of neighbouring openings"},
      {"lintel_bearing", length, 0.25, 0.01, 10, "length of a lintel on the wall at either end"},
      {"gable_courses", count, 0, 0, 400, "courses of a gable on top, which end in a point; 0: none"},
  };
}

}  // namespace

Layout brick_wall() {
  Layout layout;
  layout.name = "brick-wall";
  layout.summary = "a masonry wall of bricks, dry or in mortar, with openings and a gable";
  layout.structural_type = "masonry";
  layout.counting =
      "The courses are dealt out to the levels from the bottom, as evenly as they divide. A storey is the "
      "courses of one level, its level blocks are the bricks of its top course and its height is that of its "
      "courses. A gable is one more storey, and all of it is its level.";
  layout.parameters = joined(joined(wall_parameters(), mortar_parameters()),
                             joined({ground_width_parameter(12.0)}, material_parameters(masonry())));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
