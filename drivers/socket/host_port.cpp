#include "rigsound/socket/host_port.hpp"

#include <algorithm>

#include "rigsound/number_of.hpp"

namespace rigsound {
namespace {

std::optional<int> port_number(std::string_view text) {
  const auto port = number_of<int>(text);
  return port && *port >= 1 && *port <= 65535 ? port : std::nullopt;
}

}  // namespace

std::optional<HostPort> parse_host_port(std::string_view text, int default_port) {
  HostPort result;
  std::string_view rest;
  if (!text.empty() && text.front() == '[') {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    result.host = text.substr(1, end - 1);
    rest = text.substr(end + 1);
  } else {
    const std::size_t colon = std::min(text.rfind(':'), text.size());
    result.host = text.substr(0, colon);
    rest = text.substr(colon);
  }
  result.port = default_port;
  if (!rest.empty()) {
    const auto port = rest.front() == ':' ? port_number(rest.substr(1)) : std::nullopt;
    if (!port) return std::nullopt;
    result.port = *port;
  }
  if (result.host.empty() || result.port == 0) return std::nullopt;
  return result;
}

std::string text_of(const HostPort& where) {
  const bool v6 = where.host.find(':') != std::string::npos;
  return (v6 ? "[" + where.host + "]" : where.host) + ":" + std::to_string(where.port);
}

}  // namespace rigsound
