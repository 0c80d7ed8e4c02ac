#include "report/indexed_png.hpp"

#include <algorithm>

namespace rigsound::analysis {
namespace {

constexpr std::size_t kLargestStored = 65535;  // bytes of one stored deflate block

void put_big_endian(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  return ~crc;
}

std::uint32_t adler32(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

void put_chunk(std::string& png, const std::string& type, const std::string& data) {
  put_big_endian(png, static_cast<std::uint32_t>(data.size()));
  png += type + data;
  put_big_endian(png, crc32(type + data));
}

/// The bytes as a zlib stream of stored blocks (RFC 1950, 1951).
std::string zlib_stored(const std::string& bytes) {
  std::string out = "\x78\x01";
  for (std::size_t at = 0; at < bytes.size(); at += kLargestStored) {
    const std::size_t size = std::min(kLargestStored, bytes.size() - at);
    out += at + size == bytes.size() ? '\1' : '\0';
    for (const std::size_t word : {size, ~size})
      out += static_cast<char>(word & 0xff), out += static_cast<char>(word >> 8 & 0xff);
    out.append(bytes, at, size);
  }
  put_big_endian(out, adler32(bytes));
  return out;
}

/// Two pixels a byte, an unfiltered row at a time.
std::string packed(const std::vector<std::uint8_t>& pixels, std::size_t width) {
  std::string rows;
  for (std::size_t row = 0; row < pixels.size(); row += width) {
    rows += '\0';
    for (std::size_t x = 0; x < width; x += 2) {
      const int right = x + 1 < width ? pixels[row + x + 1] : 0;
      rows += static_cast<char>(pixels[row + x] << 4 | right);
    }
  }
  return rows;
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string png_data_uri(const std::vector<std::uint8_t>& pixels, int width,
                         const std::array<Colour, 16>& palette) {
  std::string header, colours, png = "\x89PNG\r\n\x1a\n";
  put_big_endian(header, static_cast<std::uint32_t>(width));
  put_big_endian(header, static_cast<std::uint32_t>(pixels.size()) / static_cast<std::uint32_t>(width));
  header += std::string("\x04\x03\x00\x00\x00", 5);  // four bits, palette, no interlace
  for (const Colour& c : palette)
    colours += {static_cast<char>(c.red), static_cast<char>(c.green), static_cast<char>(c.blue)};
  put_chunk(png, "IHDR", header);
  put_chunk(png, "PLTE", colours);
  put_chunk(png, "IDAT", zlib_stored(packed(pixels, static_cast<std::size_t>(width))));
  put_chunk(png, "IEND", "");
  return "data:image/png;base64," + base64(png);
}

}  // namespace rigsound::analysis
