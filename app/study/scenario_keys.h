// The keys of a scenario: one table that reading, writing, the suggestions for mistyped keys and
// docs/scenario.md all follow. The defaults are those of the Scenario struct.
//
// The parameters of a layout are keys of the section [layout] too; they come from the layout's table.
#pragma once

#include <span>

#include "app/study/key.h"
#include "app/study/scenario.h"

namespace dougong::app {

using ScenarioKey = Key<Scenario>;

std::span<const ScenarioKey> scenario_keys();
const ScenarioKey* find_key(const std::string& name);

}  // namespace dougong::app
