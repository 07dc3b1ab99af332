// The building as a DXF file for other programs: a closed polyline for every block on the layer of its
// storey, terrain on "ground", bonded faces and joints as lines on "bonds" and "joints". Lengths in m. Drawn
// by dxflib as R12, which every reader takes.
#pragma once

#include <string>

#include "app/study/run_result.h"

namespace dougong::app {

/// The file's text. Throws FileError where it cannot be written on its way.
std::string model_dxf(const ModelSheet& model);

}  // namespace dougong::app
