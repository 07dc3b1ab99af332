#include "seismic/formats/sibling_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace dougong::seismic {
namespace {

constexpr std::array<std::array<std::string_view, 4>, 4> groups = {
    {{"EW", "NS", "UD", "UP"}, {"ew", "ns", "ud", "up"}, {"E", "N", "V", "Z"}, {"e", "n", "v", "z"}}};

bool ends_in_azimuth(const std::string& stem) {
  const auto digit = [&](std::size_t back) {
    return std::isdigit(static_cast<unsigned char>(stem[stem.size() - back])) != 0;
  };
  return stem.size() > 3 && digit(1) && digit(2) && digit(3) && !digit(4) &&
         std::stoi(stem.substr(stem.size() - 3)) <= 360;
}

// The directions at right angles, north as 000 and as 360.
std::vector<std::string> across(int azimuth) {
  std::vector<std::string> out;
  for (const int turn : {90, 270}) {
    const int other = (azimuth + turn) % 360;
    out.push_back(fmt::format("{:03}", other));
    if (other == 0) out.push_back("360");
  }
  return out;
}

}  // namespace

std::vector<std::filesystem::path> sibling_names(const std::filesystem::path& path) {
  const std::string stem = path.stem().string(), extension = path.extension().string();
  std::vector<std::filesystem::path> out{path};
  const auto add = [&](const std::string& name) { out.push_back(path.parent_path() / (name + extension)); };
  if (ends_in_azimuth(stem)) {
    const std::string front = stem.substr(0, stem.size() - 3);
    for (const std::string& other : across(std::stoi(stem.substr(stem.size() - 3)))) add(front + other);
    for (const char* up : {"-UP", "-V", "-DWN", "UP", "DWN"}) add(front + up);
    return out;
  }
  for (const std::string own : {"E_W", "N_S", "U_D"}) {
    if (!stem.ends_with("-" + own)) continue;
    for (const std::string other : {"E_W", "N_S", "U_D"})
      if (other != own) add(stem.substr(0, stem.size() - 3) + other);
    return out;
  }
  const auto cut = stem.find_last_of("-_.");
  if (cut == std::string::npos) return out;
  const std::string_view end = std::string_view(stem).substr(cut + 1);
  for (const auto& group : groups) {
    if (std::find(group.begin(), group.end(), end) == group.end()) continue;
    for (const std::string_view other : group)
      if (other != end) add(stem.substr(0, cut + 1) + std::string(other));
  }
  return out;
}

}  // namespace dougong::seismic
