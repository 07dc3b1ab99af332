#include "structures/layouts/masonry_house.h"

#include <fmt/format.h>

#include "structures/layouts/mortar.h"
#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

constexpr double joist_gap = 0.001;  // m, between a joist's end and the wall beside it

class House {
 public:
  explicit House(const ParameterValues& values)
      : values_(values), half_(0.5 * values("width")), wall_(values("wall_thickness")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("masonry", values_);
    floor_material_ = add_material(building_, preset(timber() ? "timber" : "concrete"));
    for (std::size_t storey = 1; storey <= values_.count("storeys"); ++storey) add_storey(storey);
    if (values_.is("joints", "mortar")) connect_touching(building_, stones_, mortar_of(values_));
    add_roof();
    return std::move(building_);
  }

 private:
  bool timber() const { return values_.is("floors", "timber"); }
  double storey_height() const { return values_("storey_height"); }
  double floor_depth() const { return values_("floor_depth"); }

  std::size_t add_stone(const std::string& name, double side, double thickness, double bottom,
                        double height) {
    stones_.push_back(
        add_rectangle(building_, values_, name, side * (half_ - 0.5 * thickness), bottom, thickness, height));
    return stones_.back();
  }

  void add_storey(std::size_t number) {
    const double base = static_cast<double>(number - 1) * storey_height(),
                 seat = base + storey_height() - floor_depth();
    const std::size_t courses = values_.count("courses");
    Storey storey{fmt::format("S{}", number), base, storey_height(), {}, {}};
    std::vector<std::size_t> heads;
    for (const double side : {-1.0, 1.0}) {
      const char* name = side < 0.0 ? "left" : "right";
      for (std::size_t i = 0; i < courses; ++i) {
        const auto y = [&](std::size_t k) {
          return base + (seat - base) * static_cast<double>(k) / static_cast<double>(courses);
        };
        storey.storey_blocks.push_back(
            add_stone(fmt::format("{}.{}.{}", storey.name, name, i + 1), side, wall_, y(i), y(i + 1) - y(i)));
      }
      heads.push_back(storey.storey_blocks.back());
      if (timber())
        storey.storey_blocks.push_back(add_stone(fmt::format("{}.{}.beside", storey.name, name), side,
                                                 wall_ - values_("bearing") - joist_gap, seat,
                                                 floor_depth()));
    }
    const std::size_t floor = add_floor(storey.name, seat);
    storey.level_blocks = {floor};
    storey.storey_blocks.push_back(floor);
    add_ties(storey.name, floor, heads);
    building_.storeys.push_back(std::move(storey));
  }

  /// With the weight of what lies on it.
  std::size_t add_floor(const std::string& storey, double bottom) {
    const double half = timber() ? half_ - wall_ + values_("bearing") : half_;
    const std::size_t floor = add_rectangle(building_, {floor_material_, values_("thickness")},
                                            storey + ".floor", 0.0, bottom, 2.0 * half, floor_depth());
    building_.scene.bodies[floor].mass =
        values_("floor_load") * 2.0 * half * values_("thickness") / engine::standard_gravity;
    return floor;
  }

  void add_ties(const std::string& name, std::size_t floor, const std::vector<std::size_t>& heads) {
    if (!values_.is("ties", "every-floor")) return;
    const Vec2 middle = building_.scene.bodies[floor].position;
    for (const std::size_t head : heads) {
      const Vec2 wall = building_.scene.bodies[head].position;
      const double side = wall.x < 0.0 ? -1.0 : 1.0;
      building_.scene.joints.push_back(
          joint_at(building_, fmt::format("{}.tie.{}", name, side < 0.0 ? "left" : "right"),
                   engine::JointKind::distance, block(floor), block(head),
                   {wall.x - side * values_("tie_length"), middle.y}, wall, values_("tie_stiffness")));
    }
  }

  void add_roof() {
    const double base = values_("storeys") * storey_height(), height = values_("roof_height"),
                 eave = half_ + values_("eave_overhang"), lip = base + 0.1 * height;
    const std::size_t roof =
        add_outline(building_, {add_material(building_, preset("timber")), values_("thickness")}, "roof",
                    {{-half_, base}, {half_, base}, {eave, lip}, {0.0, base + height}, {-eave, lip}});
    building_.scene.bodies[roof].mass =
        values_("roof_load") * 2.0 * eave * values_("thickness") / engine::standard_gravity;
    building_.storeys.push_back(
        {fmt::format("S{}", building_.storeys.size() + 1), base, height, {roof}, {roof}});
    if (values_.is("ties", "every-floor")) tie_roof(roof);
  }

  void tie_roof(std::size_t roof) {
    const Storey& below = building_.storeys[building_.storeys.size() - 2];
    const double y = building_.scene.bodies[below.level_blocks.front()].position.y,
                 top = below.base + below.height;
    for (const double side : {-1.0, 1.0})
      building_.scene.joints.push_back(joint_at(
          building_, fmt::format("roof.tie.{}", side < 0.0 ? "left" : "right"), engine::JointKind::distance,
          block(roof), block(below.level_blocks.front()), {side * (half_ - wall_), top},
          {side * (half_ - wall_ - values_("tie_length")), y}, values_("tie_stiffness")));
  }

  void require_fitting() const {
    require(wall_ <= 0.4 * half_, values_, "wall_thickness",
            "at most a fifth of the width, " + print_value(0.4 * half_, length));
    require(floor_depth() <= 0.5 * storey_height(), values_, "floor_depth",
            "at most half the storey height, " + print_value(0.5 * storey_height(), length));
    const double most = wall_ - 0.05;
    require(!timber() || values_("bearing") <= most, values_, "bearing",
            "to leave 5 cm of wall beside the joists, at most " + print_value(most, length));
    const double room = half_ - wall_;
    require(values_("tie_length") <= room, values_, "tie_length",
            "at most half the clear width, " + print_value(room, length));
    if (values_.is("joints", "mortar")) require_mortar(values_, storey_height() / values_("courses"));
    require_on_ground(values_, -half_, half_);
  }

  const ParameterValues& values_;
  double half_, wall_;  // m
  std::size_t floor_material_ = 0;
  std::vector<std::size_t> stones_;
  Building building_;
};

Building generate(const ParameterValues& values) {
  return House(values).build();
}

engine::Material rubble() {
  engine::Material material = preset("stone");
  material.density = 2000.0;
  material.young_modulus = 1.5e9;
  return material;
}

}  // namespace

Layout masonry_house() {
  Layout layout;
  layout.name = "masonry-house";
  layout.summary =
      "a masonry house in section: two walls, timber or concrete floors, a roof, with or without ties";
  layout.structural_type = "masonry";
  layout.counting =
      "A storey is its walls and the floor on them; its level is the floor, and its height is measured to "
      "the "
      "tops of the floors. The roof is one more storey and its own level.";
  layout.parameters = joined(
      joined(
          {
              {"storeys", count, 2, 1, 12, "number of storeys below the roof"},
              {"width", length, 6.0, 0.5, 100, "of the house, from outside to outside"},
              {"storey_height", length, 2.8, 0.2, 30, "from a floor to the next"},
              {"wall_thickness", length, 0.5, 0.02, 10, "of the walls, in the plane"},
              {"courses", count, 6, 1, 200, "courses of a wall in a storey, below the floor"},
              choice("joints", {"mortar", "dry"}, "of the walls"),
              choice("floors", {"timber", "concrete"}, "joists that bear in pockets, or slabs on the walls"),
              {"floor_depth", length, 0.2, 0.01, 5, "height of the joists or slabs"},
              {"bearing", length, 0.2, 0.01, 5, "of joists on a wall"},
              {"floor_load", pressure, 3e3, 1.0, 1e6,
               "weight of the floors, with what lies on them, per area"},
              {"roof_height", length, 2.0, 0.05, 50, "from the uppermost floor to the ridge"},
              {"eave_overhang", length, 0.5, 0.01, 20, "of the roof beyond the walls"},
              {"roof_load", pressure, 1.5e3, 1.0, 1e6, "weight of the roof, per area"},
              choice("ties", {"none", "every-floor"}, "that hold floors and roof to the walls"),
              {"tie_length", length, 1.0, 0.01, 50,
               "from a tie's end in the floor to that in the wall, level"},
              {"tie_stiffness", stiffness, 3e7, 1.0, 1e12, "of a tie, E A over its length"},
          },
          mortar_parameters()),
      joined({ground_width_parameter(10.0)}, material_parameters(rubble())));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
