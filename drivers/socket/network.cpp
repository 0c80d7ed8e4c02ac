#include "rigsound/socket/network.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>

namespace rigsound {
namespace {

constexpr std::array<std::uint8_t, 12> kMappedIpv4 = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};

bool inside(const std::vector<std::uint8_t>& address, const Network& network) {
  if (address.size() != network.address.size()) return false;
  for (int bit = 0; bit < network.prefix; ++bit) {
    const auto byte = bit / 8;
    if (((address[byte] ^ network.address[byte]) >> (7 - bit % 8) & 1) != 0) return false;
  }
  return true;
}

bool is_loopback(const std::vector<std::uint8_t>& address) {
  if (address.size() == 4) return address[0] == 127;
  return address.size() == 16 && address.back() == 1 &&
         std::all_of(address.begin(), address.end() - 1, [](std::uint8_t b) { return b == 0; });
}

}  // namespace

std::vector<std::uint8_t> address_bytes(const sockaddr_storage& peer) {
  if (peer.ss_family == AF_INET) {
    const auto* bytes =
        reinterpret_cast<const std::uint8_t*>(&reinterpret_cast<const sockaddr_in&>(peer).sin_addr);
    return {bytes, bytes + 4};
  }
  const auto* bytes =
      reinterpret_cast<const std::uint8_t*>(&reinterpret_cast<const sockaddr_in6&>(peer).sin6_addr);
  const bool mapped = std::equal(kMappedIpv4.begin(), kMappedIpv4.end(), bytes);
  return {mapped ? bytes + 12 : bytes, bytes + 16};
}

std::string address_text(const sockaddr_storage& peer) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  const std::vector<std::uint8_t> bytes = address_bytes(peer);
  ::inet_ntop(bytes.size() == 4 ? AF_INET : AF_INET6, bytes.data(), text.data(), text.size());
  return text.data();
}

bool allowed(const std::vector<std::uint8_t>& address, const std::vector<Network>& networks) {
  if (networks.empty()) return is_loopback(address);
  return std::any_of(networks.begin(), networks.end(), [&](const Network& n) { return inside(address, n); });
}

}  // namespace rigsound
