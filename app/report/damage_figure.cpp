// The damage map: every bonded face where it was, by when it left its elastic range.
#include <algorithm>
#include <cmath>

#include "app/report/block_drawing.h"
#include "app/report/figures.h"
#include "app/report/histories.h"
#include "app/report/text.h"

namespace dougong::app {
namespace {

/// First cracked, yielded or crushed (s).
double damaged_at(const DrawnBond& bond) {
  return std::min(bond.cracked, bond.crushed);
}

DrawingLine face_of(const ModelSheet& model, const DrawnBond& bond, Colour colour) {
  const DrawnShape& owner = bond.owner < model.blocks.size()
                                ? model.blocks[bond.owner]
                                : model.terrains[bond.owner - model.blocks.size()];
  const auto placed = [&](engine::Vec2 local) {
    return owner.position + engine::rotated(local, owner.angle);
  };
  return {placed(bond.start), placed(bond.end), colour};
}

}  // namespace

Figure damage_figure(const RunResult& run) {
  double first = DrawnBond::never, last = 0.0;
  std::vector<const DrawnBond*> damaged;
  BlockDrawing drawing;
  for (const DrawnBond& bond : run.model.bonded) {
    if (bond.mode.empty()) {
      drawing.lines.push_back(face_of(run.model, bond, ink::pale));
      continue;
    }
    damaged.push_back(&bond);
    first = std::min(first, damaged_at(bond)), last = std::max(last, damaged_at(bond));
  }
  // The first on top: where it began must be seen.
  std::ranges::stable_sort(damaged, std::ranges::greater{},
                           [](const DrawnBond* b) { return damaged_at(*b); });
  drawing.title = "When the bonds were damaged";
  drawing.subtitle = run_line(run);
  drawing.fill.assign(run.model.blocks.size(), mixed(ink::white, ink::block, 0.6));
  drawing.scale_title = "s";
  drawing.scale_start = std::floor(first),
  drawing.scale_end = std::max(std::ceil(last), std::floor(first) + 1.0);
  for (const DrawnBond* bond : damaged)
    drawing.lines.push_back(face_of(
        run.model, *bond,
        viridis((damaged_at(*bond) - drawing.scale_start) / (drawing.scale_end - drawing.scale_start))));
  drawing.legend = {"First crack, yield or crushing of every bonded face; pale: none."};
  return block_figure(run.model, drawing);
}

}  // namespace dougong::app
