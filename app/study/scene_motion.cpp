#include <cmath>

#include "app/study/quantity.h"
#include "app/study/scene_build.h"
#include "seismic/motions/harmonic_motion.h"
#include "seismic/motions/steady_motion.h"
#include "seismic/motions/table_motion.h"

namespace dougong::app {
namespace {

TerrainMotion recorded(const MotionChoice& choice, const std::filesystem::path& records_directory) {
  Scenario scenario;
  scenario.record = choice.record;
  (names_a_file(choice.source) ? scenario.record.file : scenario.record.name) = choice.source;
  scenario.conditioning = choice.conditioning;
  const MotionInput input = make_motion(scenario, records_directory);
  return {input.ground,
          input.conditioned.title,
          input.records.horizontal().provenance.sha256,
          input.conditioned.processing,
          input.conditioned.warnings,
          input.ground->duration()};
}

TerrainMotion tabled(const MotionChoice& choice) {
  seismic::MotionTable table = seismic::read_motion_table(choice.table);
  TerrainMotion motion;
  auto spline = std::make_shared<seismic::TableMotion>(std::move(table.displacements), table.interval);
  motion.duration = spline->duration();
  motion.motion = std::move(spline);
  motion.title = std::filesystem::path(choice.table).filename().string();
  motion.sha256 = table.sha256;
  return motion;
}

TerrainMotion harmonic(const HarmonicChoice& h) {
  const engine::Vec2 direction{std::cos(h.direction), std::sin(h.direction)};
  TerrainMotion motion;
  motion.motion = std::make_shared<seismic::HarmonicMotion>(h.amplitude, h.frequency, direction);
  motion.title = "harmonic acceleration of " + print_quantity(h.amplitude, Dimension::acceleration) + " at " +
                 print_quantity(h.frequency, Dimension::frequency);
  return motion;
}

TerrainMotion steady(engine::Vec2 velocity) {
  TerrainMotion motion;
  motion.motion = std::make_shared<seismic::SteadyMotion>(velocity);
  motion.title = "constant velocity of " + print_quantity(engine::norm(velocity), Dimension::speed);
  return motion;
}

/// Terrains with the same record share its motion.
bool same_motion(const MotionChoice& a, const MotionChoice& b) {
  return !a.source.empty() && a.source == b.source && a.record.component == b.record.component &&
         a.record.station == b.record.station && a.record.member == b.record.member &&
         a.record.response == b.record.response && a.record.vertical == b.record.vertical &&
         a.record.pga == b.record.pga && a.record.scale == b.record.scale &&
         a.record.format == b.record.format && a.record.units == b.record.units &&
         a.record.interval == b.record.interval && a.record.count_scale == b.record.count_scale &&
         a.conditioning.filter == b.conditioning.filter &&
         a.conditioning.high_pass == b.conditioning.high_pass &&
         a.conditioning.low_pass == b.conditioning.low_pass;
}

/// The earlier terrain whose motion this one has; its own index when there is none.
std::size_t first_with_motion_of(const SceneDescription& d, std::size_t i) {
  for (std::size_t k = 0; k < i; ++k)
    if (d.terrains[k].motion && same_motion(*d.terrains[k].motion, *d.terrains[i].motion)) return k;
  return i;
}

}  // namespace

bool names_a_file(const std::string& record) {
  return record.find_first_of("/.") != std::string::npos;
}

TerrainMotion make_terrain_motion(const MotionChoice& choice,
                                  const std::filesystem::path& records_directory) {
  if (!choice.source.empty()) return recorded(choice, records_directory);
  if (!choice.table.empty()) return tabled(choice);
  if (choice.harmonic) return harmonic(*choice.harmonic);
  return steady(choice.velocity.value_or(engine::Vec2{}));
}

std::vector<TerrainMotion> attach_motions(const SceneDescription& description, engine::Scene& scene,
                                          const std::filesystem::path& records_directory) {
  std::vector<TerrainMotion> motions(description.terrains.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& choice = description.terrains[i].motion;
    if (!choice) continue;
    const std::size_t first = first_with_motion_of(description, i);
    motions[i] = first < i ? motions[first] : make_terrain_motion(*choice, records_directory);
    scene.terrains[i].motion = motions[i].motion;
  }
  return motions;
}

}  // namespace dougong::app
