// Pieces of HTML. Everything that takes text escapes it; what is already HTML has the type Html, so
// that text cannot slip in unescaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dougong::app {

struct Html {
  std::string code;
  Html& operator+=(const Html& other) {
    code += other.code;
    return *this;
  }
};
inline Html operator+(Html a, const Html& b) {
  return a += b;
}

/// HTML written by the program itself.
Html raw(std::string_view code);
Html text(std::string_view words);
Html paragraph(std::string_view words, const char* style = "");
Html list(const std::vector<std::string>& items);
Html heading2(std::string_view words);
Html heading3(std::string_view words);
/// A term with its one-line explanation on hover.
Html explained(std::string_view term, std::string_view meaning);

struct Heading {
  std::string name;
  std::string unit;    // on its own line; may be empty
  bool number = true;  // right-aligned, decimals under each other
};
Html table(std::string_view caption, const std::vector<Heading>& headings,
           const std::vector<std::vector<std::string>>& rows);

struct Picture {
  std::string name;  // of the file, with its folder
  std::string type;  // "image/png" or "image/svg+xml"
  std::string bytes;
  std::string alt;
  int width = 0;  // px at 1x, 0 for the natural width
};
/// The picture itself, inside the page, with a caption and links to the files beside it.
Html figure(const Picture& picture, std::string_view caption, const std::vector<std::string>& links);

std::string base64(std::string_view bytes);

}  // namespace dougong::app
