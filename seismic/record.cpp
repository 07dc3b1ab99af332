#include "seismic/record.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace dougong::seismic {

Axis axis_of(std::string_view component) {
  std::string name;
  for (const char c : component) {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  constexpr std::array vertical = {"UD", "DU", "UP", "DOWN", "DWN", "V", "VER", "VERT", "VERTICAL", "Z", "U"};
  const bool channel = name.size() == 3 && name[2] == 'Z';  // SEED: HNZ, BNZ ...
  const bool named = std::find(vertical.begin(), vertical.end(), name) != vertical.end();
  return channel || named ? Axis::vertical : Axis::horizontal;
}

}  // namespace dougong::seismic
