// Costs that are compared with each other: measured in turn, round by round, the least of every one kept. A
// machine that others use is then as slow for all of them.
#pragma once

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace dougong::bench {

struct Contestant {
  std::string name;
  std::function<double()> cost;  // measures it once (us)
  double least = std::numeric_limits<double>::infinity();
};

inline void alternate(std::vector<Contestant>& contestants, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (Contestant& c : contestants) c.least = std::min(c.least, c.cost());
}

/// As Markdown, each against the first.
inline void print_table(const std::vector<Contestant>& contestants, const char* heading) {
  std::printf("| %s | us per step | of the first |\n|---|---|---|\n", heading);
  for (const Contestant& c : contestants)
    std::printf("| %s | %.4g | %.3f |\n", c.name.c_str(), c.least, c.least / contestants.front().least);
}

}  // namespace dougong::bench
