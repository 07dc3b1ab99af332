// Runs the cases of a plan and keeps of each what is compared. A case that was run before from the same
// inputs is not run again. Cases run in parallel, and the members of each where there are fewer cases than
// threads; the results are the same whatever the order and the number of threads.
#pragma once

#include <functional>

#include "app/study/compare/plan.h"
#include "app/study/ensemble.h"

namespace dougong::app {

/// Of one case. Its members are paired with those of the reference by record and number.
struct ComparedRun {
  std::size_t variant = 0, record = 0;
  View view = View::same_motion;
  double factor = 1.0;  // on the motion
  std::string folder;   // from that of the comparison
  EnsembleSheet sheet;  // the run as described first, alone or with others
};

struct Comparison {
  std::vector<VariantSheet> variants;
  std::vector<std::string> records;
  std::vector<View> views;
  std::vector<ComparedRun> runs;  // in the order of the cases
  bool interrupted = false;       // then some are missing

  /// Null where there is none. In the second view the runs of the first one serve for the reference and for
  /// variants of its period, whose factor is 1.
  const ComparedRun* find(View view, std::size_t variant, std::size_t record) const;
};

/// Where results are kept between runs of the program. Called by one thread at a time.
struct RunStore {
  std::function<bool(const Case&)> has;  // complete, and from the same inputs
  std::function<RunResult(const Case&)> load;
  std::function<void(const Case&, const RunResult&)> save;
};

/// `comparison` has its variants, records and views; its runs are filled. command: kept with the results.
/// Throws as prepare() and as the store does.
void run_cases(Comparison& comparison, const std::vector<Case>& cases, const std::filesystem::path& records,
               std::size_t jobs, const std::string& command, const RunStore& store,
               const EnsembleObserver& progress = {});

}  // namespace dougong::app
