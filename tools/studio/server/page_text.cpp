#include "page_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace rigsound::studio {
namespace {

constexpr std::array<unsigned, 3> kNeverInScripts = {0x00, 0x0d, 0x3c};

std::vector<unsigned> sevens(std::string_view bytes) {
  std::vector<unsigned> groups;
  groups.reserve(bytes.size() * 8 / 7 + 1);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char byte : bytes) {
    held = (held << 8 | static_cast<unsigned char>(byte)) & 0x7fff;
    for (bits += 8; bits >= 7; bits -= 7) groups.push_back(held >> (bits - 7) & 0x7f);
  }
  if (bits > 0) groups.push_back(held << (7 - bits) & 0x7f);
  return groups;
}

/// U+0080...U+07FF as UTF-8.
void add_letter(std::string& text, unsigned letter) {
  text += static_cast<char>(0xc0 | letter >> 6);
  text += static_cast<char>(0x80 | (letter & 0x3f));
}

}  // namespace

std::string page_text(std::string_view bytes) {
  const std::vector<unsigned> groups = sevens(bytes);
  std::string text;
  text.reserve(groups.size() + groups.size() / 32);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto never = std::find(kNeverInScripts.begin(), kNeverInScripts.end(), groups[i]);
    if (never == kNeverInScripts.end()) {
      text += static_cast<char>(groups[i]);
      continue;
    }
    const auto which = static_cast<unsigned>(never - kNeverInScripts.begin());
    if (i + 1 < groups.size())
      add_letter(text, 0x100 + 128 * which + groups[++i]);
    else
      add_letter(text, 0x280 + 128 * which);
  }
  return text;
}

std::string deflated(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string out(size, '\0');
  if (::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("the page: cannot be compressed");
  out.resize(size);
  return out;
}

std::string byte_planes(std::string_view bytes) {
  const std::size_t whole = bytes.size() / 4 * 4;
  std::string planes;
  planes.reserve(bytes.size());
  for (std::size_t plane = 0; plane < 4; ++plane)
    for (std::size_t at = plane; at < whole; at += 4) planes += bytes[at];
  return planes.append(bytes.substr(whole));
}

}  // namespace rigsound::studio
