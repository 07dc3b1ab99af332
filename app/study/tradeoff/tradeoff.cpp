#include "app/study/tradeoff/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/integrators/table.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

// A reference is finer than the finest rung and worth waiting for.
constexpr double budget_of_references = 10.0;

/// A scene of one stiffness and what is run with it.
struct Variant {
  double stiffness = 1.0;
  PreparedScene scene;
  std::vector<Way> ways;
};

PreparedScene prepared(const SceneDescription& description, const fs::path& records) {
  SceneDescription own = description;
  static_cast<IntegrationChoice&>(own.solve) = {};
  return prepare_scene(own, records);
}

class Comparison {
 public:
  Comparison(const SceneDescription& description, const fs::path& records, const TradeoffChoice& choice,
             const TradeoffObserver& progress)
      : progress_(progress) {
    out_.choice = choice;
    out_.title = description.head.title;
    prepare(description, records);
  }

  Tradeoff run() {
    find_reference();
    find_spread();
    for (const Variant& variant : variants_) climb(variant);
    return std::move(out_);
  }

 private:
  // --- what will be run ------------------------------------------------------------------------------

  void prepare(const SceneDescription& description, const fs::path& records) {
    variants_.push_back({1.0, prepared(description, records), {}});
    yardstick_ = yardstick_for(own_scene().model, out_.choice.measure, out_.choice.bodies);
    LadderChoice& ladder = out_.choice.ladder;
    if (ladder.integrators.empty()) note_left_out(own_scene().model);
    ladder = completed(ladder, own_scene());
    for (const double stiffness : ladder.stiffnesses)
      if (stiffness != 1.0) add_variant(stiffness, description, records);
    for (Variant& variant : variants_) variant.ways = ladder_of(ladder, variant.stiffness, variant.scene);
    add_own_way(integrated_by(own_scene(), description.solve));
    count_runs();
  }

  const PreparedScene& own_scene() const { return variants_.front().scene; }

  void add_variant(double stiffness, const SceneDescription& description, const fs::path& records) {
    PreparedScene scene = prepared(with_stiffness(description, own_scene().scene, stiffness), records);
    variants_.push_back({stiffness, std::move(scene), {}});
  }

  void note_left_out(const engine::Model& model) {
    for (const std::string& name : integrator_choices()) {
      if (name == automatic_integrator) continue;
      const std::string reason = does_not_apply(name, model);
      if (!reason.empty()) out_.left_out.push_back(name + ": " + reason);
    }
  }

  void add_own_way(const PreparedScene& as_asked) {
    own_ = own_way(as_asked);
    auto& ways = variants_.front().ways;
    if (std::ranges::find(ways, own_) == ways.end()) ways.insert(ways.begin(), own_);
  }

  void count_runs() {
    at_.total = 2 * reference_ways().size() + out_.choice.members + 2 * (variants_.size() - 1);
    for (const Variant& variant : variants_) at_.total += variant.ways.size();
    if (has_rigid_ways(variants_.front())) at_.total += 2;
  }

  std::vector<Way> reference_ways() const {
    return reference_candidates(out_.choice.ladder, 1.0, own_scene());
  }

  static bool has_rigid_ways(const Variant& variant) {
    return std::ranges::any_of(variant.ways, [](const Way& way) { return way.stiffness == rigid; });
  }

  // --- limits and progress ---------------------------------------------------------------------------

  TrialLimits limits(double budget, const std::string& now) {
    at_.now = now;
    return {budget, [this](double part) {
              at_.part = part;
              if (progress_ && !progress_(at_)) out_.interrupted = true;
              return !out_.interrupted;
            }};
  }
  TrialLimits reference_limits(const std::string& now) {
    return limits(budget_of_references * out_.choice.budget, now);
  }

  // --- the references and the ensemble ---------------------------------------------------------------

  void find_reference() {
    const PreparedScene& scene = own_scene();
    Reference reference =
        make_reference(reference_ways(), scene, yardstick_, reference_limits("the reference"));
    at_.done += 2 * reference_ways().size();
    if (!reference.run.completed())
      throw NoReference(fmt::format("there is no reference to measure errors by: {}, {}: {}",
                                    reference.run.way.solve.integrator, control_text(reference.run.way),
                                    reference.run.reason));
    out_.duration = reference.run.simulated;
    out_.motion = largest_way(yardstick_, reference.run.trajectory);
    if (!(out_.motion > 0.0))
      throw std::invalid_argument("expected a scene that moves, found one that stays where it is");
    unperturbed_ = std::move(reference.coarser);
    out_.models.push_back({1.0, std::move(reference.run), reference.difference / out_.motion, 0.0});
  }

  void find_spread() {
    const double speed = greatest_speed(yardstick_, unperturbed_.trajectory);
    out_.ensemble = make_ensemble(out_.choice.members, unperturbed_, speed, own_scene(), yardstick_,
                                  reference_limits("the ensemble"));
    at_.done += out_.choice.members;
  }

  // The reference of another stiffness is that of the scene, but for the stiffness.
  void add_model(double stiffness, const PreparedScene& scene) {
    Way way = out_.models.front().reference.way;
    way.stiffness = stiffness;
    const std::vector<Way> ways =
        stiffness == rigid ? reference_candidates(out_.choice.ladder, rigid, scene) : std::vector<Way>{way};
    Reference reference = make_reference(
        ways, scene, yardstick_, reference_limits("the reference, stiffness " + stiffness_text(stiffness)));
    at_.done += 2;
    const double error = distance(yardstick_, reference.run.trajectory, own_trajectory()) / out_.motion;
    out_.models.push_back({stiffness, std::move(reference.run), reference.difference / out_.motion, error});
  }

  const structures::Trajectory& own_trajectory() const { return out_.models.front().reference.trajectory; }

  // --- the ladder ------------------------------------------------------------------------------------

  void climb(const Variant& variant) {
    if (variant.stiffness != 1.0) add_model(variant.stiffness, variant.scene);
    if (has_rigid_ways(variant)) add_model(rigid, variant.scene);
    for (const Way& way : variant.ways) {
      if (way == own_) out_.own = out_.trials.size();
      add(attempt(variant.scene, way, limits(out_.choice.budget, text_of(way)), predicted(way)));
      ++at_.done;
    }
  }

  static std::string text_of(const Way& way) {
    std::string text = way.solve.integrator + ", " + control_text(way);
    return way.stiffness == 1.0 ? text : text + ", stiffness " + stiffness_text(way.stiffness);
  }

  // From the coarser rung before it: as many times the steps; a finer tolerance costs at least as much.
  double predicted(const Way& way) const {
    if (out_.trials.empty() || !out_.trials.back().way.is_of_series(way)) return 0.0;
    const Trial& before = out_.trials.back();
    return before.cpu * (way.solve.tolerance ? 1.0 : before.way.coarseness() / way.coarseness());
  }

  void add(Trial trial) {
    const auto& own_model = *std::ranges::find(out_.models, trial.way.stiffness, &TradeoffModel::stiffness);
    JudgedTrial judged{std::move(trial)};
    if (judged.completed()) {
      judged.error = distance(yardstick_, judged.trajectory, own_trajectory()) / out_.motion;
      judged.numerical =
          distance(yardstick_, judged.trajectory, own_model.reference.trajectory) / out_.motion;
    }
    judged.trajectory = {};
    out_.trials.push_back(std::move(judged));
  }

  const TradeoffObserver& progress_;
  std::vector<Variant> variants_;
  Yardstick yardstick_;
  Way own_;
  Trial unperturbed_;
  TradeoffProgress at_;
  Tradeoff out_;
};

}  // namespace

bool Tradeoff::chaotic() const {
  constexpr double parted = 1e3;
  return spread() > parted * ensemble.perturbation;
}

double Tradeoff::least_known() const {
  return std::max(resolution(), chaotic() ? 2.0 * spread() : 0.0);
}

std::optional<std::size_t> Tradeoff::ten_times_better() const {
  const double wanted = 0.1 * target();
  return wanted < least_known() ? std::nullopt : cheapest_within(wanted, trials);
}

Tradeoff run_tradeoff(const SceneDescription& description, const fs::path& records_directory,
                      const TradeoffChoice& choice, const TradeoffObserver& progress) {
  return Comparison(description, records_directory, choice, progress).run();
}

}  // namespace dougong::app
