// Networks as people write them.
#pragma once

#include <optional>
#include <string_view>

#include "rigsound/socket/network.hpp"

namespace rigsound::config {

/// "127.0.0.0/8", "::1/128", "192.168.1.5"; nothing for anything else, or when host bits are set.
std::optional<Network> parse_network(std::string_view text);

}  // namespace rigsound::config
