#include "structures/layouts/slab_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

/// A column whose centre line misses the slab would not carry it; columns that meet leave no bay.
void require_fitting(const ParameterValues& values) {
  const double spacing = values("column_spacing");
  const double widths = 0.5 * (values("left_column_width") + values("right_column_width"));
  if (spacing <= widths)
    throw LayoutError("column_spacing",
                      "more than the half widths of both columns, " + print_value(widths, length),
                      print_value(spacing, length));
  if (values("slab_length") < spacing)
    throw LayoutError("slab_length", "at least the column spacing, " + print_value(spacing, length),
                      print_value(values("slab_length"), length));
}

void add_storey(Building& building, const ParameterValues& values, std::size_t number) {
  const double column_height = values("column_height"), slab_thickness = values("slab_thickness");
  const double half_spacing = 0.5 * values("column_spacing");
  Storey storey;
  storey.name = fmt::format("S{}", number);
  storey.height = column_height + slab_thickness;
  storey.base = static_cast<double>(number - 1) * storey.height;
  const auto column = [&](const char* side, double centre) {
    return add_rectangle(building, values, fmt::format("{}.column.{}", storey.name, side), centre,
                         storey.base, values(fmt::format("{}_column_width", side)), column_height);
  };
  const std::size_t left = column("left", -half_spacing), right = column("right", half_spacing);
  const std::size_t slab = add_rectangle(building, values, storey.name + ".slab", 0.0,
                                         storey.base + column_height, values("slab_length"), slab_thickness);
  storey.level_blocks = {slab};
  storey.storey_blocks = {left, right, slab};
  building.storeys.push_back(std::move(storey));
}

Building generate(const ParameterValues& values) {
  require_fitting(values);
  const double half_spacing = 0.5 * values("column_spacing");
  require_on_ground(values, -half_spacing - 0.5 * values("left_column_width"),
                    half_spacing + 0.5 * values("right_column_width"));
  Building building = on_ground("concrete", values);
  for (std::size_t number = 1; number <= values.count("storeys"); ++number)
    add_storey(building, values, number);
  return building;
}

Layout slab_frame(const std::string& name, const std::string& summary, double storeys,
                  double left_column_width) {
  Layout layout;
  layout.name = name;
  layout.summary = summary;
  layout.counting =
      "A storey is two columns and the slab on them; its level is the slab and its height the column height "
      "plus the slab thickness.";
  layout.parameters = joined(
      {
          {"storeys", count, storeys, 1, 100, "number of storeys"},
          {"left_column_width", length, left_column_width, 0.01, 10, "width of the left columns"},
          {"right_column_width", length, 0.3, 0.01, 10, "width of the right columns"},
          {"column_height", length, 2.6, 0.05, 50, "height of the columns"},
          {"column_spacing", length, 10.0, 0.1, 500, "distance between the columns' centre lines"},
          {"slab_length", length, 10.7, 0.1, 500, "length of the slabs, centred at x = 0"},
          {"slab_thickness", length, 0.2, 0.01, 10, "thickness of the slabs"},
          ground_width_parameter(18.0),
      },
      material_parameters(engine::Material{}));
  layout.generate = generate;
  return layout;
}

}  // namespace

Layout four_storey() {
  return slab_frame("four-storey", "four slabs, each on two slender columns, laid dry", 4, 0.3);
}
Layout four_storey_strong() {
  return slab_frame("four-storey-strong", "the four-storey building with left columns twice as wide", 4, 0.6);
}
Layout ten_storey() {
  return slab_frame("ten-storey", "ten slabs, each on two slender columns, laid dry", 10, 0.3);
}

}  // namespace dougong::structures
