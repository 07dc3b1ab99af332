#include "structures/layouts/pagoda.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;

class Pagoda {
 public:
  explicit Pagoda(const ParameterValues& values) : values_(values), storeys_(values.count("storeys")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("timber", values_);
    bearing_ = add_bearing_timber(building_, values_);
    for (std::size_t storey = 1; storey <= storeys_; ++storey) add_storey(storey);
    if (values_("finial_height") > 0.0) add_finial();
    return std::move(building_);
  }

 private:
  double width(std::size_t storey) const {
    return values_("width") *
           (1.0 - values_("taper_ratio") * static_cast<double>(storey - 1) / static_cast<double>(storeys_));
  }
  double storey_height() const {
    return values_("column_height") + values_("cap_height") + values_("roof_height");
  }
  /// What carries the next storey: its columns stand within.
  double roof_top_width(std::size_t storey) const {
    return (storey < storeys_ ? width(storey + 1) : 0.0) + 2.0 * values_("column_width");
  }

  void add_storey(std::size_t number) {
    const double base = static_cast<double>(number - 1) * storey_height();
    Storey storey{fmt::format("S{}", number), base, storey_height(), {}, {}};
    const std::size_t columns = values_.count("columns");
    for (std::size_t i = 0; i < columns; ++i) {
      const double x = width(number) * (static_cast<double>(i) / static_cast<double>(columns - 1) - 0.5);
      storey.storey_blocks.push_back(add_rectangle(building_, values_,
                                                   fmt::format("{}.column{}", storey.name, i + 1), x, base,
                                                   values_("column_width"), values_("column_height")));
      storey.storey_blocks.push_back(add_rectangle(
          building_, {bearing_, values_("thickness")}, fmt::format("{}.cap{}", storey.name, i + 1), x,
          base + values_("column_height"), values_("cap_width"), values_("cap_height")));
    }
    storey.level_blocks = {add_roof(number, base + values_("column_height") + values_("cap_height"))};
    storey.storey_blocks.push_back(storey.level_blocks.front());
    building_.storeys.push_back(std::move(storey));
  }

  std::size_t add_roof(std::size_t number, double y) {
    const double bottom = 0.5 * width(number) + 0.5 * values_("cap_width"),
                 eave = 0.5 * width(number) + values_("eave_overhang"), top = 0.5 * roof_top_width(number),
                 height = values_("roof_height"), lip = y + 0.35 * height;
    const std::size_t roof = add_outline(
        building_, values_, fmt::format("S{}.roof", number),
        {{-bottom, y}, {bottom, y}, {eave, lip}, {top, y + height}, {-top, y + height}, {-eave, lip}});
    building_.scene.bodies[roof].mass =
        values_("roof_load") * values_("roof_depth") * 2.0 * eave / engine::standard_gravity;
    return roof;
  }

  /// The mast on the uppermost roof, held to it.
  void add_finial() {
    Storey& storey = building_.storeys.back();
    const std::size_t finial = add_rectangle(building_, values_, "finial", 0.0, storey.base + storey.height,
                                             values_("finial_width"), values_("finial_height"));
    connect(building_, block(storey.level_blocks.front()), block(finial), {});
    storey.storey_blocks.push_back(finial);
    storey.level_blocks.push_back(finial);
    storey.height += values_("finial_height");
  }

  void require_fitting() const {
    const double narrowest = width(storeys_) / (values_("columns") - 1.0);
    const double least = std::max(values_("cap_width"), values_("column_width")) + 0.02;
    require(
        narrowest >= least, values_, "taper_ratio",
        fmt::format("caps that do not meet in the uppermost storey, whose columns are {} apart; at least {}",
                    print_value(narrowest, length), print_value(least, length)),
        ratio);
    const double eave = 0.5 * values_("cap_width");
    require(values_("eave_overhang") > eave, values_, "eave_overhang",
            "more than half a cap width, " + print_value(eave, length));
    const double top = 0.5 * roof_top_width(1);
    require(top < 0.5 * width(1) + values_("eave_overhang"), values_, "eave_overhang",
            "eaves wider than the next storey's columns");
    require(values_("finial_width") <= 2.0 * values_("column_width"), values_, "finial_width",
            "at most two column widths, " + print_value(2.0 * values_("column_width"), length));
    require_on_ground(values_, -0.5 * width(1) - 0.5 * values_("column_width"),
                      0.5 * width(1) + 0.5 * values_("column_width"));
  }

  const ParameterValues& values_;
  std::size_t storeys_;
  std::size_t bearing_ = 0;  // material
  Building building_;
};

Building generate(const ParameterValues& values) {
  return Pagoda(values).build();
}

}  // namespace

Layout pagoda() {
  Layout layout;
  layout.name = "pagoda";
  layout.summary = "a timber pagoda whose storeys stand on one another without a tie";
  layout.structural_type = "timber frame";
  layout.counting =
      "A storey is its columns, their caps and the roof on them; its level is the roof, of the uppermost "
      "with "
      "the finial, whose height counts too.";
  layout.parameters = joined(
      {
          {"storeys", count, 5, 1, 30, "number of storeys"},
          {"columns", count, 4, 2, 12, "columns side by side in a storey"},
          {"width", length, 6.4, 0.1, 100, "between the outer columns' axes in the first storey"},
          {"taper_ratio", ratio, 0.5, 0.0, 0.95, "part of that width that would be lost in as many storeys"},
          {"column_width", length, 0.45, 0.01, 5, "diameter of the columns"},
          {"column_height", length, 2.4, 0.05, 30, "of every storey"},
          {"cap_width", length, 0.7, 0.01, 10, "of the blocks on the columns"},
          {"cap_height", length, 0.4, 0.01, 5, "of the blocks on the columns"},
          {"roof_height", length, 1.2, 0.05, 20, "from the caps to where the next storey stands"},
          {"eave_overhang", length, 2.2, 0.01, 20, "of a roof beyond the outer columns' axes"},
          {"roof_load", pressure, 3.5e3, 1.0, 1e6, "weight of the roofs, per area"},
          {"roof_depth", length, 3.2, 0.01, 100, "depth of roof that one row of columns carries"},
          bearing_modulus_parameter(),
          {"finial_width", length, 0.3, 0.01, 5, "of the mast on the uppermost roof"},
          {"finial_height", length, 4.0, 0.0, 50, "of the mast on the uppermost roof; 0: none"},
          ground_width_parameter(16.0),
      },
      material_parameters(preset("timber"), 0.45));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
