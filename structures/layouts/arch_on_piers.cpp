#include "structures/layouts/arch_on_piers.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

class Bridge {
 public:
  explicit Bridge(const ParameterValues& values)
      : values_(values),
        inner_(values("radius") - 0.5 * values("ring_thickness")),
        outer_(values("radius") + 0.5 * values("ring_thickness")),
        face_(outer_ + values("pier_projection")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("stone", values_);
    add_supports();
    add_arch();
    return std::move(building_);
  }

 private:
  void add_supports() {
    const std::size_t courses = values_.count("pier_courses");
    const double height = values_("pier_height");
    Storey storey{"S1", 0.0, height, {}, {}};
    for (const double side : {-1.0, 1.0}) {
      const char* name = side < 0.0 ? "left" : "right";
      for (std::size_t i = 0; i < courses; ++i) {
        const auto y = [&](std::size_t k) {
          return height * static_cast<double>(k) / static_cast<double>(courses);
        };
        const std::size_t stone =
            add_between(fmt::format("pier.{}.{}", name, i + 1), side, face_ - values_("pier_width"), face_,
                        face_ - values_("pier_width"), face_, y(i), y(i + 1));
        storey.storey_blocks.push_back(stone);
        if (i + 1 == courses) storey.level_blocks.push_back(stone);
      }
      if (values_("buttress_height") > 0.0) add_buttress(name, side, storey.storey_blocks);
    }
    building_.storeys.push_back(std::move(storey));
  }

  void add_buttress(const char* name, double side, std::vector<std::size_t>& blocks) {
    const std::size_t courses = values_.count("buttress_courses");
    const double height = values_("buttress_height"), foot = values_("buttress_width"),
                 head = values_("buttress_head");
    for (std::size_t i = 0; i < courses; ++i) {
      const auto part = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(courses); };
      const auto reach = [&](std::size_t k) { return face_ + foot + (head - foot) * part(k); };
      blocks.push_back(add_between(fmt::format("buttress.{}.{}", name, i + 1), side, face_, reach(i), face_,
                                   reach(i + 1), height * part(i), height * part(i + 1)));
    }
  }

  /// A trapezium between two distances from the middle, at its foot and at its head.
  std::size_t add_between(const std::string& name, double side, double near_foot, double far_foot,
                          double near_head, double far_head, double bottom, double top) {
    return add_outline(building_, values_, name,
                       {{side * near_foot, bottom},
                        {side * far_foot, bottom},
                        {side * far_head, top},
                        {side * near_head, top}});
  }

  void add_arch() {
    const std::size_t voussoirs = values_.count("voussoirs");
    Storey storey{"S2", values_("pier_height"), 0.0, {}, {}};
    for (std::size_t j = 0; j < voussoirs; ++j) {
      const Vec2 before = direction(j), after = direction(j + 1), centre{0.0, values_("pier_height")};
      const std::size_t stone = add_outline(building_, values_, fmt::format("V{:02}", j + 1),
                                            {centre + outer_ * before, centre + inner_ * before,
                                             centre + inner_ * after, centre + outer_ * after});
      storey.storey_blocks.push_back(stone);
      if (j >= (voussoirs - 1) / 2 && j <= voussoirs / 2) storey.level_blocks.push_back(stone);
    }
    storey.height = bounds_of(building_, storey.storey_blocks).high.y - storey.base;
    building_.storeys.push_back(std::move(storey));
  }

  /// Of joint j, from the left; mirrored to the bit, and level at the springings.
  Vec2 direction(std::size_t j) const {
    const std::size_t voussoirs = values_.count("voussoirs");
    if (j == 0) return {-1.0, 0.0};
    if (2 * j > voussoirs) {
      const Vec2 twin = direction(voussoirs - j);
      return {-twin.x, twin.y};
    }
    const double from_crown =
        std::numbers::pi * (0.5 - static_cast<double>(j) / static_cast<double>(voussoirs));
    return {-std::sin(from_crown), std::cos(from_crown)};
  }

  void require_fitting() const {
    require(values_("ring_thickness") <= values_("radius"), values_, "ring_thickness",
            "at most the radius, " + print_value(values_("radius"), length));
    const double least = values_("pier_projection") + values_("ring_thickness");
    require(values_("pier_width") >= least * (1.0 - 1e-9), values_, "pier_width",
            "at least the ring's thickness and the pier's projection, " + print_value(least, length));
    require(values_("pier_width") < face_, values_, "pier_width",
            "less than half the distance of the piers' outer faces, " + print_value(face_, length));
    require(values_("buttress_height") <= values_("pier_height"), values_, "buttress_height",
            "at most the height of the piers, " + print_value(values_("pier_height"), length));
    require(values_("buttress_head") <= values_("buttress_width"), values_, "buttress_head",
            "at most the width at its foot, " + print_value(values_("buttress_width"), length));
    const double half = face_ + (values_("buttress_height") > 0.0 ? values_("buttress_width") : 0.0);
    require_on_ground(values_, -half, half);
  }

  const ParameterValues& values_;
  double inner_, outer_;  // m, radii
  double face_;           // m, from the middle to a pier's outer face
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Bridge(values).build();
}

engine::Material stone() {
  engine::Material material = preset("stone");
  material.density = 2400.0;
  material.young_modulus = 20e9;
  material.friction_coefficient = 0.7;
  return material;
}

}  // namespace

Layout arch_on_piers() {
  Layout layout;
  layout.name = "arch-on-piers";
  layout.summary = "a semicircular arch on two piers, with or without buttresses, laid dry";
  layout.counting =
      "S1 is the piers and buttresses, and its level the top courses of the piers; S2 the arch, and its "
      "level "
      "the voussoir at the crown, or the two that meet there.";
  layout.parameters = joined(
      {
          {"voussoirs", count, 16, 3, 400, "number of voussoirs"},
          {"radius", length, 2.0, 0.05, 200, "radius of the centre line"},
          {"ring_thickness", length, 0.4, 0.005, 50, "thickness of the ring, from intrados to extrados"},
          {"pier_height", length, 3.0, 0.05, 200, "from the ground to the springings"},
          {"pier_width", length, 1.2, 0.01, 100, "of the piers"},
          {"pier_projection", length, 0.0, 0.0, 100, "of the piers beyond the extrados"},
          {"pier_courses", count, 6, 1, 400, "courses of a pier"},
          {"buttress_height", length, 0.0, 0.0, 200, "of a buttress outside each pier; 0: none"},
          {"buttress_width", length, 1.0, 0.01, 100, "of a buttress at its foot"},
          {"buttress_head", length, 0.4, 0.01, 100, "of a buttress at its top"},
          {"buttress_courses", count, 4, 1, 400, "courses of a buttress"},
          ground_width_parameter(12.0),
      },
      material_parameters(stone()));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
