// Writes the shipped synthetic recordings and their catalogue into a folder.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "seismic/synthesis/shipped.h"

namespace {

void write_into(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const auto& file : dougong::seismic::shipped_files()) {
    const auto path = directory / file.name;
    std::ofstream out(path, std::ios::binary);
    out << file.bytes;
    if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
    fmt::print("{}  {} bytes\n", path.string(), file.bytes.size());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_records <directory>\n");
    return 2;
  }
  try {
    write_into(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "make_records: {}\n", error.what());
    return 1;
  }
  return 0;
}
