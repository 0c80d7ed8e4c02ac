// A PNG as its pixels.
#pragma once

#include <png.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace rigsound::test {

struct PngFile {
  struct Pixel {
    std::uint8_t red, green, blue;

    bool operator==(const Pixel& o) const { return red == o.red && green == o.green && blue == o.blue; }
    bool operator!=(const Pixel& o) const { return !(*this == o); }
  };
  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  Pixel at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// Throws when the file is no whole PNG.
inline PngFile read_png(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, file.c_str())) throw std::runtime_error(image.message);
  image.format = PNG_FORMAT_RGB;
  PngFile png{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  png.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  if (!png_image_finish_read(&image, nullptr, png.pixels.data(), 0, nullptr))
    throw std::runtime_error(image.message);
  return png;
}

}  // namespace rigsound::test
