// Names of the other components of a station, for formats that keep one component a file and no rule for
// names: "x-EW.at2" lies beside "x-NS.at2" and "x-UD.at2", "..._362-N.AT2" beside -E and -V, "..._GIL067.AT2"
// beside GIL157, GIL337 and GIL-UP. A name without such an end has none.
#pragma once

#include <filesystem>
#include <vector>

namespace dougong::seismic {

std::vector<std::filesystem::path> sibling_names(const std::filesystem::path& path);

}  // namespace dougong::seismic
