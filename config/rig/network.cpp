#include "rig/network.hpp"

#include <algorithm>

#include "rigsound/number_of.hpp"

namespace rigsound::config {
namespace {

std::optional<int> whole_number(std::string_view text, int max) {
  const auto n = number_of<int>(text);
  return n && *n >= 0 && *n <= max ? n : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> parse_v4(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  while (bytes.size() < 4) {
    const std::size_t dot = bytes.size() < 3 ? text.find('.') : text.size();
    if (dot == std::string_view::npos) return std::nullopt;
    const auto byte = whole_number(text.substr(0, dot), 255);
    if (!byte) return std::nullopt;
    bytes.push_back(static_cast<std::uint8_t>(*byte));
    text.remove_prefix(std::min(dot + 1, text.size()));
  }
  return bytes;
}

/// Groups of 16 bits between colons, as bytes; nothing when one is wrong.
std::optional<std::vector<std::uint8_t>> parse_groups(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  while (!text.empty()) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto group = number_of<std::uint16_t>(text.substr(0, colon), 16);
    if (!group) return std::nullopt;
    bytes.push_back(static_cast<std::uint8_t>(*group >> 8));
    bytes.push_back(static_cast<std::uint8_t>(*group & 0xFF));
    if (colon + 1 == text.size()) return std::nullopt;
    text.remove_prefix(std::min(colon + 1, text.size()));
  }
  return bytes;
}

std::optional<std::vector<std::uint8_t>> parse_v6(std::string_view text) {
  const std::size_t gap = text.find("::");
  if (gap == std::string_view::npos) {
    auto bytes = parse_groups(text);
    return bytes && bytes->size() == 16 ? bytes : std::nullopt;
  }
  auto head = parse_groups(text.substr(0, gap));
  const auto tail = parse_groups(text.substr(gap + 2));
  if (!head || !tail || head->size() + tail->size() > 14) return std::nullopt;
  head->resize(16 - tail->size());
  head->insert(head->end(), tail->begin(), tail->end());
  return head;
}

bool host_bits_clear(const Network& network) {
  for (int bit = network.prefix; bit < static_cast<int>(network.address.size()) * 8; ++bit)
    if ((network.address[static_cast<std::size_t>(bit / 8)] >> (7 - bit % 8) & 1) != 0) return false;
  return true;
}

}  // namespace

std::optional<Network> parse_network(std::string_view text) {
  Network network;
  network.text = text;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view host = text.substr(0, slash);
  const auto address = host.find(':') == std::string_view::npos ? parse_v4(host) : parse_v6(host);
  if (!address) return std::nullopt;
  network.address = *address;
  network.prefix = static_cast<int>(network.address.size()) * 8;
  if (slash < text.size()) {
    const auto prefix = whole_number(text.substr(slash + 1), network.prefix);
    if (!prefix) return std::nullopt;
    network.prefix = *prefix;
  }
  if (!host_bits_clear(network)) return std::nullopt;
  return network;
}

}  // namespace rigsound::config
