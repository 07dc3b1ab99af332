#include "app/study/tradeoff/knee.h"

#include <algorithm>

namespace dougong::app {
namespace {

// A finer run that was too dear says nothing against a coarser one; one that failed does.
bool spoils(const JudgedTrial& finer, double target) {
  return finer.completed() ? !(finer.error <= target) : finer.status != TrialStatus::not_run;
}

bool is_within_for_good(const JudgedTrial& trial, double target, const std::vector<JudgedTrial>& trials) {
  if (!trial.completed() || !(trial.error <= target)) return false;
  return std::ranges::none_of(trials, [&](const JudgedTrial& other) {
    return other.way.is_of_series(trial.way) && other.way.coarseness() < trial.way.coarseness() &&
           spoils(other, target);
  });
}

}  // namespace

std::optional<std::size_t> cheapest_within(double target, const std::vector<JudgedTrial>& trials) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (is_within_for_good(trials[i], target, trials) &&
        (!best || trials[i].cpu_per_second() < trials[*best].cpu_per_second()))
      best = i;
  return best;
}

}  // namespace dougong::app
