#include "rig/allow.hpp"

#include "rig/network.hpp"

namespace rigsound::config {

std::vector<Network> read_allow(TomlTable& table) {
  const bool given = table.has("allow");
  std::vector<std::string> texts = table.texts("allow");
  if (!given) texts = {"127.0.0.0/8", "::1"};
  std::vector<Network> networks;
  for (const std::string& text : texts) {
    const auto network = parse_network(text);
    if (!network)
      table.fail("allow", "\"" + text +
                              "\" is no network, expected one like \"192.168.1.0/24\" with no bits after it");
    networks.push_back(*network);
  }
  return networks;
}

}  // namespace rigsound::config
