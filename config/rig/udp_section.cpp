#include "rig/allow.hpp"
#include "rig/datagram_input.hpp"
#include "rig/sections.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {

udp::UdpOptions read_udp(TomlTable table, const std::vector<udp::NameRoute>& free_signals) {
  udp::UdpOptions options;
  read(table, options);
  take_address(table, options.address, options.host, options.port);
  options.allow = read_allow(table);
  options.routes = free_signals;
  keep_listed(table, options.routes);
  table.refuse_unknown();
  return options;
}

}  // namespace rigsound::config
