#include "sound_set/pack/sha256.hpp"

#include <nettle/base16.h>

#include "rigsound/config/sha256.hpp"

namespace rigsound::config {

Sha256::Sha256() { sha256_init(&context_); }

void Sha256::update(const void* bytes, std::size_t size) {
  sha256_update(&context_, size, static_cast<const std::uint8_t*>(bytes));
}

std::array<std::uint8_t, SHA256_DIGEST_SIZE> Sha256::bytes() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> hash{};
  sha256_digest(&context_, hash.size(), hash.data());
  return hash;
}

std::string Sha256::hex() {
  const auto hash = bytes();
  std::string digits(BASE16_ENCODE_LENGTH(hash.size()), '\0');
  base16_encode_update(digits.data(), hash.size(), hash.data());
  return digits;
}

std::array<std::uint8_t, 32> sha256(std::string_view bytes) {
  Sha256 hash;
  hash.update(bytes.data(), bytes.size());
  return hash.bytes();
}

}  // namespace rigsound::config
