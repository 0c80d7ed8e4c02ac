// Letters as outlines, from the fonts of the machine.
#pragma once

#include <ft2build.h>

#include <memory>
#include <string>

#include "chart/canvas.hpp"
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace rigsound::chart {

/// DejaVu Sans, regular and bold. Errors: DeviceError when the machine has no such font. Thread: OFF.
class Font {
 public:
  Font();

  /// Calls `draw(outline)` for every letter; outlines are in pixels * 64, y up, the first letter begins at 0.
  /// Letters follow one another along x. Returns the width in pixels.
  template <class Draw>
  double spell(const std::string& text, double size_px, Lettering::Weight weight, Draw draw) const;

  double width(const std::string& text, double size_px, Lettering::Weight weight) const {
    return spell(text, size_px, weight, [](FT_Outline&) {});
  }

  FT_Library library() const { return library_.get(); }

 private:
  struct Closer {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  using Face = std::unique_ptr<FT_FaceRec_, Closer>;

  Face open(const char* file) const;

  std::unique_ptr<FT_LibraryRec_, Closer> library_;
  Face regular_, bold_;
};

/// The code points of UTF-8; what is none becomes U+FFFD. Thread: any.
std::u32string code_points(const std::string& utf8);

template <class Draw>
double Font::spell(const std::string& text, double size_px, Lettering::Weight weight, Draw draw) const {
  const FT_Face face = weight == Lettering::Weight::kBold ? bold_.get() : regular_.get();
  constexpr int kDotsPerInch = 72;  // a point is a pixel
  FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(64 * size_px), kDotsPerInch, kDotsPerInch);
  FT_Pos pen = 0;
  FT_UInt before = 0;
  for (const char32_t letter : code_points(text)) {
    const FT_UInt glyph = FT_Get_Char_Index(face, letter);
    FT_Vector kerning{0, 0};
    if (before != 0) FT_Get_Kerning(face, before, glyph, FT_KERNING_UNFITTED, &kerning);
    before = glyph;
    if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_BITMAP | FT_LOAD_NO_HINTING) != 0) continue;
    pen += kerning.x;
    FT_Outline_Translate(&face->glyph->outline, pen, 0);
    draw(face->glyph->outline);
    pen += face->glyph->advance.x;
  }
  return static_cast<double>(pen) / 64;
}

}  // namespace rigsound::chart
