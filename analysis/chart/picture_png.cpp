#include "chart/picture_png.hpp"

#include <png.h>

#include <stdexcept>

#include "rigsound/analysis/data_uri.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::chart {
namespace {

static_assert(sizeof(Colour) == 3, "libpng is given colours as they lie in memory");

png_image header(int width, std::size_t pixels, png_uint_32 format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels) / image.width;
  image.format = format;
  return image;
}

}  // namespace

std::string png_bytes(const Picture& picture) {
  png_image image = header(picture.width, picture.pixels.size(), PNG_FORMAT_RGB_COLORMAP);
  image.colormap_entries = static_cast<png_uint_32>(picture.palette.size());
  const auto check = [&image](int written) {
    if (!written) throw std::runtime_error(std::string("a picture cannot be packed: ") + image.message);
  };
  png_alloc_size_t size = 0;
  check(
      png_image_write_to_memory(&image, nullptr, &size, 0, picture.pixels.data(), 0, picture.palette.data()));
  std::string bytes(size, '\0');
  check(png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0,
                                  picture.palette.data()));
  bytes.resize(size);
  return bytes;
}

std::string png_data_uri(const Picture& picture) { return data_uri("image/png", png_bytes(picture)); }

void write_png(const std::filesystem::path& file, const std::vector<Colour>& pixels, int width) {
  png_image image = header(width, pixels.size(), PNG_FORMAT_RGB);
  if (!png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, nullptr))
    throw DeviceError(file.string() + ": cannot be written: " + image.message);
}

}  // namespace rigsound::chart
