#include "app/cli/tradeoff_text.h"

#include <fmt/format.h>

#include "app/report/text.h"

namespace dougong::app {
namespace {

std::string percent(double error) {
  return significant(100.0 * error, 2) + " %";
}

std::string way_text(const Way& way) {
  const std::string text = way.solve.integrator + ", " + control_text(way);
  return way.stiffness == 1.0 || way.stiffness == rigid
             ? text
             : text + ", contacts " + stiffness_text(way.stiffness) + " as stiff";
}

std::string run_text(const JudgedTrial& trial) {
  return fmt::format("{}: error {}, {} s of processor time per simulated second", way_text(trial.way),
                     percent(trial.error), significant(trial.cpu_per_second(), 2));
}

std::string reference_text(const Tradeoff& t) {
  const Trial& reference = t.models.front().reference;
  return fmt::format("{}, {:.3g} s of processor time; resolves {} (against a coarser one)",
                     way_text(reference.way), reference.cpu, percent(t.resolution()));
}

std::string ensemble_text(const Tradeoff& t) {
  const Ensemble& e = t.ensemble;
  if (e.differences.empty())
    return e.failed > 0 ? "none of its runs completed"
                        : "none was asked for: whether the motion is chaotic is open";
  const std::string failed = e.failed > 0 ? fmt::format("; {} more failed", e.failed) : "";
  return fmt::format("{} runs that began within {:.0e} end {} apart: {}{}", e.differences.size(),
                     e.perturbation, percent(t.spread()),
                     t.chaotic() ? "chaotic, less error than that buys nothing" : "not chaotic", failed);
}

std::string model_text(const TradeoffModel& model) {
  if (!model.reference.completed()) return "no reference: " + model.reference.reason;
  return fmt::format("contacts {}: another model, {} from the scene's", stiffness_text(model.stiffness),
                     percent(model.error));
}

std::string table_line(const JudgedTrial& t, const char* mark) {
  const std::string start = fmt::format("{:1} {:<16} {:<12} {:<18}", mark, t.way.solve.integrator,
                                        stiffness_text(t.way.stiffness), control_text(t.way));
  if (!t.completed()) return fmt::format("{} {}: {}", start, to_string(t.status), t.reason);
  return fmt::format("{} {:>9.2e} {:>9.1e} {:>10.1e} {:>11}", start, t.cpu_per_second(), t.error, t.numerical,
                     t.evaluations);
}

std::string cheaper_text(const Tradeoff& t, const JudgedTrial& best) {
  const double ratio = t.trials[t.own].cpu_per_second() / best.cpu_per_second();
  if (ratio > 1.05) return fmt::format(", {:.2g} times the cost of the recommended", ratio);
  return ratio < 0.95 ? fmt::format(", {:.2g} of the cost of the recommended", ratio) : "";
}

std::string own_text(const Tradeoff& t, const JudgedTrial* best) {
  const JudgedTrial& own = t.trials[t.own];
  if (!own.completed())
    return fmt::format("As it stands: {}: {}: {}.", way_text(own.way), to_string(own.status), own.reason);
  return "As it stands: " + run_text(own) + (best ? cheaper_text(t, *best) : "") + ".";
}

std::string finer_text(const Tradeoff& t, const JudgedTrial& best) {
  const double wanted = 0.1 * t.target();
  if (wanted < t.least_known())
    return fmt::format("Ten times less error cannot be told here: {} is the limit.",
                       percent(t.least_known()));
  const auto finer = t.ten_times_better();
  if (!finer) return fmt::format("Ten times less error ({}): no run of this ladder has it.", percent(wanted));
  if (*finer == *t.recommended()) return "Ten times less error: that run has it already.";
  return fmt::format("Ten times less error: {}, {:.2g} times the cost.", run_text(t.trials[*finer]),
                     t.trials[*finer].cpu_per_second() / best.cpu_per_second());
}

std::string parts_text(const JudgedTrial& best) {
  return best.way.stiffness == 1.0 ? "" : fmt::format(" (of it {} by the steps)", percent(best.numerical));
}

}  // namespace

std::vector<ToneLine> tradeoff_basis_text(const Tradeoff& t) {
  std::vector<ToneLine> lines{
      {row("motion", fmt::format("{} s, the largest way {}", significant(t.duration, 3), length(t.motion)))},
      {row("reference", reference_text(t))},
      {row("ensemble", ensemble_text(t)), t.chaotic() ? Tone::doubtful : Tone::plain}};
  for (std::size_t i = 1; i < t.models.size(); ++i)
    lines.push_back({row("stiffness", model_text(t.models[i]))});
  for (const std::string& text : t.left_out) lines.push_back({row("left out", text)});
  return lines;
}

std::vector<ToneLine> tradeoff_table(const Tradeoff& t) {
  std::vector<ToneLine> lines{
      {fmt::format("{:2}{:<16} {:<12} {:<18} {:>9} {:>9} {:>10} {:>11}", "", "integrator", "contacts", "step",
                   "s/s", "error", "numerical", "evaluations"),
       Tone::faint}};
  const auto best = t.recommended();
  for (std::size_t i = 0; i < t.trials.size(); ++i) {
    const bool fine = t.trials[i].completed();
    lines.push_back({table_line(t.trials[i], best == i ? ">" : ""), fine ? Tone::plain : Tone::bad});
  }
  return lines;
}

std::vector<ToneLine> tradeoff_answer_text(const Tradeoff& t) {
  const auto index = t.recommended();
  if (!index)
    return {{fmt::format("No run is within {}, and stays within it when refined.", percent(t.target())),
             Tone::doubtful},
            {own_text(t, nullptr)}};
  const JudgedTrial& best = t.trials[*index];
  std::vector<ToneLine> lines{
      {fmt::format("Recommended, within {}: {}{}.", percent(t.target()), run_text(best), parts_text(best)),
       Tone::good}};
  if (*index != t.own) lines.push_back({own_text(t, &best)});
  lines.push_back({finer_text(t, best)});
  return lines;
}

}  // namespace dougong::app
