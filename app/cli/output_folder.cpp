#include "app/cli/output_folder.h"

#include <algorithm>
#include <ranges>

#include "app/report/safe_file.h"

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> missing_folders(fs::path path) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (; !path.empty() && !fs::exists(path, error); path = path.parent_path()) {
    if (path.has_filename()) missing.push_back(path);
    if (path == path.parent_path()) break;
  }
  std::ranges::reverse(missing);
  return missing;
}

void refuse_what_is_there(const fs::path& path, bool force) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (!fs::is_directory(path, error))
    throw FileError(path, "write the results to", "it is a file, not a folder");
  if (!force && !fs::is_empty(path, error))
    throw FileError(path, "write the results to",
                    "the folder exists and is not empty; give --force or another --out");
}

void remove_empty(const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (const fs::path& folder : std::views::reverse(folders)) fs::remove(folder, ignored);
}

// A file comes and goes: what a run of an hour would find out at its end.
void try_writing(const fs::path& folder) {
  const fs::path probe = folder / ".dougong-probe";
  write_file(probe, "x");
  std::error_code ignored;
  fs::remove(probe, ignored);
}

}  // namespace

OutputFolder::OutputFolder(fs::path path, bool force)
    : path_(std::move(path)), made_(missing_folders(path_)) {
  refuse_what_is_there(path_, force);
  try {
    make_directory(path_);
    try_writing(path_);
  } catch (...) {
    remove_empty(made_);
    throw;
  }
}

OutputFolder::~OutputFolder() {
  remove_empty(made_);
}

}  // namespace dougong::app
