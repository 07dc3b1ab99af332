#include "app/cli/compare_store.h"

#include "app/report/results_file.h"
#include "app/report/safe_file.h"
#include "app/report/summary.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark = "inputs.sha256";

fs::path folder_of(const fs::path& folder, const Case& one) {
  return folder / one.scenario.output.directory;
}

bool has(const fs::path& folder, const std::string& inputs, bool force) {
  std::error_code error;
  if (!fs::exists(folder / mark, error) || !fs::exists(folder / "results.h5", error)) return false;
  if (read_file(folder / mark) == inputs) return true;
  if (force) return false;
  throw FileError(folder, "write the results to",
                  "it holds a run from other inputs or of another version; give --force or another --out");
}

void save(const fs::path& folder, const RunResult& run, const std::string& inputs) {
  make_directory(folder);
  std::error_code ignored;
  fs::remove(folder / mark, ignored);
  write_results(run, folder / "results.h5");
  write_file(folder / "summary.json", summary_json(run, {"summary.json"}));
  write_file(folder / mark, inputs);
}

}  // namespace

RunStore store_in(const fs::path& folder, const fs::path& records, bool force) {
  return {[=](const Case& one) { return has(folder_of(folder, one), inputs_of(one, records), force); },
          [=](const Case& one) { return read_results(folder_of(folder, one) / "results.h5"); },
          [=](const Case& one, const RunResult& run) {
            save(folder_of(folder, one), run, inputs_of(one, records));
          }};
}

}  // namespace dougong::app
