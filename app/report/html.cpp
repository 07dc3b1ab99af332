#include "app/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/report/text.h"

namespace dougong::app {
namespace {

constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string heading_cell(const Heading& h) {
  const std::string unit = h.unit.empty() ? "" : "<span class=\"unit\">" + escape_markup(h.unit) + "</span>";
  return fmt::format("<th scope=\"col\"{}>{}{}</th>", h.number ? " class=\"n\"" : "", escape_markup(h.name),
                     unit);
}

/// Hashes, paths and commands may break anywhere; words may not.
bool has_long_word(const std::string& value) {
  constexpr std::size_t longest = 24;  // letters of a word
  std::size_t letters = 0;
  return std::ranges::any_of(value, [&](char c) { return (letters = c == ' ' ? 0 : letters + 1) > longest; });
}

/// A sentence needs some width; "100 MN/m" stays on one line.
const char* style_of(const std::string& value) {
  constexpr std::size_t one_line = 12, words = 24;  // letters of a cell
  if (has_long_word(value)) return "wide long";
  return value.size() > words ? "wide words" : value.size() <= one_line ? "wide short" : "wide";
}

std::string cell(const Heading& h, const std::string& value, bool first) {
  if (first) return "<th scope=\"row\">" + escape_markup(typeset(value)) + "</th>";
  return fmt::format("<td class=\"{}\">{}</td>", h.number ? "n" : style_of(value),
                     escape_markup(typeset(value)));
}

std::string link(const std::string& path) {
  return fmt::format("<a href=\"{}\">{}</a>", escape_markup(path),
                     escape_markup(std::filesystem::path(path).filename().string()));
}

}  // namespace

Html raw(std::string_view code) {
  return {std::string(code)};
}
Html text(std::string_view words) {
  return {escape_markup(words)};
}

Html paragraph(std::string_view words, const char* style) {
  const std::string attribute = *style == '\0' ? "" : fmt::format(" class=\"{}\"", style);
  return {"<p" + attribute + ">" + escape_markup(typeset(words)) + "</p>\n"};
}

Html list(const std::vector<std::string>& items) {
  if (items.empty()) return {};
  std::string out = "<ul>\n";
  for (const std::string& item : items) out += "<li>" + escape_markup(typeset(item)) + "</li>\n";
  return {out + "</ul>\n"};
}

Html heading2(std::string_view words) {
  return {"<h2>" + escape_markup(words) + "</h2>\n"};
}
Html heading3(std::string_view words) {
  return {"<h3>" + escape_markup(words) + "</h3>\n"};
}

Html explained(std::string_view term, std::string_view meaning) {
  return {fmt::format("<abbr title=\"{}\">{}</abbr>", escape_markup(meaning), escape_markup(term))};
}

Html table(std::string_view caption, const std::vector<Heading>& headings,
           const std::vector<std::vector<std::string>>& rows) {
  std::string out = "<div class=\"scroll\"><table>\n";
  if (!caption.empty()) out += "<caption>" + escape_markup(caption) + "</caption>\n";
  out += "<thead><tr>";
  for (const Heading& h : headings) out += heading_cell(h);
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) out += cell(headings[i], row[i], i == 0);
    out += "</tr>\n";
  }
  return {out + "</tbody></table></div>\n"};
}

Html figure(const Picture& picture, std::string_view caption, const std::vector<std::string>& links) {
  const std::string width = picture.width > 0 ? fmt::format(" width=\"{}\"", picture.width) : "";
  std::string out =
      fmt::format("<figure><img src=\"data:{};base64,{}\" alt=\"{}\"{}>\n<figcaption>{}", picture.type,
                  base64(picture.bytes), escape_markup(picture.alt), width, escape_markup(caption));
  for (std::size_t i = 0; i < links.size(); ++i) out += (i == 0 ? " Files: " : ", ") + link(links[i]);
  return {out + "</figcaption></figure>\n"};
}

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = (group << 8) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k > bytes.size() ? '=' : alphabet[(group >> (18 - 6 * k)) & 63u];
    }
  }
  return out;
}

}  // namespace dougong::app
