#include "structures/layouts/dougong_hall.h"

#include <fmt/format.h>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

class Hall {
 public:
  explicit Hall(const ParameterValues& values)
      : values_(values), columns_(values.count("bays") + 1), tiers_(values.count("bracket_tiers")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("timber", values_);
    stone_ = add_material(building_, preset("stone"));
    bearing_ = add_bearing_timber(building_, values_);
    add_columns();
    add_brackets();
    add_roof();
    return std::move(building_);
  }

 private:
  double axis(std::size_t column) const {
    return (static_cast<double>(column) - 0.5 * static_cast<double>(columns_ - 1)) * values_("bay_width");
  }
  double head() const { return values_("base_height") + values_("column_height"); }
  double tier_height() const { return values_("arm_height") + values_("block_height"); }
  double plate_bottom() const {
    return head() + values_("cap_height") + static_cast<double>(tiers_) * tier_height();
  }
  double arm_length(std::size_t tier) const {
    return values_("arm_length") + 2.0 * static_cast<double>(tier - 1) * values_("arm_step");
  }
  double half_length() const { return axis(columns_ - 1) + 0.5 * arm_length(tiers_); }

  // --- columns ------------------------------------------------------------------------------------------

  void add_columns() {
    Storey storey{"S1", 0.0, head(), {}, {}};
    std::vector<std::size_t> shafts;
    for (std::size_t i = 0; i < columns_; ++i) {
      storey.storey_blocks.push_back(add_rectangle(building_, {stone_, values_("thickness")},
                                                   fmt::format("base{}", i + 1), axis(i), 0.0,
                                                   values_("base_width"), values_("base_height")));
      shafts.push_back(add_rectangle(building_, values_, fmt::format("column{}", i + 1), axis(i),
                                     values_("base_height"), values_("column_width"),
                                     values_("column_height")));
    }
    storey.level_blocks = shafts;
    for (std::size_t i = 0; i + 1 < columns_; ++i) storey.level_blocks.push_back(add_lintel(i, shafts));
    storey.storey_blocks.insert(storey.storey_blocks.end(), storey.level_blocks.begin(),
                                storey.level_blocks.end());
    building_.storeys.push_back(std::move(storey));
  }

  std::size_t add_lintel(std::size_t bay, const std::vector<std::size_t>& shafts) {
    const double depth = values_("lintel_depth"), clear = values_("bay_width") - values_("column_width");
    const std::size_t lintel = add_rectangle(building_, values_, fmt::format("lintel{}", bay + 1),
                                             0.5 * (axis(bay) + axis(bay + 1)), head() - depth, clear, depth);
    const double y = head() - 0.5 * depth;
    for (const std::size_t end : {bay, bay + 1}) {
      const double face = axis(end) + (end == bay ? 0.5 : -0.5) * values_("column_width");
      const bool turns_freely = values_("tenon_stiffness") == 0.0;
      engine::Joint tenon = joint_at(
          building_, fmt::format("tenon{}.{}", bay + 1, end == bay ? "left" : "right"),
          turns_freely ? engine::JointKind::pin : engine::JointKind::weld, block(shafts[end]), block(lintel),
          {face, y}, {face, y}, values_("young_modulus") * values_("thickness") * 0.1);
      tenon.rotational_stiffness = values_("tenon_stiffness");
      tenon.damping_ratio = values_("tenon_damping_ratio");
      building_.scene.joints.push_back(std::move(tenon));
    }
    return lintel;
  }

  // --- brackets -----------------------------------------------------------------------------------------

  void add_brackets() {
    Storey storey{"S2", head(), plate_bottom() + values_("plate_depth") - head(), {}, {}};
    for (std::size_t i = 0; i < columns_; ++i) add_set(i, storey.storey_blocks);
    storey.level_blocks = {add_rectangle(building_, {bearing_, values_("thickness")}, "plate", 0.0,
                                         plate_bottom(), 2.0 * half_length(), values_("plate_depth"))};
    storey.storey_blocks.push_back(storey.level_blocks.front());
    building_.storeys.push_back(std::move(storey));
  }

  void add_set(std::size_t column, std::vector<std::size_t>& blocks) {
    const std::string name = fmt::format("set{}", column + 1);
    double y = head();
    // Bearing blocks widen upwards from their feet over the lower half of their height.
    const auto add_block = [&](const std::string& part, double x, double width, double height) {
      const double foot = 0.375 * width, half = 0.5 * width, waist = y + 0.4 * height;
      blocks.push_back(add_outline(building_, {bearing_, values_("thickness")}, name + "." + part,
                                   {{x - foot, y},
                                    {x + foot, y},
                                    {x + half, waist},
                                    {x + half, y + height},
                                    {x - half, y + height},
                                    {x - half, waist}}));
    };
    add_block("cap", axis(column), values_("cap_width"), values_("cap_height"));
    y += values_("cap_height");
    for (std::size_t tier = 1; tier <= tiers_; ++tier) {
      blocks.push_back(add_arm(fmt::format("{}.arm{}", name, tier), axis(column), y, arm_length(tier)));
      y += values_("arm_height");
      const double reach = 0.5 * (arm_length(tier) - values_("block_width"));
      for (int place = -1; place <= 1; ++place)
        add_block(fmt::format("block{}{}", tier, "lmr"[place + 1]), axis(column) + place * reach,
                  values_("block_width"), values_("block_height"));
      y += values_("block_height");
    }
  }

  /// Its ends are cut away below, as arms are.
  std::size_t add_arm(const std::string& name, double x, double y, double length) {
    const double height = values_("arm_height"), half = 0.5 * length, foot = half - 0.6 * height;
    return add_outline(building_, {bearing_, values_("thickness")}, name,
                       {{x - foot, y},
                        {x + foot, y},
                        {x + half, y + 0.6 * height},
                        {x + half, y + height},
                        {x - half, y + height},
                        {x - half, y + 0.6 * height}});
  }

  // --- roof ---------------------------------------------------------------------------------------------

  void add_roof() {
    const double y = plate_bottom() + values_("plate_depth"), half = half_length(),
                 eave = values_("eave_overhang"), height = values_("roof_height");
    const std::size_t roof = add_outline(building_, values_, "roof",
                                         {{-half, y},
                                          {half, y},
                                          {half + eave, y + 0.15 * height},
                                          {0.5 * half, y + height},
                                          {-0.5 * half, y + height},
                                          {-half - eave, y + 0.15 * height}});
    building_.scene.bodies[roof].mass =
        values_("roof_load") * values_("roof_depth") * 2.0 * (half + eave) / engine::standard_gravity;
    building_.storeys.push_back({"S3", y, height, {roof}, {roof}});
  }

  void require_fitting() const {
    const double arm = arm_length(tiers_) + 0.01;
    require(values_("bay_width") >= arm, values_, "bay_width",
            "room for the longest arms of neighbouring sets, " + print_value(arm, length));
    const double least = 3.0 * values_("block_width") + 0.02;
    require(values_("arm_length") >= least, values_, "arm_length",
            "room for three bearing blocks, " + print_value(least, length));
    const double seat = 2.0 * values_("arm_height");
    require(values_("arm_length") >= seat, values_, "arm_length",
            "at least twice its height, " + print_value(seat, length));
    require(values_("base_width") >= values_("column_width"), values_, "base_width",
            "at least the column width, " + print_value(values_("column_width"), length));
    require(values_("lintel_depth") <= values_("column_height"), values_, "lintel_depth",
            "at most the column height, " + print_value(values_("column_height"), length));
    require_on_ground(values_, -axis(columns_ - 1) - 0.5 * values_("base_width"),
                      axis(columns_ - 1) + 0.5 * values_("base_width"));
  }

  const ParameterValues& values_;
  std::size_t columns_, tiers_;
  std::size_t stone_ = 0, bearing_ = 0;  // materials
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Hall(values).build();
}

std::vector<Parameter> hall_parameters() {
  return {
      {"bays", count, 3, 1, 20, "number of bays between columns"},
      {"bay_width", length, 4.0, 0.2, 50, "distance between the columns' axes"},
      {"column_width", length, 0.45, 0.01, 5, "diameter of the columns"},
      {"column_height", length, 3.6, 0.05, 30, "from the stone base to the cap block"},
      {"base_width", length, 0.8, 0.01, 10, "of the stone bases"},
      {"base_height", length, 0.25, 0.01, 10, "of the stone bases"},
      {"lintel_depth", length, 0.36, 0.01, 5, "height of the lintels between the columns' heads"},
      {"tenon_stiffness", rotational_stiffness, 50e3, 0.0, 1e12,
       "against a lintel's turning in a column; 0: it turns freely"},
      {"tenon_damping_ratio", ratio, 0.05, 0.0, 10.0, "damping of that turning"},
      {"bracket_tiers", count, 2, 1, 8, "arms one above another in a bracket set"},
      {"cap_width", length, 0.52, 0.01, 5, "of the cap blocks on the columns"},
      {"cap_height", length, 0.32, 0.01, 5, "of the cap blocks on the columns"},
      {"arm_length", length, 1.0, 0.05, 20, "of the lowest arms"},
      {"arm_step", length, 0.16, 0.0, 5, "by which an arm reaches beyond the one below, at either end"},
      {"arm_height", length, 0.24, 0.01, 5, "of the arms"},
      {"block_width", length, 0.26, 0.01, 5, "of the bearing blocks"},
      {"block_height", length, 0.16, 0.01, 5, "of the bearing blocks"},
      bearing_modulus_parameter(),
      {"plate_depth", length, 0.3, 0.01, 5, "of the plate that the roof lies on"},
      {"roof_height", length, 3.0, 0.1, 50, "from the plate to the ridge"},
      {"eave_overhang", length, 1.2, 0.0, 20, "of the roof beyond the plate"},
      {"roof_load", pressure, 4e3, 1.0, 1e6, "weight of the roof, tiles on a bed of earth, per area"},
      {"roof_depth", length, 4.0, 0.01, 100, "depth of roof that one row of columns carries"},
  };
}

}  // namespace

Layout dougong_hall() {
  Layout layout;
  layout.name = "dougong-hall";
  layout.summary = "a timber hall: columns on stone bases, bracket sets of stacked blocks, a heavy roof";
  layout.structural_type = "timber frame";
  layout.counting =
      "S1 is the columns with their bases and lintels, and its level the columns and lintels; S2 the bracket "
      "sets, and its level the plate on them; S3 the roof.";
  layout.parameters = joined(
      hall_parameters(), joined({ground_width_parameter(20.0)}, material_parameters(preset("timber"), 0.45)));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
