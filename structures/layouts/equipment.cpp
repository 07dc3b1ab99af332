#include "structures/layouts/equipment.h"

#include <fmt/format.h>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

// Boxes end this much short of the uprights and of each other.
constexpr double clearance = 0.01;  // m

class Room {
 public:
  explicit Room(const ParameterValues& values)
      : values_(values), half_(0.5 * values("item_width")), floor_(values("floor_thickness")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("equipment", values_);
    if (floor_ > 0.0) add_floor();
    Storey storey{fmt::format("S{}", building_.storeys.size() + 1), floor_, 0.0, {}, {}};
    if (values_.is("item", "cabinet")) add_cabinet(storey);
    if (values_.is("item", "rack")) add_rack(storey);
    if (values_.is("item", "statue")) add_statue(storey);
    storey.height = bounds_of(building_, storey.storey_blocks).high.y - floor_;
    building_.storeys.push_back(std::move(storey));
    return std::move(building_);
  }

 private:
  void add_floor() {
    const std::size_t slab = add_rectangle(building_, {add_material(building_, preset("concrete")), 1.0},
                                           "floor", 0.0, 0.0, values_("floor_width"), floor_);
    building_.storeys.push_back({"S1", 0.0, floor_, {slab}, {slab}});
  }

  std::size_t add_box(const std::string& name, double x, double y, double width, double height, double mass) {
    const std::size_t box = add_rectangle(building_, values_, name, x, y, width, height);
    building_.scene.bodies[box].mass = mass;
    return box;
  }

  void add_cabinet(Storey& storey) {
    storey.storey_blocks = storey.level_blocks = {
        add_box("cabinet", 0.0, floor_, values_("item_width"), values_("item_height"), values_("item_mass"))};
  }

  // --- rack ---------------------------------------------------------------------------------------------

  /// Uprights of one bar in each storey of shelves, which meet the shelves' ends in welded nodes.
  void add_rack(Storey& storey) {
    const std::size_t shelves = values_.count("shelves");
    const double step = values_("item_height") / static_cast<double>(shelves), bar = values_("rack_member");
    std::vector<std::size_t> below;
    for (std::size_t s = 1; s <= shelves; ++s) {
      const double bottom = floor_ + static_cast<double>(s - 1) * step, top = bottom + step;
      const std::size_t shelf = add_rectangle(building_, values_, fmt::format("shelf{}", s), 0.0, top - bar,
                                              values_("item_width"), bar);
      std::vector<std::size_t> posts;
      for (const double side : {-1.0, 1.0})
        posts.push_back(add_rectangle(building_, values_,
                                      fmt::format("post{}.{}", s, side < 0.0 ? "left" : "right"),
                                      side * (half_ - 0.5 * bar), bottom, bar, step - bar));
      for (const std::size_t post : posts) {
        connect(building_, block(post), block(shelf), welded());
        if (!below.empty()) connect(building_, block(below.back()), block(post), welded());
      }
      if (s > 1) add_boxes(s, bottom, storey);
      below = {shelf};
      posts.push_back(shelf);
      storey.storey_blocks.insert(storey.storey_blocks.end(), posts.begin(), posts.end());
      storey.level_blocks = {shelf};
    }
    add_boxes(shelves + 1, floor_ + values_("item_height"), storey);
  }

  Connection welded() const {
    Connection c;
    c.law.damping_ratio = values_("bond_damping_ratio");
    return c;
  }

  void add_boxes(std::size_t shelf, double y, Storey& storey) {
    const std::size_t boxes = values_.count("boxes_per_shelf");
    if (boxes == 0) return;
    const double inside = values_("item_width") - 2.0 * values_("rack_member") - clearance;
    const double pitch = inside / static_cast<double>(boxes);
    const double step = values_("item_height") / values_("shelves") - values_("rack_member");
    const double mass = values_("item_mass") / (values_("shelves") * values_("boxes_per_shelf"));
    for (std::size_t i = 0; i < boxes; ++i) {
      const double x = (static_cast<double>(i) - 0.5 * static_cast<double>(boxes - 1)) * pitch;
      storey.storey_blocks.push_back(
          add_box(fmt::format("box{}.{}", shelf - 1, i + 1), x, y, pitch - clearance, 0.6 * step, mass));
    }
  }

  // --- statue -------------------------------------------------------------------------------------------

  void add_statue(Storey& storey) {
    const double pedestal = values_("pedestal_height"), height = values_("item_height"),
                 y = floor_ + pedestal;
    if (pedestal > 0.0)
      storey.storey_blocks.push_back(
          add_rectangle(building_, values_, "pedestal", 0.0, floor_, values_("pedestal_width"), pedestal));
    const double foot = half_, shoulder = 0.8 * half_, head = 0.3 * half_;
    const std::size_t statue = add_outline(building_, values_, "statue",
                                           {{-foot, y},
                                            {foot, y},
                                            {foot, y + 0.1 * height},
                                            {shoulder, y + 0.8 * height},
                                            {head, y + height},
                                            {-head, y + height},
                                            {-shoulder, y + 0.8 * height},
                                            {-foot, y + 0.1 * height}});
    building_.scene.bodies[statue].mass = values_("item_mass");
    storey.storey_blocks.push_back(statue);
    storey.level_blocks = {statue};
  }

  // --- what fits ----------------------------------------------------------------------------------------

  void require_fitting() const {
    if (values_.is("item", "rack")) require_rack();
    if (values_.is("item", "statue") && values_("pedestal_height") > 0.0)
      require(values_("pedestal_width") >= values_("item_width"), values_, "pedestal_width",
              "at least the statue's foot, " + print_value(values_("item_width"), length));
    const double widest = values_.is("item", "statue") && values_("pedestal_height") > 0.0
                              ? values_("pedestal_width")
                              : values_("item_width");
    require(floor_ == 0.0 || values_("floor_width") >= widest, values_, "floor_width",
            "at least what stands on it, " + print_value(widest, length));
    const double half = 0.5 * (floor_ > 0.0 ? values_("floor_width") : widest);
    require_on_ground(values_, -half, half);
  }

  void require_rack() const {
    const double bar = values_("rack_member"), most_wide = 0.25 * values_("item_width"),
                 most_high = 0.5 * values_("item_height") / values_("shelves");
    require(bar <= most_wide, values_, "rack_member",
            "at most a quarter of the rack's width, " + print_value(most_wide, length));
    require(bar <= most_high, values_, "rack_member",
            "at most half the distance of the shelves, " + print_value(most_high, length));
    const double room = 0.5 * (values_("item_width") - 2.0 * bar) / clearance - 1.0;
    require(values_("boxes_per_shelf") <= room, values_, "boxes_per_shelf",
            fmt::format("boxes of at least {} between the uprights", print_value(clearance, length)), count);
  }

  const ParameterValues& values_;
  double half_, floor_;  // m
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Room(values).build();
}

engine::Material casing() {
  engine::Material material = preset("stone");
  material.young_modulus = 5e9;
  material.friction_coefficient = 0.5;
  return material;
}

}  // namespace

Layout equipment() {
  Layout layout;
  layout.name = "equipment";
  layout.summary = "a cabinet, rack or statue that stands free on a floor";
  layout.counting =
      "The floor, if there is one, is S1. The item is the other storey; its level is the cabinet, the "
      "uppermost "
      "shelf or the statue, and its height that of all of it, with what lies on the shelves.";
  layout.parameters = joined(
      {
          choice("item", {"cabinet", "rack", "statue"}, "what stands on the floor"),
          {"item_width", length, 0.6, 0.01, 20, "of the item; of a statue at its foot"},
          {"item_height", length, 1.9, 0.02, 50, "of the item; of a statue without its pedestal"},
          {"item_mass", mass, 400, 0.01, 1e7, "of the cabinet, of the statue, or of all boxes in the rack"},
          {"shelves", count, 4, 1, 30, "of a rack, the uppermost at its top"},
          {"boxes_per_shelf", count, 2, 0, 20, "side by side on each shelf"},
          {"rack_member", length, 0.04, 0.001, 2, "depth of a rack's uprights and shelves"},
          {"bond_damping_ratio", ratio, 0.02, 0.0, 10.0, "local damping of a rack's welds"},
          {"pedestal_width", length, 0.8, 0.01, 20, "of a statue"},
          {"pedestal_height", length, 0.9, 0.0, 50, "of a statue; 0: none"},
          {"floor_width", length, 4.0, 0.01, 100, "of the slab it stands on"},
          {"floor_thickness", length, 0.2, 0.0, 10, "of the slab it stands on; 0: it stands on the ground"},
          ground_width_parameter(8.0),
      },
      material_parameters(casing(), 0.6));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
