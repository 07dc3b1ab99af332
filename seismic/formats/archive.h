// Archives of recordings: gzip, tar (plain or compressed) and zip, by libarchive, told by their first bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dougong::seismic {

struct ArchiveMember {
  std::string
      name;  // with its folders; of an archive in an archive "inner.tar.gz/AOM001.EW"; of a bare .gz empty
  std::string bytes;
};

bool is_archive(std::string_view bytes);

/// What an archive may unpack to in all, and how many members it may have: a small file can claim any size.
struct ArchiveLimits {
  std::size_t bytes = std::size_t{1} << 30;
  std::size_t members = 10000;
  int depth = 3;  // of archives in archives
};

/// Every file in the archive, archives among them unpacked too. `name` is the archive's, for messages.
/// Throws InputError for a damaged archive, one that needs a password, and one beyond the limits.
std::vector<ArchiveMember> unpack(std::string_view bytes, const std::string& name,
                                  const ArchiveLimits& limits = {});

}  // namespace dougong::seismic
