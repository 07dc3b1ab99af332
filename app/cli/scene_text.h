// What a free scene says on the terminal: what it is, before it runs, and its answer.
#pragma once

#include "app/cli/run_text.h"
#include "app/study/scene_run.h"

namespace dougong::app {

/// What is modelled and what not, counts, frequency and step.
std::vector<std::string> scene_text(const PreparedScene& scene);
/// What it will cost; of a prepared scene.
std::string cost_text(const PreparedScene& scene);
std::vector<ToneLine> scene_answer_text(const SceneResult& result);

}  // namespace dougong::app
