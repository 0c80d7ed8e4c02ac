// SHA-256 (FIPS 180-4). Of our own because what reads a packed set links no library: it runs in a browser
// too.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rigsound::config {

std::array<std::uint8_t, 32> sha256(std::string_view bytes);  ///< Thread: any

}  // namespace rigsound::config
