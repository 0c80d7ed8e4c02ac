// What inputs by datagrams have alike: where they listen, and which signals they take.
#pragma once

#include <string>
#include <vector>

#include "rigsound/udp/udp_options.hpp"
#include "toml/toml_table.hpp"

namespace rigsound::config {

/// Takes `address` of a table apart. Errors: InputError.
void take_address(const TomlTable& table, const std::string& address, std::string& host, int& port);

/// `signals = ["engine_rpm", "boom2.rattling"]`: these only; without the key all of them. Errors: InputError.
void keep_listed(TomlTable& table, std::vector<udp::NameRoute>& routes);

}  // namespace rigsound::config
