// make_corpus <directory>: seeds for the fuzz targets, a folder for each format.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "seismic/formats/file_text.h"
#include "tests/seismic/generated_files.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

// The first lines of a shipped record: long files make a slow corpus.
std::string beginning(const std::string& bytes) {
  constexpr std::size_t enough = 20000;
  return bytes.substr(0, bytes.find('\n', std::min(enough, bytes.size())));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "make_corpus <directory>\n", 2;
  const fs::path root = argv[1];
  int number = 0;
  for (const auto& file : dougong::seismic::testing::generated_files()) {
    const std::string name = "generated-" + std::to_string(number++);
    write(root / file.format / name, file.bytes);
    write(root / "any" / name, file.bytes);
  }
  for (const auto& entry : fs::directory_iterator(DOUGONG_RECORDS_DIRECTORY)) {
    const bool at2 = entry.path().extension() == ".at2";
    if (!at2 && entry.path().extension() == ".json") continue;
    write(root / (at2 ? "peer-at2" : "knet") / entry.path().filename(),
          beginning(dougong::seismic::read_bytes(entry.path())));
  }
  write(root / "volume-3" / "spectra", "RESPONSE AND FOURIER AMPLITUDE SPECTRA\n");
  write(root / "archive" / "empty.gz", std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03\x03\0\0\0\0\0\0\0\0\0", 20));
}
