// What goes with any layout: isolation under it and dampers in it, functions from a Building to a Building
// with parameters of their own.
#pragma once

#include "structures/layouts/layout.h"

namespace dougong::structures {

/// The parameters of all fittings. They belong to every layout of the table.
const std::vector<Parameter>& fitting_parameters();
Layout with_fittings(Layout layout);
/// The building with what its values ask for. Throws LayoutError where that does not fit.
Building fitted(Building building, const ParameterValues& values);

}  // namespace dougong::structures
