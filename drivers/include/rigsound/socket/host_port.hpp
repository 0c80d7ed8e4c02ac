// HOST:PORT as people write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigsound {

struct HostPort {
  std::string host;
  int port = 0;
};

/// "HOST:PORT", "[V6]:PORT", with a `default_port` also "HOST"; nothing for anything else. Thread: any.
std::optional<HostPort> parse_host_port(std::string_view text, int default_port = 0);

/// The way back, an IPv6 address in brackets. Thread: any.
std::string text_of(const HostPort& where);

}  // namespace rigsound
