#include "structures/layouts/arch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

constexpr double pi = std::numbers::pi;

engine::Material stone() {
  engine::Material material;
  material.name = "stone";
  material.density = 2400.0;
  material.young_modulus = 20e9;
  material.friction_coefficient = 0.7;
  return material;
}

/// A joint between two voussoirs, or a springing.
struct Joint {
  Vec2 inner, outer;
};

class Arch {
 public:
  explicit Arch(const ParameterValues& values)
      : inner_(values("radius") - 0.5 * values("ring_thickness")),
        outer_(values("radius") + 0.5 * values("ring_thickness")),
        embrace_(values("embrace_angle")),
        voussoirs_(values.count("voussoirs")),
        centre_y_(values("abutment_height") - inner_ * std::sin(0.5 * (pi - embrace_))) {}

  /// Number j of 0 .. voussoirs, from the left; mirrored about the crown to the bit.
  Joint joint(std::size_t j) const {
    if (2 * j > voussoirs_) {
      const Joint twin = joint(voussoirs_ - j);
      return {{-twin.inner.x, twin.inner.y}, {-twin.outer.x, twin.outer.y}};
    }
    const double from_crown =
        0.5 * embrace_ - embrace_ * static_cast<double>(j) / static_cast<double>(voussoirs_);
    const Vec2 direction{-std::sin(from_crown), std::cos(from_crown)};
    return {Vec2{0.0, centre_y_} + inner_ * direction, Vec2{0.0, centre_y_} + outer_ * direction};
  }
  double half_width() const { return std::abs(joint(0).outer.x); }
  double top() const { return joint(voussoirs_ / 2).outer.y; }

 private:
  double inner_, outer_, embrace_;
  std::size_t voussoirs_;
  double centre_y_;
};

void require_fitting(const ParameterValues& values, const Arch& arch) {
  if (values("ring_thickness") > values("radius"))
    throw LayoutError("ring_thickness", "at most the radius, " + print_value(values("radius"), length),
                      print_value(values("ring_thickness"), length));
  if (values("embrace_angle") < pi && values("abutment_height") == 0.0)
    throw LayoutError("abutment_height", "more than 0 m under springings that are inclined",
                      print_value(0.0, length));
  require_on_ground(values, -arch.half_width(), arch.half_width());
}

void add_abutment(Building& building, const std::string& name, const Joint& springing) {
  const Vec2 outline[] = {
      {springing.inner.x, 0.0}, {springing.outer.x, 0.0}, springing.outer, springing.inner};
  const engine::PlacedPolygon placed = engine::make_polygon(outline);
  engine::Terrain abutment;
  abutment.name = name;
  abutment.shape = placed.polygon;
  abutment.position = placed.centroid;
  building.scene.terrains.push_back(std::move(abutment));
}

/// All in one storey, whose level is the crown: one voussoir, or the two that meet there.
Storey storey_of(const Arch& arch, std::size_t voussoirs) {
  Storey storey{"S1", 0.0, arch.top(), {}, {}};
  for (std::size_t j = 0; j < voussoirs; ++j) storey.storey_blocks.push_back(j);
  for (std::size_t j = (voussoirs - 1) / 2; j <= voussoirs / 2; ++j) storey.level_blocks.push_back(j);
  return storey;
}

Building generate(const ParameterValues& values) {
  const Arch arch(values);
  require_fitting(values, arch);
  const std::size_t voussoirs = values.count("voussoirs");
  Building building = on_ground(stone().name, values);
  if (values("abutment_height") > 0.0) {
    add_abutment(building, "abutment.left", arch.joint(0));
    add_abutment(building, "abutment.right", arch.joint(voussoirs));
  }
  for (std::size_t j = 0; j < voussoirs; ++j) {
    const Joint before = arch.joint(j), after = arch.joint(j + 1);
    add_outline(building, values, fmt::format("V{:02}", j + 1),
                {before.outer, before.inner, after.inner, after.outer});
  }
  building.storeys.push_back(storey_of(arch, voussoirs));
  return building;
}

}  // namespace

Layout arch() {
  Layout layout;
  layout.name = "arch";
  layout.summary = "a circular arch of voussoirs between two abutments, laid dry";
  layout.counting =
      "The whole arch is one storey; its level is the voussoir at the crown, or the two that meet there.";
  layout.parameters = joined(
      {
          {"voussoirs", count, 15, 3, 400, "number of voussoirs"},
          {"radius", length, 3.0, 0.05, 200, "radius of the centre line"},
          {"ring_thickness", length, 0.5, 0.005, 50, "thickness of the ring, from intrados to extrados"},
          {"embrace_angle", angle, pi, pi / 36.0, pi, "angle between the two springing joints"},
          {"abutment_height", length, 0.5, 0.0, 100, "height of the intrados' ends above the ground"},
          ground_width_parameter(10.0),
      },
      material_parameters(stone()));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
