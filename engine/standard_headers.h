// What the engine takes from the standard library, for files that change the instruction set after it
// (kernels_avx2.cpp): functions of the library are shared with all other files.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>
