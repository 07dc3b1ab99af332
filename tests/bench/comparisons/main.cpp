// comparisons CASE [FOLDER [ARGUMENTS]]: prints the table of a case, and draws its figure into the folder as
// PNG.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "tests/bench/comparisons/comparison.h"

namespace dougong::comparisons {

std::string columns(const std::vector<std::vector<double>>& values, std::size_t stride) {
  std::string out;
  for (std::size_t i = 0; i < values.front().size(); i += stride) {
    for (const auto& column : values) out += fmt::format("{:.6g} ", column[i]);
    out += '\n';
  }
  return out;
}

namespace {

struct Case {
  const char* name;
  const char* file;  // of its figure and its page
  Comparison (*run)(const Arguments&);
};

template <Comparison (*without_arguments)()>
Comparison plain(const Arguments&) {
  return without_arguments();
}

constexpr Case cases[] = {
    {"C01", "c01-dry-walls", plain<dry_walls>},
    {"C02", "c02-arch-thickness", plain<arch_thickness>},
    {"C03", "c03-tilting-arch", plain<tilting_arch>},
    {"C04", "c04-drum-column", plain<drum_column>},
    {"C05", "c05-single-degree", single_degree},
    {"C06", "c06-five-storeys", five_storey_frame},
    {"C07", "c07-newmark-tables", plain<newmark_tables>},
    {"C08", "c08-steel-frame", plain<steel_frame>},
    {"M03", "m03-laboratory-frame", plain<laboratory_frame>},
    {"M05", "m05-casks", casks},
    {"C09", "c09-stick-slip", plain<stick_slip>},
    {"M01", "m01-granite-boulder", granite_boulder},
    {"M02", "m02-brick-array", brick_array},
    {"M04", "m04-rocking-restitution", rocking_restitution},
};

int run(const Case& c, const std::filesystem::path& folder, const Arguments& more) {
  const Comparison comparison = c.run(more);
  std::fputs(comparison.table.c_str(), stdout);
  std::ofstream(folder / (c.file + std::string(".png")), std::ios::binary)
      << app::draw(comparison.figure).png;
  return 0;
}

int usage() {
  std::fputs("usage: comparisons CASE [FOLDER [ARGUMENTS]]; cases:", stderr);
  for (const Case& c : cases) std::fprintf(stderr, " %s", c.name);
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace
}  // namespace dougong::comparisons

int main(int count, char** arguments) {
  using namespace dougong::comparisons;
  if (count < 2) return usage();
  try {
    for (const Case& c : cases)
      if (c.name == std::string(arguments[1]))
        return run(c, count > 2 ? arguments[2] : ".", {arguments + std::min(count, 3), arguments + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return usage();
}
