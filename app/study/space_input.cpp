#include "app/study/space_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/study/scene_build.h"
#include "app/study/scene_run.h"
#include "engine/material_presets.h"
#include "seismic/input_error.h"
#include "seismic/numerics/parse_number.h"
#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using engine::Vec2;

/// Radius of a star over the least distance of two of them: a point that can still be touched and seen.
constexpr double star_size = 0.005;

/// Thrown where a value is wrong: asked for again, or the end.
struct Trouble {
  std::string expected, found;
};

enum class Least { any, above_zero };

MaterialChoice material_of(const std::string& preset) {
  MaterialChoice material;
  material.name = material.preset = preset.empty() ? "concrete" : preset;
  if (preset.empty()) material.friction = space_friction;
  if (engine::find_material_preset(material.name)) return material;
  std::vector<std::string> known;
  for (const engine::MaterialPreset& p : engine::material_presets()) known.push_back(p.material.name);
  throw ScenarioError({{"--material " + preset, fmt::format("expected one of {}", fmt::join(known, ", "))}});
}

// Reads messages; each is a member function named by its word.
class Loop {
 public:
  Loop(SpaceWords& words, const SpaceRules& rules) : words_(words), rules_(rules) {
    out_.description.materials.push_back(material_of(rules.material));
    out_.description.head.title = "space";
  }

  SpaceInput read() {
    words_.say("Messages: cir, tri, rect, tercir, tertri, terrect, plane, star, save, finish (SI units).");
    while (one_message()) {
    }
    finish_stars();
    if (rules_.earthquake) shake_terrains();
    out_.divisor = number("n: the step is 0.01 s / n, usually 10", Least::above_zero);
    refuse_what_follows();
    return std::move(out_);
  }

 private:
  using Message = void (Loop::*)();
  struct Named {
    const char* word;
    Message read;
  };
  static constexpr std::array<Named, 9> messages() {
    return {{{"cir", &Loop::cir},
             {"tri", &Loop::tri},
             {"rect", &Loop::rect},
             {"tercir", &Loop::tercir},
             {"tertri", &Loop::tertri},
             {"terrect", &Loop::terrect},
             {"plane", &Loop::plane},
             {"star", &Loop::star},
             {"save", &Loop::save}}};
  }

  // --- words and numbers -----------------------------------------------------------------------------

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw seismic::InputError(words_.source(), words_.line(), expected, found);
  }

  std::string of_message(const std::string& what) const {
    return message_.empty() ? what : fmt::format("{} of {}", what, message_);
  }

  std::string word(const std::string& what) {
    const std::string asked = of_message(what);
    if (auto next = words_.next(asked)) return *next;
    fail(asked, "the end of the input");
  }

  /// Tries until it succeeds; without a person at the keyboard only once.
  template <class Try>
  auto insist(Try attempt) {
    for (;;) {
      try {
        return attempt();
      } catch (const Trouble& trouble) {
        if (!words_.asks()) fail(trouble.expected, trouble.found);
        words_.ask_again(fmt::format("expected {}, found {}", trouble.expected, trouble.found));
      }
    }
  }

  // A person has just pressed Enter; a text may hold a message that was meant to come before finish.
  void refuse_what_follows() {
    if (words_.asks()) return;
    if (const auto more = words_.next("")) fail("nothing after n", "\"" + *more + "\"");
  }

  double number(const std::string& what, Least least = Least::any) {
    return insist([&] {
      const std::string text = word(what);
      const auto value = seismic::parse_number(text);
      if (!value) throw Trouble{of_message(what) + " as a number", "\"" + text + "\""};
      if (least == Least::above_zero && !(*value > 0.0))
        throw Trouble{of_message(what) + " above zero", text};
      return *value;
    });
  }

  Vec2 point(const std::string& what, const std::string& unit) {
    const double x = number(fmt::format("{} x ({})", what, unit));
    return {x, number(fmt::format("{} y ({})", what, unit))};
  }

  // --- parts of messages -----------------------------------------------------------------------------

  /// Charge, velocity, spin and mass, with which every body begins.
  BodyChoice body_start(const std::string& kind) {
    BodyChoice body;
    body.name = fmt::format("{}{}", message_, ++count_[message_]);
    body.shape.kind = kind;
    body.material = out_.description.materials.front().name;
    body.charge = number("charge (C)");
    body.velocity = point("velocity", "m/s");
    body.spin = number("spin (rad/s)");
    body.mass = number("mass (kg)", Least::above_zero);
    return body;
  }

  TerrainChoice terrain_start(const std::string& kind) {
    TerrainChoice terrain;
    terrain.name = fmt::format("{}{}", message_, ++count_[message_]);
    terrain.shape.kind = kind;
    terrain.material = out_.description.materials.front().name;
    return terrain;
  }

  void circle(ShapeChoice& shape) {
    shape.position = point("centre", "m");
    shape.radius = number("radius (m)", Least::above_zero);
  }

  void triangle(ShapeChoice& shape) {
    shape.corners = insist([&] {
      std::vector<Vec2> corners;
      for (const char* which : {"first", "second", "third"})
        corners.push_back(point(fmt::format("{} corner", which), "m"));
      try {
        engine::make_polygon(corners);
      } catch (const std::invalid_argument& error) {
        throw Trouble{of_message("three corners") + " that are not on one line", error.what()};
      }
      return corners;
    });
  }

  void rectangle(ShapeChoice& shape) {
    shape.width = number("length (m)", Least::above_zero);
    shape.height = number("width (m)", Least::above_zero);
    shape.position = point("centre", "m");
    shape.angle = number("direction (rad)");
  }

  // --- messages --------------------------------------------------------------------------------------

  void cir() { add(body_start("circle"), &Loop::circle); }
  void tri() { add(body_start("triangle"), &Loop::triangle); }
  void rect() { add(body_start("rectangle"), &Loop::rectangle); }
  void tercir() { add(terrain_start("circle"), &Loop::circle); }
  void tertri() { add(terrain_start("triangle"), &Loop::triangle); }
  void terrect() { add(terrain_start("rectangle"), &Loop::rectangle); }

  using Sizes = void (Loop::*)(ShapeChoice&);
  void add(BodyChoice body, Sizes sizes) {
    (this->*sizes)(body.shape);
    out_.description.bodies.push_back(std::move(body));
  }
  void add(TerrainChoice terrain, Sizes sizes) {
    (this->*sizes)(terrain.shape);
    out_.description.terrains.push_back(std::move(terrain));
  }

  /// The solid side is below: the frame's x axis points to the right.
  void plane() {
    TerrainChoice terrain = terrain_start("half-plane");
    const auto [left, right] = insist([&] {
      const Vec2 a = point("first point", "m"), b = point("second point", "m");
      if (a == b) throw Trouble{"two different points of plane", "the same point twice"};
      return b.x < a.x ? std::pair(b, a) : std::pair(a, b);
    });
    terrain.shape.position = left;
    terrain.shape.angle = std::atan2(right.y - left.y, right.x - left.x);
    out_.description.terrains.push_back(std::move(terrain));
  }

  void star() {
    BodyChoice body;
    body.name = fmt::format("star{}", ++count_[message_]);
    body.shape.kind = "circle";
    body.material = out_.description.materials.front().name;
    body.shape.position = point("position", "m");
    body.mass = number("mass (kg)", Least::above_zero);
    body.velocity = point("velocity", "m/s");
    stars_.push_back(out_.description.bodies.size());
    out_.description.bodies.push_back(std::move(body));
  }

  void save() { out_.save_paths.push_back(word("file")); }

  // --- the loop --------------------------------------------------------------------------------------

  static std::vector<std::string> known_words() {
    std::vector<std::string> words;
    for (const Named& named : messages()) words.emplace_back(named.word);
    words.emplace_back("finish");
    return words;
  }

  Trouble unknown(const std::string& typed) const {
    const std::vector<std::string> known = known_words();
    const std::string nearest = structures::nearest_name(typed, known);
    return {fmt::format("a message ({})", fmt::join(known, ", ")),
            fmt::format("\"{}\"{}", typed,
                        nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest))};
  }

  /// False after finish.
  bool one_message() {
    message_.clear();
    return insist([&] {
      const std::string typed = word("message");
      if (typed == "finish") {
        if (out_.description.bodies.empty()) throw Trouble{"at least one body before finish", "none"};
        if (rules_.earthquake && out_.description.terrains.empty())
          throw Trouble{"terrain that the record can shake before finish", "none"};
        return false;
      }
      const auto known = messages();
      const auto it = std::ranges::find(known, typed, [](const Named& n) { return std::string(n.word); });
      if (it == known.end()) throw unknown(typed);
      message_ = typed;
      (this->*it->read)();
      return true;
    });
  }

  double least_distance() const {
    double least = std::numeric_limits<double>::infinity();
    const auto& bodies = out_.description.bodies;
    for (std::size_t i = 0; i < stars_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least,
                         engine::norm(bodies[stars_[i]].shape.position - bodies[stars_[j]].shape.position));
    return std::isfinite(least) && least > 0.0 ? least : 1.0;
  }

  void finish_stars() {
    if (stars_.empty()) return;
    out_.description.head.gravity.reset();
    out_.description.fields.gravitational_constant = real_gravitational_constant;
    const double radius = star_size * least_distance();
    for (const std::size_t i : stars_) out_.description.bodies[i].shape.radius = radius;
  }

  void shake_terrains() {
    message_.clear();
    const MotionChoice motion = insist([&] {
      MotionChoice choice;
      choice.source = word("record (a shipped name, or a file)");
      try {
        if (rules_.try_record) rules_.try_record(choice);
      } catch (const seismic::InputError& error) {
        throw Trouble{error.problems().front().expected, error.problems().front().found};
      }
      return choice;
    });
    for (TerrainChoice& terrain : out_.description.terrains) terrain.motion = motion;
  }

  SpaceWords& words_;
  const SpaceRules& rules_;
  SpaceInput out_;
  std::string message_;  // that is being read
  std::map<std::string, int> count_;
  std::vector<std::size_t> stars_;
};

}  // namespace

SpaceInput read_space(SpaceWords& words, const SpaceRules& rules) {
  return Loop(words, rules).read();
}

std::string choose_space_step(SceneDescription& description, double divisor,
                              const std::filesystem::path& records_directory) {
  description.solve.integrator = "velocity-verlet";  // a step is asked for
  const bool settles = description.solve.settle;
  const double bound = (settles ? prepare_scene : check_scene)(description, records_directory).plan.bound,
               step = space_tick / divisor;
  if (step <= bound) {
    description.solve.step = step;
    return fmt::format("0.01 s / {:g} = {:.4g} s, as asked for", divisor, step);
  }
  description.solve.step_fraction = 0.5;
  return fmt::format(
      "0.01 s / {:g} = {:.4g} s is above the stability bound of {:.3g} s; each is divided into steps of half "
      "the bound, {:.3g} s",
      divisor, step, bound, 0.5 * bound);
}

}  // namespace dougong::app
