// SHA-256 (FIPS 180-4): nettle's, and a plain one for engine.wasm, which links no library.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rigsound::config {

std::array<std::uint8_t, 32> sha256(std::string_view bytes);  ///< Thread: any

}  // namespace rigsound::config
