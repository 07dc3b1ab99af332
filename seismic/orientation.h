// Which way a component points, from the names in use.
#pragma once

#include <optional>
#include <string_view>

#include "seismic/record.h"

namespace dougong::seismic {

/// Degrees clockwise from north, in [0, 360), of the direction that a name calls positive: "N08W", "S74E",
/// "NE"; "90", "360", "067 DEG"; "NS", "E-W", "HNE", "EW2" (north and east positive). Nothing for a vertical
/// component and for names that do not say ("H1", "L").
std::optional<double> azimuth_of(std::string_view component);

/// True when `asked` means this record: the same name in any case, hyphens and sensor digits apart ("EW" for
/// "E-W" and "EW2"), or else a direction within half a degree of its own ("90", "EW" for "HNE").
bool is_component(const Record& record, std::string_view asked);

}  // namespace dougong::seismic
