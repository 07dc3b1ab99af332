// Comparison M05: upright spent-fuel casks at North Anna, as one free-standing block of the layout `column`.
//
// Steel and concrete casks of about 115 t, 4.9 m tall on a base of about 2.4 m, on a concrete pad.
#pragma once

#include <filesystem>
#include <string>

#include "app/study/execute.h"

namespace dougong::scenes {

struct CaskMotion {
  structures::VerdictKind verdict;
  double left_behind = 0.0;  // m, where it stands at the end
  double farthest = 0.0;     // m, from where it was
};

/// A shipped record scaled to that peak acceleration, "0.3 g".
inline CaskMotion shaken_cask(const std::string& record, const std::string& pga, double friction,
                              const std::filesystem::path& records) {
  std::vector<app::Override> overrides;
  for (const std::string& word :
       {std::string("layout=column"), std::string("drums=1"), std::string("width=2.4 m"),
        std::string("drum_height=4.9 m"), std::string("density=9783 kg/m3"),
        "friction=" + std::to_string(friction), "record.name=" + record, "pga=" + pga})
    overrides.push_back(app::parse_override(word));
  app::Preparation prepared = app::prepare(app::scenario_from(overrides), records);
  const app::RunResult run = app::execute(prepared, "");
  CaskMotion motion{run.verdict.kind, 0.0, 0.0};
  motion.farthest = std::abs(run.response.peak_roof_displacement.largest().value);
  motion.left_behind = run.response.roof_displacement.back();
  return motion;
}

}  // namespace dougong::scenes
