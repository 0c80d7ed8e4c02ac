#include <algorithm>

#include "rig/network.hpp"
#include "rig/sections.hpp"
#include "rigsound/socket/host_port.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

constexpr unsigned kOwner = 0600, kMost = 0666;  // reading and writing: a socket is not run

unsigned mode_bits(const TomlTable& table, const std::string& mode) {
  const auto octal = [](char c) { return c >= '0' && c <= '7'; };
  unsigned bits = 0;
  if (mode.size() <= 4 && std::all_of(mode.begin(), mode.end(), octal))
    for (const char c : mode) bits = bits * 8 + static_cast<unsigned>(c - '0');
  if ((bits & kOwner) != kOwner || (bits & ~kMost) != 0)
    table.fail("mode", "is \"" + mode +
                           "\", expected \"0600\"...\"0666\", octal: 6 or 4 or 2 or 0 of group and others");
  return bits;
}

void require_address(const TomlTable& table, const char* key, const std::string& text) {
  if (!text.empty() && !parse_host_port(text))
    table.fail(key, "\"" + text + "\" is no address with a port, expected HOST:PORT or \"\"");
}

/// Written as digits, so that no name server and no hosts file decides.
bool is_loopback(const std::string& address) {
  const auto where = parse_host_port(address);
  const auto network = where ? parse_network(where->host) : std::nullopt;
  const bool one = network && network->prefix == static_cast<int>(network->address.size()) * 8;
  return one && allowed(network->address, {});
}

void check_tcp(const TomlTable& table, const ControlOptions& control) {
  if (!control.tcp.empty() && !is_loopback(control.tcp))
    table.fail("tcp", "\"" + control.tcp +
                          "\" is no address on this machine, expected 127.0.0.1:PORT, [::1]:PORT or \"\"");
  if (!control.tcp.empty() && control.token_file.empty())
    table.fail("tcp", "lets every user of this machine in, expected token_file too");
  if (control.tcp.empty() && !control.token_file.empty())
    table.fail("token_file", "is asked for over tcp only, expected tcp too");
}

}  // namespace

ControlOptions read_control(TomlTable table, const std::filesystem::path& folder) {
  ControlOptions control;
  read(table, control);
  control.mode_bits = mode_bits(table, control.mode);
  control.socket_line = table.line_of("socket");
  control.group_line = table.line_of("group");
  check_tcp(table, control);
  if (!control.token_file.empty())
    control.token_file = (folder / control.token_file).lexically_normal().string();
  require_address(table, "metrics", control.metrics);
  table.refuse_unknown();
  return control;
}

}  // namespace rigsound::config
