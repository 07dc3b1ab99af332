#include "seismic/formats/file_text.h"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>
#include <cctype>
#include <fstream>
#include <system_error>
#include <utility>

#include "seismic/input_error.h"

namespace dougong::seismic {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 20;  // bytes asked for at a time

// Half a gigabyte of them; a file of nothing but line ends would have more.
constexpr std::size_t most_lines = std::size_t{1} << 25;

std::vector<std::string_view> split_lines(std::string_view bytes, const std::string& name) {
  std::vector<std::string_view> lines;
  while (!bytes.empty()) {
    const auto end = bytes.find('\n');
    std::string_view line = bytes.substr(0, end);
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (lines.size() == most_lines)
      throw InputError(name, 0, fmt::format("a recording of at most {} lines", most_lines), "more");
    lines.push_back(line);
    bytes = end == std::string_view::npos ? std::string_view{} : bytes.substr(end + 1);
  }
  return lines;
}

void require_file(const std::filesystem::path& path) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), 0, "a recording", "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(path.string(), 0, "a file", "a directory");
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) {
  require_file(path);
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string(), 0, "a readable file", "one that cannot be opened");
  std::string bytes;
  while (in && bytes.size() <= largest_file) {
    const std::size_t before = bytes.size();
    bytes.resize(before + chunk);
    in.read(bytes.data() + before, static_cast<std::streamsize>(chunk));
    bytes.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(path.string(), 0, "a readable file", "an error while reading it");
  if (bytes.empty()) throw InputError(path.string(), 0, "a recording", "an empty file (zero length)");
  if (bytes.size() > largest_file)
    throw InputError(path.string(), 0, fmt::format("a recording of at most {} MiB", largest_file >> 20),
                     "a larger file");
  return bytes;
}

void load_file(const std::filesystem::path& path, FileText& text) {
  set_bytes(path.string(), read_bytes(path), text);
}

void set_bytes(std::string name, std::string bytes, FileText& text) {
  text.name = std::move(name);
  text.bytes = std::move(bytes);
  text.sha256 = sha256_hex(text.bytes);
  std::string_view content = text.bytes;
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);  // UTF-8 byte order mark
  text.lines = split_lines(content, text.name);
}

std::string sha256_hex(std::string_view bytes) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string hex;
  for (const std::uint8_t byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string upper_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

std::string printable(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c == '\t') c = ' ';
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
  }
  return out;
}

std::string in_quotes(std::string_view text) {
  return fmt::format("\"{}\"", printable(text));
}

}  // namespace dougong::seismic
