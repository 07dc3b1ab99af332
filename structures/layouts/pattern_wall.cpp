#include "structures/layouts/pattern_wall.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/mortar.h"
#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

constexpr std::size_t most_blocks = 20000;

// The blocks of the walls of Ferris and Tin-Loi, Int. J. Mech. Sci. 43 (2001) 209-224, of masonry whose
// joints are part of its modulus. A corner lands without rebound.
engine::Material masonry() {
  engine::Material material;
  material.name = "masonry";
  material.density = 2400.0;
  material.young_modulus = 1e9;
  material.damping_ratio = 1.0;
  material.friction_coefficient = 0.65;
  return material;
}

/// A block on the grid of half blocks.
struct Unit {
  std::size_t from = 0, to = 0;
};

struct Course {
  std::vector<Unit> units;
  std::size_t length = 0;  // in half blocks, openings included
};

class Pattern {
 public:
  explicit Pattern(const std::string& text) : text_(text) {}

  std::vector<Course> courses() const {
    std::vector<Course> read;
    for (std::size_t from = 0; from <= text_.size();) {
      const std::size_t comma = std::min(text_.find(',', from), text_.size());
      read.push_back(course(read.size() + 1, text_.substr(from, comma - from)));
      require_length(read);
      from = comma + 1;
    }
    return read;
  }

  [[noreturn]] static void refuse(const std::string& expected, const std::string& found) {
    throw LayoutError("pattern", expected, found);
  }

 private:
  static Course course(std::size_t number, const std::string& letters) {
    Course read;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const char letter = letters[i];
      if (letter == ' ') continue;
      if (letter != '1' && letter != 'h' && letter != '_')
        refuse("1 (a block), h (half a block) or _ (an opening), with commas between courses",
               fmt::format("something else at place {} of course {}, \"{}\"",
                           i + 1 - letters.find_first_not_of(' '), number, trimmed(letters)));
      const std::size_t end = read.length + (letter == 'h' ? 1 : 2);
      if (letter != '_') read.units.push_back({read.length, end});
      read.length = end;
    }
    if (read.units.empty())
      refuse("a block in every course", fmt::format("\"{}\" as course {}", trimmed(letters), number));
    return read;
  }

  static std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
  }

  static std::string in_blocks(const Course& course) {
    return print_number(0.5 * static_cast<double>(course.length));
  }

  static void require_length(const std::vector<Course>& read) {
    if (read.back().length == read.front().length) return;
    refuse(fmt::format("courses as long as the first, {} blocks", in_blocks(read.front())),
           fmt::format("{} blocks in course {}", in_blocks(read.back()), read.size()));
  }

  const std::string& text_;
};

/// Every block stands on a part of another: nothing else holds it up.
void require_bearing(const std::vector<Course>& courses) {
  for (std::size_t row = 1; row < courses.size(); ++row)
    for (const Unit& unit : courses[row].units)
      if (std::ranges::none_of(courses[row - 1].units, [&](const Unit& below) {
            return below.from < unit.to && unit.from < below.to;
          }))
        Pattern::refuse("a block below every block",
                        fmt::format("an opening below the block from {} to {} of course {}",
                                    print_number(0.5 * static_cast<double>(unit.from)),
                                    print_number(0.5 * static_cast<double>(unit.to)), row + 1));
}

std::vector<Course> courses_of(const ParameterValues& values) {
  const std::vector<Course> once = Pattern(values.word("pattern")).courses();
  std::vector<Course> all;
  for (std::size_t i = 0; i < values.count("repeats"); ++i) all.insert(all.end(), once.begin(), once.end());
  require_bearing(all);
  std::size_t blocks = 0;
  for (const Course& course : all) blocks += course.units.size();
  require(blocks <= most_blocks, values, "repeats", fmt::format("at most {} blocks", most_blocks), count);
  return all;
}

class Wall {
 public:
  explicit Wall(const ParameterValues& values)
      : values_(values),
        courses_(courses_of(values)),
        half_pitch_(0.5 * (values("block_length") + values("head_joint"))) {}

  Building build() {
    require_fitting();
    building_ = on_ground(masonry().name, values_);
    for (std::size_t level = 1; level <= values_.count("levels"); ++level) add_level(level);
    if (values_.is("joints", "mortar")) lay_in_mortar(building_, values_, values_("head_joint"));
    return std::move(building_);
  }

 private:
  double left_of(std::size_t place) const {
    return (static_cast<double>(place) - 0.5 * static_cast<double>(courses_.front().length)) * half_pitch_;
  }

  void require_fitting() const {
    const double edge = std::abs(left_of(0)), most = 0.25 * values_("block_length");
    require_on_ground(values_, -edge, edge);
    require(values_.count("levels") <= courses_.size(), values_, "levels",
            fmt::format("at most the number of courses, {}", courses_.size()), count);
    require(values_("head_joint") <= most, values_, "head_joint",
            "at most a quarter of a block, " + print_value(most, length));
    if (values_.is("joints", "mortar")) require_mortar(values_, values_("block_height"));
  }

  std::vector<std::size_t> add_course(std::size_t row) {
    const double height = values_("block_height");
    std::vector<std::size_t> blocks;
    for (const Unit& unit : courses_[row].units) {
      const double from = left_of(unit.from), to = left_of(unit.to);
      blocks.push_back(add_rectangle(
          building_, values_, fmt::format("C{:02}.B{:02}", row + 1, blocks.size() + 1), 0.5 * (from + to),
          static_cast<double>(row) * height, to - from - values_("head_joint"), height));
    }
    return blocks;
  }

  /// The courses dealt out to the levels from the bottom; where they do not divide, upper levels get more.
  void add_level(std::size_t level) {
    const std::size_t levels = values_.count("levels");
    const std::size_t first = (level - 1) * courses_.size() / levels, last = level * courses_.size() / levels;
    const double height = values_("block_height");
    Storey storey{fmt::format("S{}", level),
                  static_cast<double>(first) * height,
                  static_cast<double>(last - first) * height,
                  {},
                  {}};
    for (std::size_t row = first; row < last; ++row) {
      storey.level_blocks = add_course(row);
      storey.storey_blocks.insert(storey.storey_blocks.end(), storey.level_blocks.begin(),
                                  storey.level_blocks.end());
    }
    building_.storeys.push_back(std::move(storey));
  }

  const ParameterValues& values_;
  std::vector<Course> courses_;
  double half_pitch_;  // m
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Wall(values).build();
}

std::vector<Parameter> wall_parameters() {
  return {
      text("pattern", "h1111h, 11111",
           "courses from below: 1 a block, h half a block, _ an opening as long as a block"),
      {"repeats", count, 3, 1, 400, "how often the pattern is laid, one on the other"},
      {"block_length", length, 0.4, 0.01, 10, "length of a whole block"},
      {"block_height", length, 0.175, 0.01, 10, "height of a block, joint included"},
      {"head_joint", length, 0.0, 0.0, 0.1, "open gap between the ends of neighbours in a course"},
      {"levels", count, 2, 1, 400, "storeys that the courses are dealt out to"},
      choice("joints", {"dry", "mortar"}, "laid dry, or in mortar that may break"),
  };
}

}  // namespace

Layout pattern_wall() {
  Layout layout;
  layout.name = "pattern-wall";
  layout.summary = "a masonry wall whose courses are written block by block";
  layout.structural_type = "masonry";
  layout.counting =
      "The courses are dealt out to the levels from the bottom, as evenly as they divide. A storey is the "
      "courses of one level, its level blocks are the blocks of its top course and its height is that of its "
      "courses.";
  layout.parameters = joined(joined(wall_parameters(), mortar_parameters()),
                             joined({ground_width_parameter(10.0)}, material_parameters(masonry())));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
