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

enum class Against { first, before };

/// As Markdown: the costs, and how many times that of the first, or of the one before, each is.
inline void print_table(const std::vector<Contestant>& contestants, const char* heading, Against against) {
  std::printf("| %s | us per step | of the %s |\n|---|---|---|\n", heading,
              against == Against::first ? "first" : "one before");
  const Contestant* reference = &contestants.front();
  for (const Contestant& c : contestants) {
    std::printf("| %s | %.4g | %.3f |\n", c.name.c_str(), c.least, c.least / reference->least);
    if (against == Against::before) reference = &c;
  }
}

}  // namespace dougong::bench
