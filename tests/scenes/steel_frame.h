// The seven-storey steel frame of comparison C08, as bars of bonded blocks between nodes.
//
// CSI verification manual, example 1; SeismoStruct verification report (2012), example 11. Members have an
// area and a second moment, no shear strain and no mass; floors are rigid along their length.
#pragma once

#include <array>

#include "tests/scenes/bonded_bars.h"

namespace dougong::scenes {

struct SteelSection {
  double area, second_moment;  // in2, in4
};

class SteelFrame {
 public:
  static constexpr double inch = 0.0254, kip = 4448.2216152605;  // m, N
  static constexpr std::size_t storeys = 7, lines = 3;
  static constexpr double bay = 360.0 * inch, floor_mass = 0.49 * kip / inch;                 // m, kg
  static constexpr std::array<double, storeys> loads{2.5, 5.0, 7.5, 10.0, 12.5, 15.0, 20.0};  // kip

  /// Each member as `parts` blocks.
  explicit SteelFrame(int parts) : parts_(parts) {
    scene_ = scene(0.0, 1e9);
    scene_.gravity = {};
    scene_.terrains.push_back(ground(4.0 * bay));
    for (std::size_t storey = 0; storey < storeys; ++storey) add_storey(storey);
  }

  const engine::Scene& model() const { return scene_; }
  std::size_t node(std::size_t storey, std::size_t line) const { return nodes_[storey][line]; }
  std::size_t first_block_of_left_column() const { return foot_; }
  /// Of the left column's lowest bond, half a block long.
  double foot_axial_stiffness() const { return modulus * area(column(0, 0)) / (0.5 * part_of(height(0))); }
  double foot_bending_stiffness() const {
    return modulus * second_moment(column(0, 0)) / (0.5 * part_of(height(0)));
  }

 private:
  static constexpr double modulus = 29500.0 * kip / (inch * inch);  // Pa

  static double height(std::size_t storey) { return (storey < 2 ? 162.0 : 156.0) * inch; }
  static double area(SteelSection s) { return s.area * inch * inch; }
  static double second_moment(SteelSection s) { return s.second_moment * inch * inch * inch * inch; }
  double part_of(double length) const { return length / parts_; }
  static SteelSection column(std::size_t storey, std::size_t line) {
    constexpr SteelSection w176{51.7, 2150}, w211{62.1, 2670}, w246{72.3, 3230}, w287{84.4, 3910};
    const bool middle = line == 1;
    return storey < 3 ? (middle ? w287 : w246) : storey < 5 ? (middle ? w246 : w211) : (middle ? w211 : w176);
  }
  static SteelSection beam(std::size_t storey) {
    constexpr SteelSection w110{32.5, 3330}, w130{38.3, 4020}, w160{47.1, 5120};
    return storey < 2 ? w160 : storey < 4 ? w130 : w110;
  }

  /// A rectangle 1 m thick of the same stiffnesses: depth sqrt(12 I/A), modulus E A/depth.
  void add_member(SteelSection section, engine::Vec2 start, engine::Vec2 end, engine::Owner a,
                  engine::Owner b, double axial_factor) {
    BondedBar bar;
    const double wide = axial_factor * area(section);
    bar.depth = std::sqrt(12.0 * second_moment(section) / wide);
    bar.modulus = modulus * wide / bar.depth;
    bar.density = 1e-4 * floor_mass / (norm(end - start) * bar.depth);
    bar.count = parts_, bar.start = start, bar.end = end;
    add_bar(scene_, bar, &a, &b);
  }

  void add_storey(std::size_t storey) {
    const double below = top_;
    top_ += height(storey);
    for (std::size_t line = 0; line < lines; ++line) {
      const double x = bay * (static_cast<double>(line) - 1.0);
      engine::Body node = block(0.05, 0.05, {x, top_});
      node.name = "node " + std::to_string(storey) + std::to_string(line);
      // The middle line does not move up and down in sway: there the floor's mass acts along it only.
      node.mass = (line == 1 ? 1.0 : 1e-4) * floor_mass;
      node.inertia = 1e-6 * floor_mass;
      node.collides = false;
      nodes_[storey][line] = scene_.bodies.size();
      scene_.bodies.push_back(node);
      const engine::Owner foot =
          storey == 0 ? engine::Owner{true, 0} : engine::Owner{false, nodes_[storey - 1][line]};
      if (storey == 0 && line == 0) foot_ = scene_.bodies.size();
      add_member(column(storey, line), {x, below}, {x, top_}, foot, {false, nodes_[storey][line]}, 1.0);
    }
    for (std::size_t line = 0; line + 1 < lines; ++line) {
      const double x = bay * (static_cast<double>(line) - 1.0);
      add_member(beam(storey), {x, top_}, {x + bay, top_}, {false, nodes_[storey][line]},
                 {false, nodes_[storey][line + 1]}, 100.0);
    }
  }

  int parts_;
  double top_ = 0.0;  // m
  engine::Scene scene_;
  std::array<std::array<std::size_t, lines>, storeys> nodes_{};
  std::size_t foot_ = 0;
};

}  // namespace dougong::scenes
