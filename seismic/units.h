// Units of acceleration at the border: what one unit of a file is in m/s2.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "seismic/constants.h"

namespace dougong::seismic {

/// m/s2 per unit of "g", "g/10", "gal", "cm/s2", "m/s2" or "mm/s2" (also ^2, cm/s/s, cm/sec2; any
/// case); nothing for a word that is not one of them. Counts have no factor of their own.
std::optional<double> acceleration_unit(std::string_view name, double gravity = standard_gravity);

/// True for "counts" and "count".
bool is_counts(std::string_view name);

/// "g, gal, cm/s2, m/s2, mm/s2, g/10, counts": for messages.
std::string known_units();

/// Scale of an instrument that counts: "3920(gal)/6182761", "3920/6182761" or a bare number, in gal per
/// count, gives m/s2 per count. Nothing when it is not of that form or not positive.
std::optional<double> parse_count_scale(std::string_view text);

}  // namespace dougong::seismic
