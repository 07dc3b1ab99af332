#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "structures/layouts/fittings.h"
#include "structures/layouts/layout.h"

namespace dougong::structures {
namespace {

/// Headings of layouts, how they are counted, and rows of parameters, in order.
std::vector<std::string> facts_of_document() {
  std::ifstream file(std::filesystem::path(__FILE__).parent_path() / "../../docs/layouts.md");
  std::vector<std::string> facts;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("## `") || line.starts_with("| `") || line.starts_with("Storeys: "))
      facts.push_back(line);
  return facts;
}

std::string range_of(const Parameter& p) {
  if (p.is_text()) return "";
  return p.choices.empty() ? fmt::format("{} to {}", print_value(p, p.least), print_value(p, p.most)) : "";
}

std::string row_of(const Parameter& p) {
  return fmt::format("| `{}` | {} | {} | {} | {} |", p.name, kind_of(p), print_value(p, standard_of(p)),
                     range_of(p), p.meaning);
}

bool is_fitting(const Parameter& p) {
  return std::ranges::find(fitting_parameters(), p.name, &Parameter::name) != fitting_parameters().end();
}

std::vector<std::string> facts_of_table() {
  std::vector<std::string> facts;
  for (const Parameter& p : fitting_parameters()) facts.push_back(row_of(p));
  for (const Layout& layout : layouts()) {
    facts.push_back(fmt::format("## `{}`: {}", layout.name, layout.summary));
    facts.push_back("Storeys: " + layout.counting);
    for (const Parameter& p : layout.parameters)
      if (!is_fitting(p)) facts.push_back(row_of(p));
  }
  return facts;
}

TEST(LayoutsDocument, SaysWhatTheTableSays) {
  EXPECT_EQ(facts_of_document(), facts_of_table());
}

}  // namespace
}  // namespace dougong::structures
