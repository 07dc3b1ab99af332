#include "app/report/safe_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace dougong::app {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

/// The error number, or 0 when every byte was taken.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = ::write(descriptor, bytes.data(), bytes.size());
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(taken));
  }
  return 0;
}

int write_new_file(const fs::path& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  const int error = write_all(descriptor, bytes);
  const int close_error = ::close(descriptor) == 0 ? 0 : errno;
  return error != 0 ? error : close_error;
}

fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  name += ".tmp" + std::to_string(::getpid());
  return name;
}

}  // namespace

FileError::FileError(const fs::path& path, const std::string& action, const std::string& reason)
    : std::runtime_error("cannot " + action + " " + path.string() + ": " + reason) {}

void write_file(const fs::path& path, std::string_view bytes) {
  const fs::path temporary = temporary_name(path);
  int error = write_new_file(temporary, bytes);
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  throw FileError(path, "write", reason_of(error));
}

std::string read_file(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw FileError(path, "read", reason_of(errno));
  std::string bytes, piece(1 << 16, '\0');
  ssize_t got = 0;
  while ((got = ::read(descriptor, piece.data(), piece.size())) > 0) {
    bytes.append(piece, 0, static_cast<std::size_t>(got));
  }
  const int error = errno;
  ::close(descriptor);
  if (got < 0) throw FileError(path, "read", reason_of(error));
  return bytes;
}

void make_directory(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && !fs::is_directory(path, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw FileError(path, "make the folder", error.message());
}

TemporaryDirectory::TemporaryDirectory() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  if (error) throw FileError("$TMPDIR", "use the folder for temporary files", error.message());
  std::string name = (parent / "dougong-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw FileError(name, "make the folder", reason_of(errno));
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace dougong::app
