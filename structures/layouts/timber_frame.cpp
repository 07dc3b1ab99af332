#include "structures/layouts/timber_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "structures/layouts/parts.h"

namespace dougong::structures {
namespace {

using enum Dimension;
using engine::Vec2;

// Beams end this much below the posts' heads, so that no corner of theirs meets that of the post above.
constexpr double relief = 0.002;  // m

class TimberFrame {
 public:
  explicit TimberFrame(const ParameterValues& values)
      : values_(values), posts_(values.count("bays") + 1), height_(values("storey_height")) {}

  Building build() {
    require_fitting();
    building_ = on_ground("timber", values_);
    for (std::size_t storey = 1; storey <= values_.count("storeys"); ++storey) add_storey(storey);
    return std::move(building_);
  }

 private:
  double axis(std::size_t post) const {
    return (static_cast<double>(post) - 0.5 * static_cast<double>(posts_ - 1)) * values_("bay_width");
  }
  double axial() const {
    return values_("young_modulus") * values_("post_width") * values_("thickness") / height_;
  }

  void join(const std::string& name, engine::Owner a, engine::Owner b, Vec2 at, double turning) {
    const bool pinned = turning == 0.0;
    engine::Joint joint = joint_at(building_, name, pinned ? engine::JointKind::pin : engine::JointKind::weld,
                                   a, b, at, at, axial());
    joint.rotational_stiffness = turning;
    joint.damping_ratio = values_("joint_damping_ratio");
    building_.scene.joints.push_back(std::move(joint));
  }

  void add_storey(std::size_t number) {
    const double base = static_cast<double>(number - 1) * height_;
    Storey storey{fmt::format("S{}", number), base, height_, {}, {}};
    std::vector<std::size_t> posts;
    for (std::size_t i = 0; i < posts_; ++i) {
      posts.push_back(add_rectangle(building_, values_, fmt::format("{}.post{}", storey.name, i + 1), axis(i),
                                    base, values_("post_width"), height_));
      const engine::Owner below = number == 1 ? ground() : block(below_[i]);
      join(fmt::format("{}.foot{}", storey.name, i + 1), below, block(posts.back()), {axis(i), base},
           number == 1 ? 0.0 : turning());
    }
    storey.storey_blocks = posts;
    for (std::size_t bay = 0; bay + 1 < posts_; ++bay) add_beam(bay, posts, storey);
    if (values_.is("bracing", "diagonals")) add_diagonals(posts, storey);
    below_ = posts;
    building_.storeys.push_back(std::move(storey));
  }

  double turning() const { return values_.is("joints", "pinned") ? 0.0 : values_("joint_stiffness"); }

  void add_beam(std::size_t bay, const std::vector<std::size_t>& posts, Storey& storey) {
    const double depth = values_("beam_depth"), y = storey.base + height_ - relief - 0.5 * depth,
                 clear = values_("bay_width") - values_("post_width");
    const std::size_t beam = add_rectangle(building_, values_, fmt::format("{}.beam{}", storey.name, bay + 1),
                                           0.5 * (axis(bay) + axis(bay + 1)), y - 0.5 * depth, clear, depth);
    building_.scene.bodies[beam].mass =
        mass_of(building_, beam) +
        values_("floor_load") * values_("frame_spacing") * values_("bay_width") / engine::standard_gravity;
    storey.level_blocks.push_back(beam);
    storey.storey_blocks.push_back(beam);
    for (const std::size_t end : {bay, bay + 1}) {
      const double side = end == bay ? 1.0 : -1.0;
      const std::string place =
          fmt::format("{}.beam{}.{}", storey.name, bay + 1, end == bay ? "left" : "right");
      join(place, block(posts[end]), block(beam), {axis(end) + 0.5 * side * values_("post_width"), y},
           turning());
      if (values_.is("bracing", "knee-braces")) add_knee(place, posts[end], beam, axis(end), side, y);
    }
  }

  void add_knee(const std::string& place, std::size_t post, std::size_t beam, double x, double side,
                double y) {
    const double reach = values_("brace_reach");
    building_.scene.joints.push_back(joint_at(building_, place + ".knee", engine::JointKind::distance,
                                              block(post), block(beam), {x, y - reach}, {x + side * reach, y},
                                              values_("brace_stiffness_axial")));
  }

  void add_diagonals(const std::vector<std::size_t>& posts, const Storey& storey) {
    for (std::size_t bay = 0; bay + 1 < posts_; ++bay)
      for (const bool up : {true, false}) {
        const std::size_t from = up ? bay : bay + 1, to = up ? bay + 1 : bay;
        const engine::Owner foot = below_.empty() ? ground() : block(below_[from]);
        building_.scene.joints.push_back(
            joint_at(building_, fmt::format("{}.diagonal{}.{}", storey.name, bay + 1, up ? "up" : "down"),
                     engine::JointKind::distance, foot, block(posts[to]), {axis(from), storey.base},
                     {axis(to), storey.base + height_}, values_("brace_stiffness_axial")));
      }
  }

  void require_fitting() const {
    if (values_.is("joints", "pinned") && values_.is("bracing", "none"))
      throw LayoutError("bracing", "knee-braces or diagonals where all joints are pinned: a mechanism else",
                        "none");
    const double clear = values_("post_width") + 0.1;
    require(values_("bay_width") >= clear, values_, "bay_width",
            "at least the post width and 0.1 m, " + print_value(clear, length));
    require(values_("beam_depth") <= 0.5 * height_, values_, "beam_depth",
            "at most half the storey height, " + print_value(0.5 * height_, length));
    const double room =
        std::min(0.5 * (values_("bay_width") - values_("post_width")), height_ - 0.5 * values_("beam_depth"));
    require(!values_.is("bracing", "knee-braces") || values_("brace_reach") <= room, values_, "brace_reach",
            "room along half a beam and a post, " + print_value(room, length));
    const double half = axis(posts_ - 1) + 0.5 * values_("post_width");
    require_on_ground(values_, -half, half);
  }

  const ParameterValues& values_;
  std::size_t posts_;
  double height_;                   // m
  std::vector<std::size_t> below_;  // posts of the storey below
  Building building_;
};

Building generate(const ParameterValues& values) {
  return TimberFrame(values).build();
}

}  // namespace

Layout timber_frame() {
  Layout layout;
  layout.name = "timber-frame";
  layout.summary = "a timber frame of posts and beams in pinned or semi-rigid joints, with or without braces";
  layout.structural_type = "timber frame";
  layout.counting = "A storey is its posts and the beams between their heads; its level is the beams.";
  layout.parameters = joined(
      {
          {"storeys", count, 2, 1, 30, "number of storeys"},
          {"bays", count, 3, 1, 40, "number of bays side by side"},
          {"storey_height", length, 2.7, 0.1, 30, "height of the posts"},
          {"bay_width", length, 3.0, 0.15, 50, "distance between the posts' axes"},
          {"post_width", length, 0.18, 0.01, 5, "of the posts"},
          {"beam_depth", length, 0.3, 0.01, 5, "height of the beams"},
          {"floor_load", pressure, 2e3, 0.0, 1e6, "weight of the floors, with what lies on them, per area"},
          {"frame_spacing", length, 3.0, 0.0, 100, "width of floor that one frame carries"},
          choice("joints", {"semi-rigid", "pinned"}, "how beams and upper posts are held in the nodes"),
          {"joint_stiffness", rotational_stiffness, 400e3, 1.0, 1e12,
           "of a semi-rigid joint against turning"},
          {"joint_damping_ratio", ratio, 0.03, 0.0, 10.0, "damping of a joint"},
          choice("bracing", {"none", "knee-braces", "diagonals"}, "at every beam's ends, or in every bay"),
          {"brace_reach", length, 0.8, 0.01, 20, "of a knee brace along its post and its beam"},
          {"brace_stiffness_axial", stiffness, 1e7, 1.0, 1e13, "of a brace, with its joints"},
          ground_width_parameter(14.0),
      },
      material_parameters(preset("timber"), 0.18));
  layout.generate = generate;
  return layout;
}

}  // namespace dougong::structures
