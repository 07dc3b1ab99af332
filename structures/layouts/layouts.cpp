// The table of layouts: adding one is a file of its own and a line here.
#include "structures/layouts/layout.h"

#include "structures/layouts/arch.h"
#include "structures/layouts/brick_wall.h"
#include "structures/layouts/column.h"
#include "structures/layouts/slab_frame.h"

namespace dougong::structures {

std::span<const Layout> layouts() {
  static const std::vector<Layout> table{
      four_storey(), four_storey_strong(), ten_storey(), brick_wall(), column(), arch(),
  };
  return table;
}

}  // namespace dougong::structures
