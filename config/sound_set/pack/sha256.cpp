#include "sound_set/pack/sha256.hpp"

#include <openssl/evp.h>

#include <stdexcept>

namespace rigsound::config {

std::array<std::uint8_t, 32> sha256(std::string_view bytes) {
  std::array<std::uint8_t, 32> hash{};
  if (EVP_Digest(bytes.data(), bytes.size(), hash.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto has no SHA-256");
  return hash;
}

}  // namespace rigsound::config
