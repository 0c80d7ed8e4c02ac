// Our own SHA-256, for where there is no nettle, against nettle's and the standard's examples.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "sound_set/pack/sha256.hpp"

namespace rigsound::config {
/// sha256() of plain_sha256.cpp under a name of its own.
std::array<std::uint8_t, 32> plain_sha256(std::string_view bytes);
}  // namespace rigsound::config

using namespace rigsound;

namespace {

std::string hex(const std::array<std::uint8_t, 32>& hash) {
  std::string text;
  for (const std::uint8_t byte : hash) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

}  // namespace

TEST_CASE("the examples of FIPS 180") {
  CHECK(hex(config::plain_sha256("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hex(config::plain_sha256("abc")) ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hex(config::plain_sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")) ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_CASE("every length around the ends of blocks has nettle's hash") {
  std::string bytes;
  for (int size = 0; size <= 300; ++size) {
    CAPTURE(size);
    CHECK(config::plain_sha256(bytes) == config::sha256(bytes));
    bytes += static_cast<char>(size * 37 + size / 7);
  }
  const std::string long_one(1 << 20, '\xA5');  // its length in bits needs three bytes
  CHECK(config::plain_sha256(long_one) == config::sha256(long_one));
}
