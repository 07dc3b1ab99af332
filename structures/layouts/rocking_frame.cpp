#include "structures/layouts/rocking_frame.h"

#include <fmt/format.h>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

double axis(const ParameterValues& values, std::size_t column) {
  return (static_cast<double>(column) - 0.5 * (values("columns") - 1.0)) * values("column_spacing");
}

void require_fitting(const ParameterValues& values) {
  require(values("column_spacing") > values("column_width"), values, "column_spacing",
          "more than the column width, " + print_value(values("column_width"), length));
  const double half = axis(values, values.count("columns") - 1) + 0.5 * values("column_width");
  require_on_ground(values, -half, half);
}

/// Stretched from the length at which it bears nothing by P/k.
void add_tendon(Building& building, const ParameterValues& values, std::size_t column, std::size_t beam) {
  const double x = axis(values, column), top = building.scene.bodies[beam].position.y;
  engine::Joint tendon = joint_at(building, fmt::format("tendon{}", column + 1), engine::JointKind::spring,
                                  ground(), block(beam), {x, 0.0}, {x, top}, values("tendon_stiffness"));
  tendon.rest_length = top - values("tendon_force") / values("tendon_stiffness");
  if (*tendon.rest_length < 0.0)
    throw LayoutError("tendon_force",
                      "at most what stretches a tendon to its length, " +
                          print_value(top * values("tendon_stiffness"), force),
                      print_value(values("tendon_force"), force));
  building.scene.joints.push_back(std::move(tendon));
}

Building generate(const ParameterValues& values) {
  require_fitting(values);
  Building building = on_ground("concrete", values);
  const std::size_t columns = values.count("columns");
  const double height = values("column_height"), depth = values("beam_depth");
  Storey storey{"S1", 0.0, height + depth, {}, {}};
  for (std::size_t i = 0; i < columns; ++i)
    storey.storey_blocks.push_back(add_rectangle(building, values, fmt::format("column{}", i + 1),
                                                 axis(values, i), 0.0, values("column_width"), height));
  const double half = axis(values, columns - 1) + 0.5 * values("column_width") + values("beam_overhang");
  const std::size_t beam = add_rectangle(building, values, "beam", 0.0, height, 2.0 * half, depth);
  building.scene.bodies[beam].mass = mass_of(building, beam) + values("deck_mass");
  storey.level_blocks = {beam};
  storey.storey_blocks.push_back(beam);
  if (values.is("tendons", "one-a-column"))
    for (std::size_t i = 0; i < columns; ++i) add_tendon(building, values, i, beam);
  building.storeys.push_back(std::move(storey));
  return building;
}

}  // namespace

Layout rocking_frame() {
  Layout layout;
  layout.name = "rocking-frame";
  layout.summary = "free-standing columns under a rigid beam, dry or with tendons";
  layout.counting = "The whole frame is one storey; its level is the beam.";
  layout.parameters = joined(
      {
          {"columns", count, 3, 1, 60, "number of columns"},
          {"column_spacing", length, 6.0, 0.02, 200, "distance between the columns' axes"},
          {"column_width", length, 1.2, 0.01, 20, "of the columns"},
          {"column_height", length, 7.2, 0.05, 100, "of the columns"},
          {"beam_depth", length, 1.2, 0.01, 20, "height of the beam"},
          {"beam_overhang", length, 0.8, 0.0, 50, "of the beam beyond the outer columns"},
          {"deck_mass", mass, 60e3, 0.0, 1e9, "that the beam carries and that moves with it"},
          choice("tendons", {"none", "one-a-column"}, "that press the beam on the columns"),
          {"tendon_force", force, 300e3, 0.0, 1e9, "in each tendon at the start"},
          {"tendon_stiffness", stiffness, 1e7, 1.0, 1e12, "of each tendon, E A over its length"},
          ground_width_parameter(20.0),
      },
      material_parameters(engine::Material{}));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
