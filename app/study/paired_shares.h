// Whether two things that were tried on the same occasions differ in how often something happened to them.
//
//   pairs          second: yes   no          p1 = (both + first)/n     p2 = (both + second)/n
//   first: yes          both    first        d = p2 - p1
//   first: no           second  neither
//
// Interval of 95 % of d: Newcombe, Statistics in Medicine 17 (1998) 2635-2650, method 10: Wilson's intervals
// of p1 and p2, squared and added, with the correlation of the pairs. Test of d = 0: exact and conditional,
// McNemar's: of the pairs that differ, first and second are equally likely.
#pragma once

#include <cstddef>

namespace dougong::app {

struct PairedCounts {
  std::size_t both = 0, first = 0, second = 0, neither = 0;
  std::size_t pairs() const { return both + first + second + neither; }
};

struct PairedShares {
  double difference = 0.0;  // second less first; not a number without pairs
  double low = -1.0, high = 1.0;
  double p_value = 1.0;  // two-sided
};
PairedShares compare_shares(const PairedCounts& counts);

}  // namespace dougong::app
