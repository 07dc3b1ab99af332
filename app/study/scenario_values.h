// What one entry of a scenario says, once it is known which key it belongs to. A value of the wrong kind
// throws QuantityError: what was expected, what was found.
#pragma once

#include <string>

#include "app/study/scenario_entries.h"
#include "app/study/scenario_keys.h"

namespace dougong::app {

/// The number in SI. A dimension with units takes text with one, "0.4 g"; on the command line the text
/// may also be a bare count or ratio.
double number_of(const Entry& entry, Dimension dimension);
/// Reads the value into the place the key has in the scenario.
void set_key(const ScenarioKey& key, const Entry& entry, Scenario& scenario);
/// False for an entry that says nothing: empty or "none".
bool is_set(const Entry& entry);

}  // namespace dougong::app
