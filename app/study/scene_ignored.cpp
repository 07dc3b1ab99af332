#include "app/study/scene_ignored.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "app/study/quantity.h"
#include "app/study/scene_keys.h"
#include "engine/integrators/table.h"
#include "seismic/units.h"

namespace dougong::app {
namespace {

struct KindKey {
  const char* key;
  bool (*given)(const JointChoice&);
  std::array<const char*, 2> kinds;
};

constexpr KindKey keys_of_kinds[] = {
    {"rest_length", [](const JointChoice& j) { return j.rest_length.has_value(); }, {"distance", "spring"}},
    {"rotational_stiffness",
     [](const JointChoice& j) { return j.rotational_stiffness.has_value(); },
     {"weld", "weld"}}};

class Finder {
 public:
  explicit Finder(const SceneDescription& description) : d_(description) {}

  std::vector<SceneProblem> find() {
    each("material_pair", d_.material_pairs, [&](const MaterialPairChoice& p) { check_pair(p); });
    each("terrain", d_.terrains, [&](const TerrainChoice& t) {
      if (t.motion) check_motion(*t.motion);
    });
    each("joint", d_.joints, [&](const JointChoice& j) { check_joint(j); });
    each("bond", d_.bonds, [&](const BondChoice& b) { check_bond(b); });
    check_contact();
    check_settle();
    return std::move(problems_);
  }

 private:
  template <class Choice, class Check>
  void each(const char* section, const std::vector<Choice>& choices, Check check) {
    section_ = section;
    for (index_ = 0; index_ < choices.size(); ++index_) check(choices[index_]);
    index_ = 0;
  }

  void fail(const std::string& key, const std::string& message) {
    problems_.push_back({section_, index_, key, message});
  }

  void check_pair(const MaterialPairChoice& pair) {
    if (!pair.friction && !pair.damping_ratio && !pair.restitution && !pair.rocking_restitution)
      fail("a",
           "expected friction, damping_ratio, restitution or rocking_restitution of the two, found none");
    if (!pairs_.insert(std::minmax(pair.a, pair.b)).second)
      fail("a", fmt::format("there already is a pair of {} and {}", pair.a, pair.b));
  }

  void check_motion(const MotionChoice& motion) {
    check_count_scale(motion.record);
    const std::set<std::string> of_any{"record", "table", "velocity"}, of_filter{"high_pass", "low_pass"};
    for (const Key<MotionChoice>& key : keys_of<MotionChoice>()) {
      if (of_any.contains(key.name) || !is_changed(key, motion)) continue;
      if (motion.source.empty())
        fail("motion." + key.name, "belongs to a record, found a motion without one");
      else if (of_filter.contains(key.name) && !motion.conditioning.filter && is_given(key, motion))
        fail("motion." + key.name, "a corner of the filter, which is switched off (filter = false)");
    }
  }

  void check_count_scale(const RecordChoice& record) {
    if (!record.count_scale.empty() && !seismic::is_counts(record.units))
      fail("motion.count_scale", "needs units = \"counts\"; other files say what a count is");
  }

  void check_joint(const JointChoice& joint) {
    if (joint.kind.empty()) return;
    for (const KindKey& k : keys_of_kinds)
      if (k.given(joint) && std::ranges::find(k.kinds, joint.kind) == k.kinds.end())
        fail(k.key, fmt::format("does not belong to a {}", joint.kind));
  }

  void check_bond(const BondChoice& bond) {
    const bool softens = bond.fracture_energy > 0.0, yields = bond.yield_strength.has_value();
    const auto stress = [](double value) { return print_quantity(value, Dimension::pressure); };
    if (softens && !bond.tensile_strength)
      fail("fracture_energy", "needs a tensile_strength: without one the bond never breaks");
    if (yields && bond.tensile_strength && !(*bond.yield_strength < *bond.tensile_strength))
      fail("yield_strength", fmt::format("expected less than the tensile strength of {}, found {}: it breaks "
                                         "before it yields",
                                         stress(*bond.tensile_strength), stress(*bond.yield_strength)));
    else if (yields && softens)
      fail("fracture_energy", "a bond that yields (yield_strength) stretches and does not soften");
    if (bond.friction != BondChoice{}.friction && !bond.cohesion)
      fail("friction", "needs a cohesion: without one the shear strength is endless");
  }

  void check_contact() {
    section_ = "contact";
    if (d_.solve.integrator == automatic_integrator || !engine::traits_of(d_.solve.integrator).rigid_contacts)
      return;
    for (const Key<engine::ContactOptions>& key : keys_of<engine::ContactOptions>())
      if (is_changed(key, d_.contact))
        fail(key.name, fmt::format("of contact springs, which {} does not have", d_.solve.integrator));
  }

  void check_settle() {
    section_ = "solve";
    if (d_.solve.settle && engine::norm(d_.head.gravity.value_or(engine::Vec2{})) == 0.0)
      fail("settle", "bodies come to rest under gravity, found none");
  }

  template <class Owner>
  static bool is_changed(const Key<Owner>& key, const Owner& owner) {
    return toml_value(key, owner) != default_of(key);
  }
  template <class Owner>
  static bool is_given(const Key<Owner>& key, const Owner& owner) {
    return toml_value(key, owner) != "\"none\"";
  }

  const SceneDescription& d_;
  std::vector<SceneProblem> problems_;
  std::string section_;
  std::size_t index_ = 0;
  std::set<std::pair<std::string, std::string>> pairs_;
};

}  // namespace

std::vector<SceneProblem> ignored_keys(const SceneDescription& description) {
  return Finder(description).find();
}

}  // namespace dougong::app
