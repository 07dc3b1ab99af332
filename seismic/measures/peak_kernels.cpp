#include "seismic/measures/peak_kernels.h"

#include <cmath>
#include <vector>

#include "seismic/measures/peak_lanes.h"

namespace dougong::seismic {
namespace {

// One oscillator at a time in every vector: for any processor.
struct Plain {
  using Lanes = double;
  static constexpr std::size_t side_by_side = 4;
  static double magnitude(double x) { return std::abs(x); }
  static double larger(double a, double b) { return a < b ? b : a; }
  static void put(double& to, std::size_t, double value) { to = value; }
  static double get(double from, std::size_t) { return from; }
};

std::vector<PeakKernel> find_kernels() {
  std::vector<PeakKernel> kernels{PeakLanes<Plain>::kernel("plain")};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2_peak_kernel());
  if (__builtin_cpu_supports("avx512f")) kernels.push_back(avx512_peak_kernel());
#endif
  return kernels;
}

}  // namespace

std::span<const PeakKernel> supported_peak_kernels() {
  static const std::vector<PeakKernel> kernels = find_kernels();
  return kernels;
}

const PeakKernel& best_peak_kernel() {
  return supported_peak_kernels().back();
}

}  // namespace dougong::seismic
