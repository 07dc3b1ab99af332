// The folder of a run's results while there are none yet: made and tried out before a long run, taken
// away again when the run fails before anything was kept.
#pragma once

#include <filesystem>
#include <vector>

namespace dougong::app {

class OutputFolder {
 public:
  /// Throws FileError when it is a file, cannot be written, or holds something and is not forced.
  OutputFolder(std::filesystem::path path, bool force);
  /// Removes the folders that were made, unless something is in them.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The folders that did not exist before, outermost first.
  const std::vector<std::filesystem::path>& made() const { return made_; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;
};

}  // namespace dougong::app
