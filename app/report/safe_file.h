// Files that are either whole or absent: written under a temporary name in the same folder, then
// renamed. A full disk or a folder that cannot be written is an error with the path and the reason.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace dougong::app {

class FileError : public std::runtime_error {
 public:
  FileError(const std::filesystem::path& path, const std::string& action, const std::string& reason);
};

void write_file(const std::filesystem::path& path, std::string_view bytes);
std::string read_file(const std::filesystem::path& path);
void make_directory(const std::filesystem::path& path);

/// A private folder, removed with all that is in it at the end of its scope.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace dougong::app
