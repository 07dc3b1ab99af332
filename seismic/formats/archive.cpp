#include "seismic/formats/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "seismic/formats/file_text.h"
#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

struct Closer {
  void operator()(archive* opened) const { archive_read_free(opened); }
};
using Opened = std::unique_ptr<archive, Closer>;

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

[[noreturn]] void refuse(const std::string& name, archive* opened) {
  const char* reason = archive_error_string(opened);
  throw InputError(name, 0, "an archive that can be unpacked", reason ? printable(reason) : "a damaged one");
}

Opened open(std::string_view bytes, const std::string& name) {
  Opened opened(archive_read_new());
  archive_read_support_filter_gzip(opened.get());
  archive_read_support_format_tar(opened.get());
  archive_read_support_format_zip(opened.get());
  // Whatever gzip holds that is no tar: one file, under no name.
  if (is_gzip(bytes)) archive_read_support_format_raw(opened.get());
  if (archive_read_open_memory(opened.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    refuse(name, opened.get());
  return opened;
}

class Unpacking {
 public:
  Unpacking(std::string name, const ArchiveLimits& limits) : name_(std::move(name)), limits_(limits) {}

  void take(std::string_view bytes, const std::string& prefix, int depth) {
    const Opened opened = open(bytes, name_);
    archive_entry* entry = nullptr;
    while (true) {
      const int status = archive_read_next_header(opened.get(), &entry);
      if (status == ARCHIVE_EOF) return;
      if (status != ARCHIVE_OK && status != ARCHIVE_WARN) refuse(name_, opened.get());
      if (archive_entry_filetype(entry) != AE_IFREG && archive_format(opened.get()) != ARCHIVE_FORMAT_RAW)
        continue;
      keep(prefix + name_of(opened.get(), entry), contents(opened.get()), depth);
    }
  }

  std::vector<ArchiveMember> members;

 private:
  static std::string name_of(archive* opened, archive_entry* entry) {
    const char* name = archive_entry_pathname(entry);
    const bool bare = archive_format(opened) == ARCHIVE_FORMAT_RAW;
    return bare ? std::string{} : printable(name ? name : "?");
  }

  std::string contents(archive* opened) {
    std::string bytes;
    std::array<char, 65536> piece{};
    while (true) {
      const la_ssize_t read = archive_read_data(opened, piece.data(), piece.size());
      if (read == 0) return bytes;
      if (read < 0) refuse(name_, opened);
      taken_ += static_cast<std::size_t>(read);
      if (taken_ > limits_.bytes)
        throw InputError(name_, 0, fmt::format("an archive of at most {} bytes unpacked", limits_.bytes),
                         "more");
      bytes.append(piece.data(), static_cast<std::size_t>(read));
    }
  }

  void keep(std::string name, std::string bytes, int depth) {
    if (is_archive(bytes)) {
      if (depth >= limits_.depth)
        throw InputError(name_, 0, fmt::format("archives in archives at most {} deep", limits_.depth),
                         "deeper");
      return take(bytes, name.empty() ? name : name + "/", depth + 1);
    }
    if (members.size() >= limits_.members)
      throw InputError(name_, 0, fmt::format("an archive of at most {} files", limits_.members), "more");
    members.push_back({std::move(name), std::move(bytes)});
  }

  std::string name_;
  ArchiveLimits limits_;
  std::size_t taken_ = 0;
};

}  // namespace

bool is_archive(std::string_view bytes) {
  constexpr std::size_t magic_of_tar = 257;
  const bool tar = bytes.size() > 512 && bytes.substr(magic_of_tar, 5) == "ustar";
  return is_gzip(bytes) || bytes.starts_with("PK\x03\x04") || tar;
}

std::vector<ArchiveMember> unpack(std::string_view bytes, const std::string& name,
                                  const ArchiveLimits& limits) {
  Unpacking unpacking(name, limits);
  unpacking.take(bytes, "", 1);
  return std::move(unpacking.members);
}

}  // namespace dougong::seismic
