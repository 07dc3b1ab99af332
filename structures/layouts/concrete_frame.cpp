#include "structures/layouts/concrete_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/mortar.h"
#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

// Columns end this much short of the beams' faces, so that no corner of a beam meets a corner of a column.
constexpr double relief = 0.002;  // m

class Frame {
 public:
  explicit Frame(const ParameterValues& values)
      : values_(values),
        bays_(values.count("bays")),
        storeys_(values.count("storeys")),
        column_(values("column_width")),
        beam_(values("beam_depth")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("concrete", values_);
    if (!values_.is("infill", "none")) add_masonry();
    feet_.resize(bays_ + 1);
    for (std::size_t storey = 1; storey <= storeys_; ++storey) add_storey(storey);
    return std::move(building_);
  }

 private:
  // --- where things are -------------------------------------------------------------------------------

  double axis(std::size_t column) const {
    return (static_cast<double>(column) - 0.5 * static_cast<double>(bays_)) * values_("bay_width");
  }
  double first_height() const {
    const double own = values_("first_storey_height");
    return own > 0.0 ? own : values_("storey_height");
  }
  double height(std::size_t storey) const { return storey == 1 ? first_height() : values_("storey_height"); }
  /// Top of a level.
  double level(std::size_t storey) const {
    return storey == 0 ? 0.0 : first_height() + static_cast<double>(storey - 1) * values_("storey_height");
  }
  double node_bottom(std::size_t storey) const { return level(storey) - beam_ - 2.0 * relief; }
  std::size_t braced_bay() const { return (bays_ + 1) / 2; }
  bool weak(const char* what) const { return values_.is("weakness", what); }

  // --- what holds it together -------------------------------------------------------------------------

  Connection concrete(const char* reinforcement, bool is_weak) const {
    const double factor = is_weak ? values_("weakness_ratio") : 1.0;
    Connection c;
    c.law.yield_strength = 0.8 * factor * values_(reinforcement) * values_("steel_yield");
    c.law.cohesion = values_("shear_strength");
    c.law.compressive_strength = endless_if_zero(values_("compressive_strength"));
    c.law.friction_coefficient = values_("friction");
    c.law.damping_ratio = values_("bond_damping_ratio");
    c.stiffness_factor = values_("cracked_stiffness");
    c.shear_coefficient = rectangle_shear;
    return c;
  }
  Connection of_column(std::size_t storey) const {
    return concrete("column_reinforcement", weak("columns") || (weak("first-storey") && storey == 1));
  }
  Connection of_beam() const { return concrete("beam_reinforcement", weak("beams")); }

  // --- members ----------------------------------------------------------------------------------------

  void add_column(std::size_t storey, std::size_t i, Storey& sheet) {
    const Connection c = of_column(storey);
    const auto chain = add_bar(building_, values_, fmt::format("{}.column{}", sheet.name, i + 1),
                               {axis(i), level(storey - 1)}, {axis(i), node_bottom(storey)}, column_,
                               values_.count("blocks_per_column"));
    connect(building_, storey == 1 ? ground() : block(feet_[i]), block(chain.front()), c);
    connect_chain(building_, chain, c);
    const std::size_t node = add_rectangle(building_, values_, fmt::format("{}.node{}", sheet.name, i + 1),
                                           axis(i), node_bottom(storey), column_, beam_ + 2.0 * relief);
    connect(building_, block(chain.back()), block(node), c);
    sheet.storey_blocks.insert(sheet.storey_blocks.end(), chain.begin(), chain.end());
    sheet.level_blocks.push_back(node);
    feet_[i] = node;
  }

  void add_beam(std::size_t storey, std::size_t bay, Storey& sheet) {
    const double y = level(storey) - relief - 0.5 * beam_;
    const Vec2 from{axis(bay - 1) + 0.5 * column_, y}, to{axis(bay) - 0.5 * column_, y};
    std::vector<std::size_t> chain = add_bar(building_, values_, fmt::format("{}.beam{}", sheet.name, bay),
                                             from, to, beam_, values_.count("blocks_per_beam"));
    load_floor(chain);
    sheet.level_blocks.insert(sheet.level_blocks.end(), chain.begin(), chain.end());
    chain.insert(chain.begin(), feet_[bay - 1]);
    chain.push_back(feet_[bay]);
    connect_chain(building_, chain, of_beam());
  }

  void load_floor(const std::vector<std::size_t>& beam) {
    const double a_metre = values_("floor_load") * values_("frame_spacing") / engine::standard_gravity;
    for (const std::size_t i : beam) {
      const Bounds box = bounds_of(building_, i);
      building_.scene.bodies[i].mass = mass_of(building_, i) + a_metre * (box.high.x - box.low.x);
    }
  }

  // --- what fills the bays ----------------------------------------------------------------------------

  void add_masonry() {
    engine::Material masonry = preset("brick");
    masonry.name = "infill";
    masonry.young_modulus = values_("infill_modulus");
    masonry_ = add_material(building_, masonry);
  }

  bool is_infilled(std::size_t storey) const {
    return values_.is("infill", "all-storeys") || (values_.is("infill", "above-first") && storey > 1);
  }

  Connection of_infill() const {
    Connection c;
    c.law.tensile_strength = values_("infill_strength");
    c.law.cohesion = 1.5 * values_("infill_strength");
    c.law.friction_coefficient = values_("friction");
    return c;
  }

  /// A grid of blocks that fits between columns and beams, held to them and within itself.
  void add_panel(std::size_t storey, std::size_t bay, const char* kind, const Stock& stock,
                 const Connection& c, Storey& sheet) {
    const double left = axis(bay - 1) + 0.5 * column_, right = axis(bay) - 0.5 * column_;
    const double bottom = storey == 1 ? 0.0 : level(storey - 1) - relief,
                 top = level(storey) - relief - beam_;
    const std::size_t columns = values_.count("panel_columns"), rows = values_.count("panel_rows");
    std::vector<std::size_t> panel;
    for (std::size_t r = 0; r < rows; ++r) {
      const double step = (top - bottom) / static_cast<double>(rows),
                   y = bottom + static_cast<double>(r) * step;
      const auto part = [&](std::size_t k) {
        return left + (right - left) * static_cast<double>(k) / static_cast<double>(columns);
      };
      for (std::size_t k = 0; k < columns; ++k)
        panel.push_back(add_outline(building_, stock,
                                    fmt::format("{}.{}{}.{}", sheet.name, kind, bay, panel.size() + 1),
                                    {{part(k), y},
                                     {part(k + 1), y},
                                     {part(k + 1), r + 1 == rows ? top : y + step},
                                     {part(k), r + 1 == rows ? top : y + step}}));
    }
    connect_panel(panel, storey, c);
    sheet.storey_blocks.insert(sheet.storey_blocks.end(), panel.begin(), panel.end());
  }

  void connect_panel(const std::vector<std::size_t>& panel, std::size_t storey, const Connection& c) {
    const double least = 2.0 * relief;
    connect_touching(building_, panel, c, 1e-6, least);
    std::vector<std::size_t> around;
    for (std::size_t i = 0; i < panel.front(); ++i)
      if (bounds_of(building_, i).high.y > level(storey - 1) - beam_) around.push_back(i);
    for (const std::size_t i : around)
      for (const std::size_t j : panel) connect(building_, block(i), block(j), c, 1e-6, least);
  }

  void add_braces(std::size_t storey, const std::vector<engine::Owner>& below) {
    const std::size_t bay = braced_bay();
    const auto place = [&](engine::Owner owner, std::size_t column) {
      return owner.terrain ? Vec2{axis(column), 0.0} : building_.scene.bodies[owner.index].position;
    };
    const auto add = [&](std::size_t from, std::size_t to, const char* name) {
      building_.scene.joints.push_back(joint_at(building_, fmt::format("S{}.brace.{}", storey, name),
                                                engine::JointKind::distance, below[from], block(feet_[to]),
                                                place(below[from], from), place(block(feet_[to]), to),
                                                values_("frame_brace_stiffness")));
    };
    add(bay - 1, bay, "up");
    if (values_.is("bracing", "cross")) add(bay, bay - 1, "down");
  }

  // --- storeys ----------------------------------------------------------------------------------------

  void add_storey(std::size_t number) {
    Storey sheet{fmt::format("S{}", number), level(number - 1), height(number), {}, {}};
    std::vector<engine::Owner> below(bays_ + 1, ground());
    if (number > 1) std::ranges::transform(feet_, below.begin(), block);
    for (std::size_t i = 0; i <= bays_; ++i) add_column(number, i, sheet);
    for (std::size_t bay = 1; bay <= bays_; ++bay) add_beam(number, bay, sheet);
    if (!(weak("first-storey") && number == 1)) stiffen(number, below, sheet);
    sheet.storey_blocks.insert(sheet.storey_blocks.end(), sheet.level_blocks.begin(),
                               sheet.level_blocks.end());
    building_.storeys.push_back(std::move(sheet));
  }

  void stiffen(std::size_t number, const std::vector<engine::Owner>& below, Storey& sheet) {
    const bool wall = values_.is("shear_wall", "one-bay");
    if (wall)
      add_panel(number, braced_bay(), "wall", {0, values_("shear_wall_thickness")},
                concrete("wall_reinforcement", false), sheet);
    if (is_infilled(number))
      for (std::size_t bay = 1; bay <= bays_; ++bay)
        if (!(wall && bay == braced_bay()))
          add_panel(number, bay, "infill", {masonry_, values_("infill_thickness")}, of_infill(), sheet);
    if (!values_.is("bracing", "none")) add_braces(number, below);
  }

  // --- what fits --------------------------------------------------------------------------------------

  void require_fitting() const {
    const double least_bay = column_ + 0.1, least_height = beam_ + 2.0 * relief + 0.1;
    require(values_("bay_width") >= least_bay, values_, "bay_width",
            "at least the column width and 0.1 m, " + print_value(least_bay, length));
    require(values_("storey_height") >= least_height, values_, "storey_height",
            "at least the beam depth and 0.1 m, " + print_value(least_height, length));
    require(first_height() >= least_height, values_, "first_storey_height",
            "at least the beam depth and 0.1 m, " + print_value(least_height, length));
    require(!(values_.is("shear_wall", "one-bay") && !values_.is("bracing", "none")), values_, "bracing",
            "none beside a shear wall, which stands in the same bay", count);
    require_on_ground(values_, axis(0) - 0.5 * column_, axis(bays_) + 0.5 * column_);
  }

  const ParameterValues& values_;
  std::size_t bays_, storeys_;
  double column_, beam_;           // m
  std::size_t masonry_ = 0;        // material
  std::vector<std::size_t> feet_;  // what the next storey's columns stand on
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Frame(values).build();
}

std::vector<Parameter> frame_parameters() {
  return {
      {"storeys", count, 3, 1, 60, "number of storeys"},
      {"bays", count, 2, 1, 40, "number of bays side by side"},
      {"storey_height", length, 3.2, 0.2, 50, "from a level to the next, to the beams' tops"},
      {"first_storey_height", length, 0.0, 0.0, 50, "of the first storey; 0: as the others"},
      {"bay_width", length, 5.0, 0.2, 100, "distance between the columns' axes"},
      {"column_width", length, 0.4, 0.02, 10, "in the plane of the frame"},
      {"beam_depth", length, 0.5, 0.02, 10, "height of the beams"},
      {"blocks_per_column", count, 5, 1, 60, "blocks of a column between two nodes"},
      {"blocks_per_beam", count, 6, 1, 60, "blocks of a beam between two nodes"},
      {"floor_load", pressure, 6e3, 0.0, 1e6, "weight of the floors, with what lies on them, per area"},
      {"frame_spacing", length, 5.0, 0.0, 100, "width of floor that one frame carries"},
      {"column_reinforcement", ratio, 0.015, 1e-5, 0.2, "all bars of a column over its section"},
      {"beam_reinforcement", ratio, 0.015, 1e-5, 0.2, "all bars of a beam over its section"},
      {"steel_yield", pressure, 500e6, 1e3, 5e9, "yield strength of the bars"},
      {"shear_strength", pressure, 3e6, 0.0, 1e9, "of a member without axial force"},
      {"compressive_strength", pressure, 0.0, 0.0, 1e10, "of the concrete; 0: endless"},
      {"cracked_stiffness", ratio, 0.5, 0.01, 1.0, "stiffness over that of the uncracked members"},
      {"bond_damping_ratio", ratio, 0.02, 0.0, 10.0, "local damping of the faces between blocks"},
      choice("weakness", {"none", "first-storey", "columns", "beams"},
             "members with less reinforcement; first-storey: its columns, and nothing stiffens it"),
      {"weakness_ratio", ratio, 0.5, 0.01, 1.0, "their reinforcement over that of the others"},
      choice("infill", {"none", "all-storeys", "above-first"}, "masonry panels in the bays"),
      {"infill_modulus", pressure, 2e9, 1e5, 1e12, "Young's modulus of the panels"},
      {"infill_strength", pressure, 0.2e6, 0.0, 1e9,
       "tensile strength of their joints; cohesion is 1.5 times it"},
      {"infill_thickness", length, 0.2, 0.001, 10, "out of the plane"},
      choice("bracing", {"none", "diagonal", "cross"},
             "elastic steel bars from node to node in the middle bay"),
      {"frame_brace_stiffness", stiffness, 7e7, 1.0, 1e13, "axial stiffness E A/L of each such bar"},
      choice("shear_wall", {"none", "one-bay"}, "a concrete wall that fills the middle bay"),
      {"shear_wall_thickness", length, 0.2, 0.001, 10, "out of the plane"},
      {"wall_reinforcement", ratio, 0.005, 1e-5, 0.2, "bars of the wall over its section"},
      {"panel_columns", count, 3, 1, 40, "blocks of a panel or wall side by side"},
      {"panel_rows", count, 2, 1, 40, "blocks of a panel or wall one on another"},
  };
}

}  // namespace

Layout concrete_frame() {
  Layout layout;
  layout.name = "concrete-frame";
  layout.summary =
      "a reinforced-concrete frame of bonded blocks, bare, infilled, braced or with a shear wall";
  layout.structural_type = "rc frame";
  layout.counting =
      "A storey is its columns, what fills its bays and the level on them; the level is its beams and nodes "
      "and "
      "its height is measured to the tops of the beams.";
  layout.parameters = joined(frame_parameters(), joined({ground_width_parameter(18.0)},
                                                        material_parameters(engine::Material{}, 0.4)));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
