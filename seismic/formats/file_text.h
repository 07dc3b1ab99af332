// A file as a reader sees it: bytes, their checksum, and lines.
//
// Lines end with LF; carriage returns before it are dropped (CR LF and CR CR LF occur), the last line
// needs no end. Bytes above 127 are kept as they are: headers in GBK and Latin-5 occur. A file is read into
// memory at once and not mapped: a mapped file that another program shortens would end this one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dougong::seismic {

struct FileText {
  std::string name;  // path as given
  std::string bytes;
  std::string sha256;                   // of the bytes, hexadecimal
  std::vector<std::string_view> lines;  // into bytes

  FileText() = default;
  FileText(FileText&&) = delete;  // lines point into bytes
};

/// No recording is larger: a day of a station's three channels at 200 Hz has 150 MiB.
inline constexpr std::size_t largest_file = std::size_t{256} << 20;

/// Throws InputError when the path is no readable, non-empty file of at most largest_file bytes.
std::string read_bytes(const std::filesystem::path& path);

/// Fills `text`. Throws InputError when the path is no readable, non-empty file.
void load_file(const std::filesystem::path& path, FileText& text);

/// Fills `text` from bytes already at hand.
void set_bytes(std::string name, std::string bytes, FileText& text);

/// Hexadecimal SHA-256.
std::string sha256_hex(std::string_view bytes);

std::string_view trimmed(std::string_view text);
std::string upper_case(std::string_view text);

/// The text with every byte that is not printable ASCII as '?', so that it can stand in any report.
std::string printable(std::string_view text);
/// The same between quotation marks.
std::string in_quotes(std::string_view text);

}  // namespace dougong::seismic
