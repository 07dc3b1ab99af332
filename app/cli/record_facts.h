// What a file says of a record beyond its measures: where it stood, which way it pointed, when it began, what
// made m/s2 of its numbers.
#pragma once

#include <nlohmann/json.hpp>

#include "seismic/record.h"

namespace dougong::app {

nlohmann::ordered_json facts_json(const seismic::Record& record);

/// The same as lines, under the record's other ones; what the file does not say is left out.
void print_facts(const seismic::Record& record);

}  // namespace dougong::app
