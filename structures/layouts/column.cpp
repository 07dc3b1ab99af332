#include "structures/layouts/column.h"

#include <fmt/format.h>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

engine::Material stone() {
  engine::Material material;
  material.name = "stone";
  material.density = 2600.0;
  material.young_modulus = 40e9;
  material.friction_coefficient = 0.7;
  return material;
}

void add_drum(Building& building, const ParameterValues& values, std::size_t number) {
  const double drums = values("drums"), height = values("drum_height");
  const double bottom = static_cast<double>(number - 1) * height, top = static_cast<double>(number) * height;
  const auto half_width = [&](double y) {
    return 0.5 * values("width") * (1.0 - values("taper_ratio") * y / (drums * height));
  };
  const double foot = half_width(bottom), head = half_width(top);
  const std::size_t drum = add_outline(building, values, fmt::format("S{}.drum", number),
                                       {{-foot, bottom}, {foot, bottom}, {head, top}, {-head, top}});
  building.storeys.push_back({fmt::format("S{}", number), bottom, height, {drum}, {drum}});
}

Building generate(const ParameterValues& values) {
  require_on_ground(values, -0.5 * values("width"), 0.5 * values("width"));
  Building building = on_ground(stone().name, values);
  for (std::size_t number = 1; number <= values.count("drums"); ++number) add_drum(building, values, number);
  return building;
}

}  // namespace

Layout column() {
  Layout layout;
  layout.name = "column";
  layout.summary = "a column of stone drums, laid dry";
  layout.counting = "Every drum is a storey and its own level; the storey height is the drum height.";
  layout.parameters = joined(
      {
          {"drums", count, 6, 1, 200, "number of drums"},
          {"width", length, 1.0, 0.01, 20, "width at the foot"},
          {"drum_height", length, 1.0, 0.01, 50, "height of a drum"},
          {"taper_ratio", ratio, 0.0, 0.0, 0.9, "part of the width that is lost from the foot to the top"},
          ground_width_parameter(10.0),
      },
      material_parameters(stone()));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
