// `allow`: the networks that may talk to us.
#pragma once

#include <vector>

#include "rigsound/socket/network.hpp"
#include "toml/toml_table.hpp"

namespace rigsound::config {

/// Loopback when the table does not say. Errors: InputError.
std::vector<Network> read_allow(TomlTable& table);

}  // namespace rigsound::config
