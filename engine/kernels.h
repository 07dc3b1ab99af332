// The hot loops, compiled for several instruction sets, of which the machine's best is taken. All give the
// same bits, sums included (docs/decisions/0002-bitwise-reproducible.md).
#pragma once

#include <cstddef>
#include <span>

#include "engine/contact/pair_watch.h"
#include "engine/contact/point_blocks.h"
#include "engine/frame.h"

namespace dougong::engine {

/// Arguments of the forces of all corner-edge points: as contact_forces(), four loads a block. Round points
/// are left as they are.
struct CornerEdgeCall {
  PointBlock* blocks;
  std::size_t first, last;  // of the blocks, those from `first` to before `last`
  std::size_t points;       // in all blocks; slots behind are empty
  const Frame* frames;
  bool commit;
  PairLoad* loads;    // of all blocks
  double time, step;  // s
};

struct Kernels {
  const char* name;
  void (*corner_edge_forces)(const CornerEdgeCall& call, ContactTotals& totals);
  /// As place_bodies(): of n bodies those from `first` to before `last`.
  void (*place_bodies)(const double* q, const double* v, std::size_t n, std::size_t first, std::size_t last,
                       Frame* frames);
  /// Finds PairWatch::moved of all their pairs.
  void (*measure_motions)(PairWatch* watches, std::size_t count, const Frame* frames);
};

/// All that this machine can run, the plainest first.
std::span<const Kernels> supported_kernels();
const Kernels& best_kernels();

// For machines that have these instructions.
Kernels avx2_kernels();
Kernels avx512_kernels();

}  // namespace dougong::engine
