// What runs of buildings and of free scenes say alike: their numerics, their settle, where they come from.
#pragma once

#include "app/study/run_result.h"
#include "engine/drive.h"
#include "engine/settle.h"

namespace dougong::app {

Numerics numerics_of(const engine::Model& model, const engine::State& state,
                     const engine::DriveOptions& drive, const engine::RunOutcome& run);
SettleSheet settle_sheet(const engine::SettleReport& report);
/// `text`: the complete scenario or scene; the record's checksum may be empty.
Reproducibility reproducibility_of(const std::string& text, const std::string& record_sha256,
                                   const std::string& command);

/// Energies of the output times as they come.
class EnergyRecorder {
 public:
  void note(const engine::Model& model, const engine::State& state);
  EnergyHistory energy;

 private:
  engine::EnergyTurnover turnover_;
};

/// Overlap of now over the smaller body's least width: the deepest, and the mean of the points that touch.
struct OverlapRatios {
  double deepest = 0.0, mean = 0.0;
};
OverlapRatios overlap_ratios(const engine::ContactPoints& points, std::span<const engine::Frame> frames);

/// A body or terrain as it is drawn, where the scene describes it.
DrawnShape drawn_shape(const engine::Body& body, const engine::Scene& scene);
DrawnShape drawn_shape(const engine::Terrain& terrain, const engine::Scene& scene);
/// The scene's joints and bonds as they are drawn.
void draw_connections(const engine::Scene& scene, ModelSheet& sheet);
/// When each bond cracked, was crushed and broke, as seen at this time. A bond has two points; half broken is
/// cracked.
void note_damage(const engine::Model& model, const engine::State& state, std::vector<DrawnBond>& bonds);
NamedValue material_sheet(const engine::Material& material);

}  // namespace dougong::app
