#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

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

std::vector<std::string> facts_of_table() {
  std::vector<std::string> facts;
  for (const Layout& layout : layouts()) {
    facts.push_back(fmt::format("## `{}`: {}", layout.name, layout.summary));
    facts.push_back("Storeys: " + layout.counting);
    for (const Parameter& p : layout.parameters)
      facts.push_back(fmt::format("| `{}` | {} | {} | {} to {} | {} |", p.name, name_of(p.dimension),
                                  print_value(p.standard, p.dimension), print_value(p.least, p.dimension),
                                  print_value(p.most, p.dimension), p.meaning));
  }
  return facts;
}

TEST(LayoutsDocument, SaysWhatTheTableSays) {
  EXPECT_EQ(facts_of_document(), facts_of_table());
}

}  // namespace
}  // namespace dougong::structures
