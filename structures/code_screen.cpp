#include "structures/code_screen.h"

#include <algorithm>
#include <cmath>

#include "code_screens_embedded.h"
#include "structures/layouts/layout.h"

namespace dougong::structures {
namespace {

bool holds_for(const ScreenRow& row, const std::string& type) {
  return std::ranges::any_of(row.structures, [&](const std::string& s) { return s == type || s == "any"; });
}

double peak_of(const Response& response) {
  const StoreyResponse* worst = storey_of_peak_drift(response);
  return worst ? std::abs(worst->peak_drift.largest().value) : 0.0;
}

double residual_of(const Response& response) {
  const StoreyResponse* worst = storey_of_residual_drift(response);
  return worst ? std::abs(worst->residual_drift) : 0.0;
}

bool laid_dry(const Building& building) {
  const auto joints = building.parameters.find("joints");
  return joints != building.parameters.end() && joints->second == "dry";
}

}  // namespace

std::span<const std::string_view> structural_types() {
  static constexpr std::string_view types[] = {
      "rc frame",           "rc frame-wall",        "rc wall", "infilled rc frame",  "steel frame",
      "braced steel frame", "infilled steel frame", "masonry", "reinforced masonry", "timber frame",
      "light wood"};
  return types;
}

std::string structural_type_of(const Building& building) {
  const Layout* layout = known_layout(building.layout);
  return layout && !laid_dry(building) ? layout->structural_type : "";
}

std::vector<CodeCheck> screen(const CodeScreen& code, const std::string& type, const Response& response) {
  const double peak = peak_of(response), residual = residual_of(response);
  const bool lost =
      std::ranges::any_of(response.storeys, [](const auto& s) { return s.lost_at.has_value(); });
  std::vector<CodeCheck> checks;
  for (const ScreenRow& row : code.rows) {
    if (type.empty() || !holds_for(row, type)) continue;
    const auto add = [&](const DriftLimit& l, const char* measure, double limit, double found) {
      checks.push_back({code.standard, row.clause, row.subject, row.status, l.name, measure, limit, found,
                        lost || found > limit});
    };
    for (const DriftLimit& limit : row.limits) {
      add(limit, "peak drift", limit.drift, peak);
      if (limit.residual) add(limit, "residual drift", *limit.residual, residual);
    }
  }
  return checks;
}

std::span<const std::string_view> code_screen_texts() {
  return embedded_code_screens;
}

}  // namespace dougong::structures
