// The table of layouts: adding one is a file of its own and a line here.
#include "structures/layouts/layout.h"

#include "structures/layouts/arch.h"
#include "structures/layouts/arch_on_piers.h"
#include "structures/layouts/brick_wall.h"
#include "structures/layouts/colonnade.h"
#include "structures/layouts/column.h"
#include "structures/layouts/concrete_frame.h"
#include "structures/layouts/dougong_hall.h"
#include "structures/layouts/equipment.h"
#include "structures/layouts/fittings.h"
#include "structures/layouts/masonry_house.h"
#include "structures/layouts/pagoda.h"
#include "structures/layouts/pattern_wall.h"
#include "structures/layouts/rocking_frame.h"
#include "structures/layouts/slab_frame.h"
#include "structures/layouts/timber_frame.h"

namespace dougong::structures {

std::span<const Layout> layouts() {
  static const std::vector<Layout> table = [] {
    std::vector<Layout> rows{
        four_storey(),   four_storey_strong(), ten_storey(),   brick_wall(),    pattern_wall(),
        masonry_house(), concrete_frame(),     timber_frame(), dougong_hall(),  pagoda(),
        column(),        colonnade(),          arch(),         arch_on_piers(), rocking_frame(),
        equipment(),
    };
    for (Layout& row : rows) row = with_fittings(std::move(row));
    return rows;
  }();
  return table;
}

}  // namespace dougong::structures
