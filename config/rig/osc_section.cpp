#include "rig/allow.hpp"
#include "rig/datagram_input.hpp"
#include "rig/network.hpp"
#include "rig/sections.hpp"
#include "rigsound/socket/host_port.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

/// In digits: a name server must not hold the daemon up.
std::vector<std::string> read_targets(TomlTable& table) {
  if (!table.has("targets")) return table.expect("targets"), std::vector<std::string>{};
  std::vector<std::string> targets = table.texts("targets");
  for (const std::string& target : targets) {
    const auto where = parse_host_port(target);
    if (!where || !parse_network(where->host))
      table.fail("targets",
                 "\"" + target + "\" is no address with a port, expected one like \"192.168.1.5:9000\"");
  }
  return targets;
}

}  // namespace

osc::OscOptions read_osc(TomlTable table, const std::vector<udp::NameRoute>& free_signals,
                         const std::vector<BoomOptions>& booms) {
  osc::OscOptions options;
  read(table, options);
  options.allow = read_allow(table);
  options.targets = read_targets(table);
  for (const BoomOptions& boom : booms) options.booms.push_back(boom.name);
  table.expect("signals");
  table.refuse_unknown();
  if (options.address.empty()) return options;
  take_address(table, options.address, options.host, options.port);
  options.routes = free_signals;
  keep_listed(table, options.routes);
  return options;
}

}  // namespace rigsound::config
