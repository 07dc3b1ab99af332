#include "app/study/code_screens.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "structures/nearest_name.h"

namespace dougong::app {
namespace {

using structures::CodeCheck;
using structures::CodeScreen;
using structures::DriftLimit;
using structures::ScreenRow;

[[noreturn]] void refuse(const std::string& where, const std::string& expected) {
  throw std::invalid_argument(fmt::format("{}: expected {}", where, expected));
}

std::string text_in(const toml::table& table, const char* key, const std::string& where) {
  const auto value = table[key].value<std::string>();
  if (!value || value->empty()) refuse(where, fmt::format("a text \"{}\"", key));
  return *value;
}

std::vector<std::string> texts_in(const toml::table& table, const char* key, const std::string& where) {
  const toml::array* list = table[key].as_array();
  if (!list || list->empty()) refuse(where, fmt::format("a list of texts \"{}\"", key));
  std::vector<std::string> texts;
  for (const toml::node& node : *list) {
    const auto text = node.value<std::string>();
    if (!text) refuse(where, fmt::format("texts in \"{}\"", key));
    texts.push_back(*text);
  }
  return texts;
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// "1/550", "0.02".
double ratio(const std::string& text, const std::string& where) {
  const std::size_t slash = text.find('/');
  const auto above = number(std::string_view(text).substr(0, slash));
  const auto below =
      slash == std::string::npos ? std::optional(1.0) : number(std::string_view(text).substr(slash + 1));
  if (!above || !below || !(*above > 0.0 && *below > 0.0))
    refuse(where, fmt::format("a ratio as \"1/550\", found \"{}\"", text));
  return *above / *below;
}

std::vector<DriftLimit> limits_of(const toml::table& table, const std::string& where) {
  const auto names = texts_in(table, "limits", where), drifts = texts_in(table, "drift", where);
  std::vector<std::string> residuals(names.size());
  if (table.contains("residual")) residuals = texts_in(table, "residual", where);
  if (drifts.size() != names.size() || residuals.size() != names.size())
    refuse(where, "as many numbers as limits");
  std::vector<DriftLimit> limits;
  for (std::size_t i = 0; i < names.size(); ++i) {
    limits.push_back({names[i], ratio(drifts[i], where), {}});
    if (!residuals[i].empty()) limits.back().residual = ratio(residuals[i], where);
  }
  return limits;
}

ScreenRow row_of(const toml::table& table, const std::string& where) {
  ScreenRow row{text_in(table, "subject", where), text_in(table, "clause", where),
                text_in(table, "status", where), texts_in(table, "structures", where),
                limits_of(table, where)};
  for (const std::string& type : row.structures)
    if (type != "any" &&
        std::ranges::find(structures::structural_types(), type) == structures::structural_types().end())
      refuse(where, fmt::format("a structural type, found \"{}\"", type));
  return row;
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list) {
    if (c == ',')
      words.emplace_back();
    else if (c != ' ')
      words.back() += c;
  }
  return words;
}

CodeScreen screen_named(const std::string& id) {
  const auto found = std::ranges::find(code_screens(), id, &CodeScreen::id);
  if (found != code_screens().end()) return *found;
  std::vector<std::string> known;
  for (const CodeScreen& code : code_screens()) known.push_back(code.id);
  const std::string nearest = structures::nearest_name(id, known);
  throw std::invalid_argument(
      fmt::format("expected ids of standards ({}), automatic or none, found \"{}\"{}", fmt::join(known, ", "),
                  id, nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

}  // namespace

CodeScreen read_code_screen(const std::string& text) {
  const toml::table table = toml::parse(text);
  CodeScreen code{text_in(table, "id", "a file of limits"), "", "", "", {}};
  code.standard = text_in(table, "standard", code.id);
  code.edition = text_in(table, "edition", code.id);
  code.note = text_in(table, "note", code.id);
  const toml::array* rows = table["row"].as_array();
  if (!rows) refuse(code.id, "a list [[row]]");
  for (const toml::node& node : *rows) {
    const std::string where = fmt::format("{}, row {}", code.id, code.rows.size() + 1);
    if (!node.is_table()) refuse(where, "a table");
    code.rows.push_back(row_of(*node.as_table(), where));
  }
  return code;
}

const std::vector<CodeScreen>& code_screens() {
  static const std::vector<CodeScreen> screens = [] {
    std::vector<CodeScreen> all;
    for (const std::string_view text : structures::code_screen_texts())
      all.push_back(read_code_screen(std::string(text)));
    std::ranges::sort(all, {}, &CodeScreen::id);
    return all;
  }();
  return screens;
}

std::vector<CodeScreen> chosen_screens(const std::string& codes) {
  if (codes == "automatic") return code_screens();
  std::vector<CodeScreen> chosen;
  if (codes == "none") return chosen;
  for (const std::string& id : words_of(codes)) chosen.push_back(screen_named(id));
  return chosen;
}

ScreeningSheet screening_of(const ScreeningChoice& choice, const structures::Building& building,
                            const structures::Response& response, const structures::Verdict& verdict) {
  ScreeningSheet sheet;
  sheet.structural_type =
      choice.structure == "automatic" ? structures::structural_type_of(building) : choice.structure;
  if (choice.codes == "none") return sheet;
  if (verdict.kind == structures::VerdictKind::numerically_invalid)
    sheet.notes = {"The numbers failed, so no limit was looked at."};
  else if (sheet.structural_type.empty() || sheet.structural_type == "none")
    sheet.notes = {"No standard's drift limits are for this assembly; screening.structure names a type."};
  if (!sheet.notes.empty()) return sheet;
  for (const CodeScreen& code : chosen_screens(choice.codes)) {
    const auto checks = structures::screen(code, sheet.structural_type, response);
    if (checks.empty() && choice.codes == "automatic") continue;
    sheet.notes.push_back(fmt::format("{} ({}): {}{}", code.standard, code.edition, code.note,
                                      checks.empty() ? " It has no row for this type." : ""));
    sheet.checks.insert(sheet.checks.end(), checks.begin(), checks.end());
  }
  return sheet;
}

}  // namespace dougong::app
