#include "structures/model_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <set>

#include "structures/separation.h"
#include "structures/units.h"

namespace dougong::structures {
namespace {

using engine::Vec2;

constexpr double upright = 0.26;  // least vertical part of a supporting normal, cos 75 deg
constexpr double inclined =
    0.02;  // least vertical part of the normal at which a wedge is held, 1 deg off plumb

std::string at(Vec2 place) {
  return fmt::format("at ({:.2f}, {:.2f}) m", place.x, place.y);
}

std::string millimetres(double length) {
  return fmt::format("{:.3g} mm", 1e3 * length);
}

/// Blocks first, then terrains, in one numbering.
struct Piece {
  std::string name;
  PlacedShape shape;
};

struct Touch {
  std::size_t a, b;  // a < b
  Separation between;
};

class Check {
 public:
  Check(const Building& building, const ModelCheckOptions& options)
      : scene_(building.scene), options_(options) {
    for (const engine::Body& body : scene_.bodies)
      pieces_.push_back({"block " + body.name, place(body.shape, body.position, body.angle)});
    for (const engine::Terrain& terrain : scene_.terrains)
      pieces_.push_back({"terrain " + terrain.name, place(terrain.shape, terrain.position, terrain.angle)});
  }

  std::vector<Finding> run(const Building& building) {
    check_storeys(building);
    if (!all_finite()) return sorted();
    find_links();
    find_touches();
    check_overlaps_and_gaps();
    check_support();
    check_balance();
    check_ratios();
    check_slivers();
    return sorted();
  }

 private:
  void add(Severity severity, std::string message, Vec2 place) {
    findings_.push_back({severity, std::move(message), place});
  }

  std::vector<Finding> sorted() {
    std::ranges::stable_sort(findings_, std::ranges::greater{}, &Finding::severity);
    return std::move(findings_);
  }

  std::size_t blocks() const { return scene_.bodies.size(); }

  bool all_finite() {
    const std::size_t before = findings_.size();
    for (const engine::Body& body : scene_.bodies)
      if (!std::isfinite(body.position.x) || !std::isfinite(body.position.y) || !std::isfinite(body.angle))
        add(Severity::error, fmt::format("block {} has no finite position", body.name), {});
    if (scene_.terrains.empty()) add(Severity::error, "there is no terrain to stand on", {});
    if (scene_.bodies.empty()) add(Severity::error, "there are no blocks", {});
    return findings_.size() == before;
  }

  void check_storeys(const Building& building) {
    for (const Storey& storey : building.storeys) {
      const Vec2 place{0.0, storey.base + storey.height};
      if (storey.level_blocks.empty())
        add(Severity::error, fmt::format("storey {} has no block that marks its level", storey.name), place);
      if (!(storey.height > 0.0))
        add(Severity::error, fmt::format("storey {} has a height of {} m", storey.name, storey.height),
            place);
      for (const std::size_t block : storey.storey_blocks)
        if (block >= blocks())
          add(Severity::error, fmt::format("storey {} names block {} of {}", storey.name, block, blocks()),
              place);
    }
  }

  /// What bonds and joints hold to each other.
  void find_links() {
    const auto piece = [&](engine::Owner owner) { return owner.index + (owner.terrain ? blocks() : 0); };
    for (const engine::Bond& bond : scene_.bonds) bonded_.insert(std::minmax(piece(bond.a), piece(bond.b)));
    for (const engine::Joint& joint : scene_.joints)
      if (joint.stiffness > 0.0) jointed_.insert(std::minmax(piece(joint.a), piece(joint.b)));
  }
  bool linked(const Touch& touch) const {
    return bonded_.contains({touch.a, touch.b}) || jointed_.contains({touch.a, touch.b});
  }

  /// Sweep along the direction in which the pieces are spread most: only neighbours are compared.
  void find_touches() {
    const bool tall = spread(&Vec2::y) > spread(&Vec2::x);
    const auto sweep = tall ? &Vec2::y : &Vec2::x, across = tall ? &Vec2::x : &Vec2::y;
    std::vector<std::size_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return pieces_[i].shape.low.*sweep; });
    std::vector<std::size_t> open;
    const double reach = options_.suspicious_gap;
    for (const std::size_t i : order) {
      const PlacedShape& shape = pieces_[i].shape;
      std::erase_if(open,
                    [&](std::size_t j) { return pieces_[j].shape.high.*sweep < shape.low.*sweep - reach; });
      for (const std::size_t j : open) {
        const PlacedShape& other = pieces_[j].shape;
        if (other.high.*across < shape.low.*across - reach || shape.high.*across < other.low.*across - reach)
          continue;
        compare(std::min(i, j), std::max(i, j));
      }
      open.push_back(i);
    }
    std::ranges::sort(touches_, {}, [](const Touch& t) { return std::pair(t.a, t.b); });
  }

  double spread(double Vec2::*axis) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const engine::Body& body : scene_.bodies) {
      low = std::min(low, body.position.*axis);
      high = std::max(high, body.position.*axis);
    }
    return high - low;
  }

  void compare(std::size_t a, std::size_t b) {
    if (a >= blocks()) return;  // terrains may run into each other
    if (!touchable(a) || !touchable(b)) return;
    const Separation between = separation(pieces_[a].shape, pieces_[b].shape, options_.touch_tolerance);
    if (between.gap < options_.suspicious_gap && between.facing)
      touches_.push_back({a, b, between});
    else if (between.gap < -options_.overlap_tolerance)
      touches_.push_back({a, b, between});
  }

  bool touchable(std::size_t i) const { return i >= blocks() || scene_.bodies[i].collides; }

  bool bears(const Touch& touch) const { return std::abs(touch.between.normal.y) > upright; }

  void check_overlaps_and_gaps() {
    for (const Touch& touch : touches_) {
      const double gap = touch.between.gap;
      const Vec2 place = 0.5 * (touch.between.from + touch.between.to);
      if (gap < -options_.overlap_tolerance)
        add(Severity::error,
            fmt::format("{} overlaps {} by {} {}", pieces_[touch.a].name, name_of_other(touch),
                        millimetres(-gap), at(place)),
            place);
      else if (gap > options_.touch_tolerance && bears(touch) && !linked(touch))
        add(Severity::warning,
            fmt::format("{} and {} are {} apart {}: too little to be meant, and it closes with a jolt",
                        pieces_[touch.a].name, name_of_other(touch), millimetres(gap), at(place)),
            place);
    }
  }

  /// "block S1.slab overlaps S1.column": the word block is said once.
  std::string name_of_other(const Touch& touch) const {
    return touch.b < blocks() ? scene_.bodies[touch.b].name : pieces_[touch.b].name;
  }

  /// The lower of the two at a bearing touch: the normal points up from it.
  static std::size_t lower(const Touch& touch) { return touch.between.normal.y > 0.0 ? touch.b : touch.a; }
  static std::size_t upper(const Touch& touch) { return touch.between.normal.y > 0.0 ? touch.a : touch.b; }

  /// What is never reached from the terrains hangs in the air.
  void check_support() {
    std::vector<bool> supported(pieces_.size(), false);
    std::deque<std::size_t> waiting;
    for (std::size_t i = blocks(); i < pieces_.size(); ++i) waiting.push_back(i);
    do spread_upwards(supported, std::move(waiting));
    while (!(waiting = wedged_row(supported)).empty() || !(waiting = hung(supported)).empty());
    for (std::size_t i = 0; i < blocks(); ++i)
      if (!supported[i])
        add(Severity::error,
            fmt::format("{} hangs in the air: nothing below it leads to a terrain {}", pieces_[i].name,
                        at(scene_.bodies[i].position)),
            scene_.bodies[i].position);
  }

  /// Breadth first, from the lower to the upper of every bearing touch, and along bonds.
  void spread_upwards(std::vector<bool>& supported, std::deque<std::size_t> waiting) const {
    std::vector<std::vector<std::size_t>> carried(pieces_.size());
    for (const Touch& touch : touches_)
      if (bears(touch)) carried[lower(touch)].push_back(upper(touch));
    for (const auto& [a, b] : bonded_) carried[a].push_back(b), carried[b].push_back(a);
    while (!waiting.empty()) {
      const std::size_t i = waiting.front();
      waiting.pop_front();
      if (supported[i]) continue;
      supported[i] = true;
      waiting.insert(waiting.end(), carried[i].begin(), carried[i].end());
    }
  }

  /// What a joint holds to something supported. Looked at last: a brace between two voussoirs carries no
  /// arch.
  std::deque<std::size_t> hung(const std::vector<bool>& supported) const {
    std::deque<std::size_t> blocks;
    for (const auto& [a, b] : jointed_)
      if (supported[a] != supported[b]) blocks.push_back(supported[a] ? b : a);
    return blocks;
  }

  /// A row of unsupported blocks that touch over steep joints, as those near the crown of an arch do, and
  /// lean to both sides on something supported below. Empty if there is none.
  std::deque<std::size_t> wedged_row(const std::vector<bool>& supported) const {
    std::vector<bool> seen = supported;
    for (std::size_t i = 0; i < blocks(); ++i) {
      if (seen[i]) continue;
      const std::deque<std::size_t> row = row_of(i, seen);
      if (leans(row, supported, 1.0) && leans(row, supported, -1.0)) return row;
    }
    return {};
  }

  std::deque<std::size_t> row_of(std::size_t first, std::vector<bool>& seen) const {
    std::deque<std::size_t> row{first};
    seen[first] = true;
    for (std::size_t k = 0; k < row.size(); ++k)
      for (const Touch& touch : touches_) {
        if (touch.a != row[k] && touch.b != row[k]) continue;
        const std::size_t other = touch.a == row[k] ? touch.b : touch.a;
        if (other < blocks() && !seen[other]) seen[other] = true, row.push_back(other);
      }
    return row;
  }

  /// Whether something supported pushes a block of the row upwards and to the side of that sign.
  bool leans(const std::deque<std::size_t>& row, const std::vector<bool>& supported, double side) const {
    return std::ranges::any_of(touches_, [&](const Touch& touch) {
      const auto held_by = [&](std::size_t block, std::size_t other, Vec2 push) {
        return supported[other] && push.y > inclined && side * push.x > 0.0 &&
               std::ranges::find(row, block) != row.end();
      };
      const Vec2 n = touch.between.normal;
      return held_by(touch.a, touch.b, n) || held_by(touch.b, touch.a, -1.0 * n);
    });
  }

  void check_balance() {
    constexpr double none = std::numeric_limits<double>::infinity();
    std::vector<double> left(blocks(), none), right(blocks(), -none);
    for (const Touch& touch : touches_) {
      if (!bears(touch) || upper(touch) >= blocks()) continue;
      const auto [low, high] = std::minmax(touch.between.from.x, touch.between.to.x);
      left[upper(touch)] = std::min(left[upper(touch)], low);
      right[upper(touch)] = std::max(right[upper(touch)], high);
    }
    std::set<std::size_t> held;
    for (const auto* links : {&bonded_, &jointed_})
      for (const auto& [a, b] : *links) held.insert({a, b});
    for (std::size_t i = 0; i < blocks(); ++i) {
      if (held.contains(i)) continue;
      const Vec2 centre = scene_.bodies[i].position;
      const double beside = std::max(left[i] - centre.x, centre.x - right[i]);
      if (beside == none || beside <= options_.touch_tolerance) continue;
      if (pushed_back(i, left[i] - centre.x > 0.0 ? 1.0 : -1.0)) continue;
      add(Severity::warning,
          fmt::format(
              "{} has its centre of mass {} beside its support {}: it topples at once unless it is held down",
              pieces_[i].name, millimetres(beside), at(centre)),
          centre);
    }
  }

  /// Whether a neighbour pushes it to the side of that sign, as the next voussoir of an arch does.
  bool pushed_back(std::size_t block, double side) const {
    return std::ranges::any_of(touches_, [&](const Touch& touch) {
      const double push = side * touch.between.normal.x;
      return (touch.a == block && push > upright) || (touch.b == block && -push > upright);
    });
  }

  void check_ratios() {
    check_ratio("mass", Dimension::mass, [&](const engine::Body& body) {
      return body.mass.value_or(
          engine::mass_properties(body.shape, scene_.materials[body.material].density, body.thickness).mass);
    });
    check_ratio("Young's modulus", Dimension::pressure,
                [&](const engine::Body& body) { return scene_.materials[body.material].young_modulus; });
  }

  template <class Quantity>
  void check_ratio(const char* what, Dimension dimension, Quantity quantity) {
    const auto [least, most] = std::ranges::minmax_element(scene_.bodies, {}, quantity);
    const double low = quantity(*least), high = quantity(*most);
    if (!(low > 0.0)) {
      add(Severity::error,
          fmt::format("block {} has a {} of {}", least->name, what, print_value(low, dimension)),
          least->position);
    } else if (high / low > options_.doubtful_ratio) {
      add(high / low > options_.absurd_ratio ? Severity::error : Severity::warning,
          fmt::format("the {} of block {} ({:.3g} SI) is {:.2g} times that of block {} ({:.3g} SI) {}", what,
                      most->name, high, high / low, least->name, low, at(least->position)),
          least->position);
    }
  }

  void check_slivers() {
    for (std::size_t i = 0; i < blocks(); ++i) {
      const engine::Body& body = scene_.bodies[i];
      const double slenderness =
          2.0 * engine::bounding_radius(body.shape) / engine::minimum_width(body.shape);
      if (slenderness <= options_.sliver_ratio) continue;
      add(Severity::warning,
          fmt::format("block {} is a sliver, {:.0f} times as long as wide {}", body.name, slenderness,
                      at(body.position)),
          body.position);
    }
  }

  const engine::Scene& scene_;
  const ModelCheckOptions& options_;
  std::vector<Piece> pieces_;
  std::vector<Touch> touches_;
  std::set<std::pair<std::size_t, std::size_t>> bonded_, jointed_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> check_model(const Building& building, const ModelCheckOptions& options) {
  return Check(building, options).run(building);
}

std::string to_string(Severity severity) {
  return severity == Severity::error ? "error" : "warning";
}

}  // namespace dougong::structures
