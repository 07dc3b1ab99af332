#include "seismic/units.h"

#include <cctype>
#include <string>

#include "seismic/numerics/parse_number.h"

namespace dougong::seismic {
namespace {

constexpr double gal = 0.01;  // m/s2

// Lower case without blanks, '^' or the long spelling of seconds: "CM/SEC^2" -> "cm/s2".
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (std::isspace(static_cast<unsigned char>(c)) || c == '^') continue;
    out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (auto at = out.find("sec"); at != std::string::npos; at = out.find("sec")) out.erase(at + 1, 2);
  if (out.ends_with("/s/s")) out.erase(out.size() - 2), out += '2';
  return out;
}

}  // namespace

std::optional<double> acceleration_unit(std::string_view name, double gravity) {
  const std::string unit = plain(name);
  if (unit == "g") return gravity;
  if (unit == "g/10") return gravity / 10.0;
  if (unit == "gal" || unit == "cm/s2") return gal;
  if (unit == "m/s2") return 1.0;
  if (unit == "mm/s2") return 1e-3;
  return std::nullopt;
}

bool is_counts(std::string_view name) {
  const std::string unit = plain(name);
  return unit == "counts" || unit == "count";
}

std::string known_units() {
  return "g, gal, cm/s2, m/s2, mm/s2, g/10 or counts";
}

std::optional<double> parse_count_scale(std::string_view text) {
  std::string spelled = plain(text);
  if (const auto at = spelled.find("(gal)"); at != std::string::npos) spelled.erase(at, 5);
  if (spelled.ends_with("gal")) spelled.resize(spelled.size() - 3);
  const auto slash = spelled.find('/');
  const auto top = parse_number(std::string_view(spelled).substr(0, slash));
  const auto bottom = slash == std::string::npos ? std::optional(1.0)
                                                 : parse_number(std::string_view(spelled).substr(slash + 1));
  if (!top || !bottom || *top <= 0.0 || *bottom <= 0.0) return std::nullopt;
  return *top / *bottom * gal;
}

}  // namespace dougong::seismic
