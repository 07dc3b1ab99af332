// The part of JSON Schema that docs/summary.schema.json uses: type, const, enum, properties, required,
// additionalProperties, items and references within the file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace dougong::app {

/// One line a problem, "metrics.drift: expected type number"; empty when the value keeps to the schema.
std::vector<std::string> schema_problems(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace dougong::app
