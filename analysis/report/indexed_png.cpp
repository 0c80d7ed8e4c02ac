#include "report/indexed_png.hpp"

#include <openssl/evp.h>
#include <png.h>

#include <stdexcept>

namespace rigsound::analysis {
namespace {

std::vector<unsigned char> png_bytes(const std::vector<std::uint8_t>& pixels, int width,
                                     const std::array<Colour, 16>& palette) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(pixels.size()) / image.width;
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  const auto check = [&image](int written) {
    if (!written) throw std::runtime_error(std::string("an image cannot be packed: ") + image.message);
  };
  png_alloc_size_t size = 0;
  check(png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, palette.data()));
  std::vector<unsigned char> bytes(size);
  check(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, palette.data()));
  bytes.resize(size);
  return bytes;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // the encoder ends with a zero
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                                       bytes.data(), static_cast<int>(bytes.size()))));
  return text;
}

}  // namespace

std::string png_data_uri(const std::vector<std::uint8_t>& pixels, int width,
                         const std::array<Colour, 16>& palette) {
  return "data:image/png;base64," + base64(png_bytes(pixels, width, palette));
}

}  // namespace rigsound::analysis
