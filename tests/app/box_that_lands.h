// A scene of one impact, as a file says it.
#pragma once

#include <string>

namespace dougong::app {

/// A box of rubber that falls a little way on to a floor of rubber.
inline const std::string box_that_lands = R"toml(
[[body]]
name = "box"
shape = "rectangle"
width = "1 m"
height = "1 m"
position = ["0 m", "0.51 m"]
material = "rubber"
[[terrain]]
shape = "half-plane"
material = "rubber"
[solve]
duration = "0.2 s"
)toml";

}  // namespace dougong::app
