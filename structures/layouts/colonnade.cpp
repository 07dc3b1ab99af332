#include "structures/layouts/colonnade.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

constexpr double beam_joint = 0.001;  // m, between the ends of two beams

class Colonnade {
 public:
  explicit Colonnade(const ParameterValues& values)
      : values_(values), columns_(values.count("columns")), drums_(values.count("drums")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("stone", values_);
    for (std::size_t row = 1; row <= drums_; ++row) add_row(row);
    if (values_("capital_height") > 0.0) add_capitals();
    add_architrave();
    return std::move(building_);
  }

 private:
  double axis(std::size_t column) const {
    return (static_cast<double>(column) - 0.5 * static_cast<double>(columns_ - 1)) *
           values_("column_spacing");
  }
  double half_width(double y) const {
    const double shaft = static_cast<double>(drums_) * values_("drum_height");
    return 0.5 * values_("column_width") * (1.0 - values_("taper_ratio") * y / shaft);
  }
  double top() const { return building_.storeys.back().base + building_.storeys.back().height; }

  void add_storey(double base, double height, std::vector<std::size_t> blocks) {
    building_.storeys.push_back(
        {fmt::format("S{}", building_.storeys.size() + 1), base, height, blocks, blocks});
  }

  void add_row(std::size_t row) {
    const double bottom = static_cast<double>(row - 1) * values_("drum_height"),
                 upper = static_cast<double>(row) * values_("drum_height");
    std::vector<std::size_t> drums;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double x = axis(i), foot = half_width(bottom), head = half_width(upper);
      drums.push_back(
          add_outline(building_, values_, fmt::format("column{}.drum{}", i + 1, row),
                      {{x - foot, bottom}, {x + foot, bottom}, {x + head, upper}, {x - head, upper}}));
    }
    add_storey(bottom, values_("drum_height"), std::move(drums));
  }

  /// They widen from the shaft to a square slab.
  void add_capitals() {
    const double y = top(), height = values_("capital_height"), foot = half_width(y),
                 half = 0.5 * values_("capital_width"), waist = y + 0.6 * height;
    std::vector<std::size_t> capitals;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double x = axis(i);
      capitals.push_back(add_outline(building_, values_, fmt::format("column{}.capital", i + 1),
                                     {{x - foot, y},
                                      {x + foot, y},
                                      {x + half, waist},
                                      {x + half, y + height},
                                      {x - half, y + height},
                                      {x - half, waist}}));
    }
    add_storey(y, height, std::move(capitals));
  }

  void add_architrave() {
    const double y = top(), end = axis(columns_ - 1) + 0.5 * values_("column_width");
    std::vector<std::size_t> beams;
    for (std::size_t i = 0; i + 1 < columns_; ++i) {
      const double left = i == 0 ? -end : axis(i) + 0.5 * beam_joint;
      const double right = i + 2 == columns_ ? end : axis(i + 1) - 0.5 * beam_joint;
      beams.push_back(add_rectangle(building_, values_, fmt::format("beam{}", i + 1), 0.5 * (left + right), y,
                                    right - left, values_("architrave_depth")));
    }
    add_storey(y, values_("architrave_depth"), std::move(beams));
  }

  void require_fitting() const {
    const double widest = std::max(values_("column_width"), values_("capital_width"));
    require(values_("column_spacing") > widest, values_, "column_spacing",
            "more than the width of columns and capitals, " + print_value(widest, length));
    const double neck = 2.0 * half_width(static_cast<double>(drums_) * values_("drum_height"));
    require(values_("capital_height") == 0.0 || values_("capital_width") >= neck, values_, "capital_width",
            "at least the width of the shaft under it, " + print_value(neck, length));
    require_on_ground(values_, axis(0) - 0.5 * values_("column_width"),
                      axis(columns_ - 1) + 0.5 * values_("column_width"));
  }

  const ParameterValues& values_;
  std::size_t columns_, drums_;
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Colonnade(values).build();
}

engine::Material marble() {
  engine::Material stone = preset("stone");
  stone.friction_coefficient = 0.7;
  return stone;
}

}  // namespace

Layout colonnade() {
  Layout layout;
  layout.name = "colonnade";
  layout.summary = "stone columns of drums with capitals under an architrave, laid dry";
  layout.counting =
      "Every row of drums, the capitals and the architrave are a storey each, and all blocks of it its "
      "level.";
  layout.parameters = joined(
      {
          {"columns", count, 4, 2, 60, "number of columns"},
          {"drums", count, 5, 1, 60, "drums of a column"},
          {"column_spacing", length, 2.6, 0.02, 100, "distance between the columns' axes"},
          {"column_width", length, 1.0, 0.01, 20, "at the foot"},
          {"drum_height", length, 1.0, 0.01, 50, "of a drum"},
          {"taper_ratio", ratio, 0.2, 0.0, 0.9,
           "part of the width that is lost from the foot to the capital"},
          {"capital_width", length, 1.2, 0.01, 20, "of the capitals' upper faces"},
          {"capital_height", length, 0.5, 0.0, 20, "of the capitals; 0: none"},
          {"architrave_depth", length, 0.8, 0.01, 20, "height of the beams"},
          ground_width_parameter(14.0),
      },
      material_parameters(marble()));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
