// fuzz [COUNT [FIRST]]: runs as many random scenes, and says of each that fails its seed and why; then the
// worst of all. The scenes and what must hold of them are those of test_engine (tests/scenes/fuzz.h).
#include <cstdio>
#include <cstdlib>

#include "tests/scenes/fuzz.h"

namespace {

std::uint64_t number(int count, char** arguments, int i, std::uint64_t otherwise) {
  return i < count ? std::strtoull(arguments[i], nullptr, 10) : otherwise;
}

}  // namespace

int main(int count, char** arguments) {
  using namespace dougong;
  const std::uint64_t scenes = number(count, arguments, 1, 10000), first = number(count, arguments, 2, 1);
  scenes::FuzzWorst worst;
  std::size_t failed = 0;
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) {
    const auto f = scenes::fuzz_one(seed);
    worst.note(f);
    failed += f.faults.empty() ? 0 : 1;
    for (const std::string& fault : f.faults)
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), fault.c_str());
  }
  std::printf("%llu scenes, %zu failed; %s\n", static_cast<unsigned long long>(scenes), failed,
              worst.text().c_str());
  return failed == 0 ? 0 : 1;
}
