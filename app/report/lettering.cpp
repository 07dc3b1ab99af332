#include "app/report/lettering.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace dougong::app {
namespace {

constexpr char32_t replacement = 0xfffd;

/// Path of the installed font closest to Arial, as in the plots.
std::string font_file() {
  FcInit();
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(
      FcNameParse(reinterpret_cast<const FcChar8*>("Arial,Liberation Sans,DejaVu Sans,sans-serif")),
      FcPatternDestroy);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const std::unique_ptr<FcPattern, void (*)(FcPattern*)> found(FcFontMatch(nullptr, wanted.get(), &result),
                                                               FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) {
    throw std::runtime_error(
        "no font for the pictures is installed: install the package fonts-liberation2 or fonts-dejavu-core");
  }
  return reinterpret_cast<const char*>(file);
}

std::size_t bytes_of(unsigned char lead) {
  return lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
}

/// Code points; bytes that are no UTF-8 become the replacement character.
std::u32string decoded(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = bytes_of(lead);
    char32_t code = length == 1 ? lead : lead & (0xffu >> (length + 1));
    bool valid = lead < 0x80 || (lead >= 0xc2 && lead < 0xf5 && i + length <= text.size());
    for (std::size_t k = 1; valid && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      valid = (next & 0xc0) == 0x80;
      code = (code << 6) | (next & 0x3f);
    }
    out += valid ? code : replacement;
    i += valid ? length : 1;
  }
  return out;
}

}  // namespace

struct Lettering::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
};

Lettering::Lettering(double pixels) : face_(new Face) {
  static const std::string file = font_file();
  const bool opened = FT_Init_FreeType(&face_->library) == 0 &&
                      FT_New_Face(face_->library, file.c_str(), 0, &face_->face) == 0 &&
                      FT_Set_Char_Size(face_->face, 0, std::lround(64.0 * pixels), 72, 72) == 0;
  if (opened) return;
  FT_Done_FreeType(face_->library);
  delete face_;
  throw std::runtime_error("cannot use the font " + file);
}

Lettering::~Lettering() {
  FT_Done_Face(face_->face);
  FT_Done_FreeType(face_->library);
  delete face_;
}

double Lettering::width(std::string_view utf8) const {
  double x = 0.0;
  for (const char32_t code : decoded(utf8)) {
    if (FT_Load_Char(face_->face, code, FT_LOAD_NO_HINTING) == 0)
      x += static_cast<double>(face_->face->glyph->advance.x) / 64.0;
  }
  return x;
}

double Lettering::line_height() const {
  return static_cast<double>(face_->face->size->metrics.height) / 64.0;
}

void Lettering::draw(Image& image, std::string_view utf8, double x, double y, Colour colour,
                     Align align) const {
  if (align != Align::left) x -= width(utf8) * (align == Align::centre ? 0.5 : 1.0);
  for (const char32_t code : decoded(utf8)) {
    FT_Vector shift{std::lround(64.0 * (x - std::floor(x))), 0};
    FT_Set_Transform(face_->face, nullptr, &shift);
    if (FT_Load_Char(face_->face, code, FT_LOAD_RENDER | FT_LOAD_NO_HINTING) != 0) continue;
    const FT_GlyphSlot glyph = face_->face->glyph;
    const int left = static_cast<int>(std::floor(x)) + glyph->bitmap_left,
              top = static_cast<int>(std::lround(y)) - glyph->bitmap_top;
    for (int row = 0; row < static_cast<int>(glyph->bitmap.rows); ++row) {
      for (int column = 0; column < static_cast<int>(glyph->bitmap.width); ++column) {
        image.blend(left + column, top + row, colour,
                    glyph->bitmap.buffer[row * glyph->bitmap.pitch + column] / 255.0);
      }
    }
    x += static_cast<double>(glyph->linearHoriAdvance) / 65536.0;
  }
  FT_Set_Transform(face_->face, nullptr, nullptr);
}

std::vector<std::string> Lettering::wrapped(std::string_view utf8, double most) const {
  std::istringstream words{std::string(utf8)};
  std::vector<std::string> lines;
  for (std::string word; words >> word;) {
    const bool fits = !lines.empty() && width(lines.back() + " " + word) <= most;
    if (fits)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::string Lettering::cut(std::string_view utf8, double most) const {
  std::string text(utf8);
  if (width(text) <= most) return text;
  while (!text.empty() && width(text + "…") > most) {
    do text.pop_back();
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80);
    if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xc0) text.pop_back();
  }
  return text + "…";
}

}  // namespace dougong::app
