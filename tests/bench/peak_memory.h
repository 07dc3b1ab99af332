// The most memory that this process has had, whatever it did before.
#pragma once

#include <sys/resource.h>

namespace dougong::bench {

inline double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace dougong::bench
