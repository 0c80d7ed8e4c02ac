#include "chart/font.hpp"

#include "rigsound/device_error.hpp"

namespace rigsound::chart {
namespace {

constexpr const char* kRegular = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* kBold = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

}  // namespace

Font::Font() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw DeviceError("the font library FreeType does not start");
  library_.reset(library);
  regular_ = open(kRegular);
  bold_ = open(kBold);
}

Font::Face Font::open(const char* file) const {
  FT_Face face = nullptr;
  if (FT_New_Face(library_.get(), file, 0, &face) != 0)
    throw DeviceError(std::string(file) + ": cannot be read, expected the package fonts-dejavu-core");
  return Face(face);
}

std::u32string code_points(const std::string& utf8) {
  constexpr char32_t kUnknown = 0xfffd;
  std::u32string text;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i++]);
    const int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : -1;
    char32_t code = more <= 0 ? first : first & (0x3fu >> more);
    int left = more;
    for (; left > 0 && i < utf8.size() && (utf8[i] & 0xc0) == 0x80; --left)
      code = code << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3fu);
    text += left == 0 ? code : kUnknown;
  }
  return text;
}

}  // namespace rigsound::chart
