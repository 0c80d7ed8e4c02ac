#include <algorithm>

#include "rig/allow.hpp"
#include "rig/sections.hpp"
#include "rigsound/config/nearest_word.hpp"
#include "rigsound/socket/host_port.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

constexpr int kNoPort = 0;

void take_address(const TomlTable& table, udp::UdpOptions& options) {
  const auto where = parse_host_port(options.address, kNoPort);
  if (!where || where->port == kNoPort)
    table.fail("address",
               "\"" + options.address + "\" is no address with a port, expected HOST:PORT or [V6]:PORT");
  options.host = where->host;
  options.port = where->port;
}

/// `signals = ["engine_rpm", "boom2.rattling"]`: these only.
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

}  // namespace

udp::UdpOptions read_udp(TomlTable table, const std::vector<udp::NameRoute>& free_signals) {
  udp::UdpOptions options;
  read(table, options);
  take_address(table, options);
  options.allow = read_allow(table);
  options.routes = free_signals;
  keep_listed(table, options.routes);
  table.refuse_unknown();
  return options;
}

}  // namespace rigsound::config
