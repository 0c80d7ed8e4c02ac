#include "rig/datagram_input.hpp"

#include <algorithm>

#include "rigsound/config/nearest_word.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::config {

void take_address(const TomlTable& table, const std::string& address, std::string& host, int& port) {
  const auto where = parse_host_port(address);
  if (!where)
    table.fail("address", "\"" + address + "\" is no address with a port, expected HOST:PORT or [V6]:PORT");
  host = where->host;
  port = where->port;
}

void keep_listed(TomlTable& table, std::vector<udp::NameRoute>& routes) {
  if (!table.has("signals")) return table.expect("signals");
  std::vector<udp::NameRoute> listed;
  std::vector<std::string> names;
  for (const udp::NameRoute& route : routes) names.push_back(route.name);
  for (const std::string& name : table.texts("signals")) {
    const auto found = std::find(names.begin(), names.end(), name);
    const std::string_view near = nearest_word(name, names);
    if (found == names.end())
      table.fail("signals", "\"" + name + "\" is no signal, or one that another bus delivers" +
                                (near.empty() ? std::string(", expected engine_rpm, boom2.rattling, ...")
                                              : ", did you mean '" + std::string(near) + "'?"));
    listed.push_back(routes[static_cast<std::size_t>(found - names.begin())]);
  }
  routes = std::move(listed);
}

}  // namespace rigsound::config
