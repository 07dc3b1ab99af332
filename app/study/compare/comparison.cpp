#include "app/study/compare/comparison.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "app/study/share_tasks.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

ComparedRun compared(const Case& one, const RunResult& result) {
  return {one.variant, one.record, one.view, one.factor, one.scenario.output.directory, result.ensemble};
}

class Cases {
 public:
  Cases(const fs::path& records, const std::string& command, const RunStore& store,
        const EnsembleObserver& progress)
      : records_(records), command_(command), store_(store), progress_(progress) {}

  void run(const std::vector<const Case*>& cases, std::size_t jobs, std::vector<ComparedRun*>& places) {
    for (const Case* one : cases) state_.total += runs_of(one->scenario);
    const std::size_t together = std::min(jobs, std::max<std::size_t>(cases.size(), 1));
    share_tasks(cases.size(), jobs, [&](std::size_t i) { run_one(*cases[i], jobs / together, *places[i]); });
  }
  bool stopped() const { return stopped_; }

 private:
  // Reading records and trying out the cost are not for several threads at once.
  Preparation prepared(const Case& one) {
    const std::lock_guard lock(mutex_);
    return prepare(one.scenario, records_);
  }

  bool go_on(std::size_t done_here = 0) {
    const std::lock_guard lock(mutex_);
    if (progress_ && !progress_({state_.done + done_here, state_.total})) stopped_ = true;
    return !stopped_;
  }

  void run_one(const Case& one, std::size_t jobs, ComparedRun& place) {
    if (stopped_) return;
    Preparation preparation = prepared(one);
    RunResult result = execute(preparation, command_, [&](const Progress&) { return go_on(); });
    if (!stopped_)
      result.ensemble = run_ensemble(preparation, result, jobs, [&](const EnsembleProgress& members) {
        return go_on(members.done + 1);
      });
    const std::lock_guard lock(mutex_);
    if (stopped_) return;
    store_.save(one, result);
    place = compared(one, result);
    state_.done += runs_of(one.scenario);
  }

  const fs::path& records_;
  const std::string& command_;
  const RunStore& store_;
  const EnsembleObserver& progress_;
  EnsembleProgress state_;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
};

}  // namespace

const ComparedRun* Comparison::find(View view, std::size_t variant, std::size_t record) const {
  const bool serves = variants[variant].period == variants.front().period;
  for (const ComparedRun& run : runs)
    if (run.variant == variant && run.record == record &&
        (run.view == view || (run.view == View::same_motion && serves)))
      return &run;
  return nullptr;
}

void run_cases(Comparison& comparison, const std::vector<Case>& cases, const fs::path& records,
               std::size_t jobs, const std::string& command, const RunStore& store,
               const EnsembleObserver& progress) {
  comparison.runs.assign(cases.size(), {});
  std::vector<const Case*> open;
  std::vector<ComparedRun*> places;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (store.has(cases[i])) {
      comparison.runs[i] = compared(cases[i], store.load(cases[i]));
      continue;
    }
    open.push_back(&cases[i]);
    places.push_back(&comparison.runs[i]);
  }
  Cases runner(records, command, store, progress);
  runner.run(open, jobs, places);
  comparison.interrupted = runner.stopped();
}

}  // namespace dougong::app
