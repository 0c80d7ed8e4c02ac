// SHA-256 of what is fed to it (FIPS 180-4). Thread: OFF.
#pragma once

#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <string>

namespace rigsound::config {

class Sha256 {
 public:
  Sha256();
  void update(const void* bytes, std::size_t size);

  /// Either ends the hash: the next update() begins another.
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes();
  std::string hex();  ///< 64 lower-case digits

 private:
  sha256_ctx context_;
};

}  // namespace rigsound::config
