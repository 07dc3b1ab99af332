#include "structures/layouts/fittings.h"

#include "structures/layouts/dampers.h"
#include "structures/layouts/isolation.h"
#include "structures/layouts/parts.h"

namespace dougong::structures {

const std::vector<Parameter>& fitting_parameters() {
  static const std::vector<Parameter> table = joined(isolation_parameters(), damper_parameters());
  return table;
}

Layout with_fittings(Layout layout) {
  layout.parameters = joined(std::move(layout.parameters), fitting_parameters());
  return layout;
}

// Dampers first: those of the lowest storey stand on what the building stands on, and go with it.
Building fitted(Building building, const ParameterValues& values) {
  return isolated(damped(std::move(building), values), values);
}

}  // namespace dougong::structures
