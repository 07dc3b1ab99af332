// All kernels for R at once, compiled for the instruction set of the file that includes this.
#pragma once

#include "engine/contact/kernel_lanes.h"
#include "engine/contact/watch_lanes.h"
#include "engine/frame_lanes.h"

namespace dougong::engine {
namespace {

template <class R>
Kernels kernels_with(const char* name) {
  return {name, [](const CornerEdgeCall& call, ContactTotals& totals) { evaluate_all<R>(call, totals); },
          [](const double* q, const double* v, std::size_t n, std::size_t first, std::size_t last,
             Frame* frames) { place_bodies_by<R>(q, v, n, first, last, frames); },
          [](PairWatch* watches, std::size_t count, const Frame* frames) {
            measure_motions<R>(watches, count, frames);
          }};
}

}  // namespace
}  // namespace dougong::engine
