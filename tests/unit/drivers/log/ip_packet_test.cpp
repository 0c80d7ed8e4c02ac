// IP packets under every link layer, whole and cut off at every byte; and those that we make up ourselves.
#include "log/ip_packet.hpp"

#include <doctest/doctest.h>
#include <pcap/dlt.h>

#include <algorithm>
#include <string>

#include "drivers/log/made_packets.hpp"
#include "log/capture_dump.hpp"

using namespace rigsound::log;
using rigsound::test::Octets;
using rigsound::test::octets;
using rigsound::test::text_of;
using rigsound::test::operator+;

namespace {

constexpr MadeUpEnd kSender{0x0a000001, 50001}, kReceiver{0xc0a80102, 1503};
const Octets kMacs(12, 0x22);

std::optional<UdpPacket> datagram_in(int link, const Octets& packet) {
  return parse_udp_packet(link, packet.data(), packet.size());
}

std::optional<TcpPacket> segment_in(int link, const Octets& packet) {
  return parse_packet(link, packet.data(), packet.size());
}

std::string said(const std::optional<UdpPacket>& p) {
  return p ? std::string(p->data, p->data + p->size) : "nothing";
}

/// The sum that IP's receivers make of 16-bit words (RFC 1071): 0xffff when the checksum is right.
std::uint32_t sum_of_words(const Octets& bytes) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2)
    sum += static_cast<std::uint32_t>(bytes[i] << 8 | (i + 1 < bytes.size() ? bytes[i + 1] : 0));
  while (sum > 0xffff) sum = (sum & 0xffff) + (sum >> 16);
  return sum;
}

/// Version 6, no traffic class, no flow; then what is given.
Octets over_ipv6(const Octets& inside, int protocol) {
  return octets(6ULL << 28, 4) + octets(inside.size(), 2) + octets(static_cast<unsigned>(protocol), 1) +
         octets(64, 1) + Octets(16, 0x11) + Octets(16, 0x33) + inside;
}

const Octets kUdpInside = octets(7, 2) + octets(9, 2) + octets(10, 2) + octets(0, 2) + Octets{'h', 'i'};

}  // namespace

TEST_CASE("A datagram is found under every link layer, with its ends") {
  const Octets ip = udp_packet("{}", kSender, kReceiver);
  const struct {
    int link;
    Octets before;
  } layers[] = {{DLT_RAW, {}},
                {DLT_NULL, octets(2, 4, false)},
                {DLT_LOOP, octets(2, 4)},
                {DLT_LINUX_SLL, Octets(16, 1)},
                {DLT_LINUX_SLL2, Octets(20, 1)},
                {DLT_EN10MB, kMacs + octets(0x0800, 2)},
                {DLT_EN10MB, kMacs + octets(0x8100, 2) + octets(5, 2) + octets(0x0800, 2)},
                {DLT_EN10MB, kMacs + octets(0x88a8, 2) + octets(5, 2) + octets(0x8100, 2) + octets(6, 2) +
                                 octets(0x0800, 2)}};
  for (const auto& layer : layers) {
    CAPTURE(layer.link);
    CAPTURE(layer.before.size());
    const Octets packet = layer.before + ip;
    const auto found = datagram_in(layer.link, packet);
    REQUIRE(found);
    CHECK(said(found) == "{}");
    CHECK(found->from.port == 50001);
    CHECK(found->to.port == 1503);
    CHECK_FALSE(found->from.v6);
    CHECK(std::equal(found->from.address.begin(), found->from.address.begin() + 4,
                     octets(0x0a000001, 4).begin()));
    CHECK(
        std::equal(found->to.address.begin(), found->to.address.begin() + 4, octets(0xc0a80102, 4).begin()));
    for (std::size_t size = 0; size < packet.size(); ++size)
      CHECK_FALSE(parse_udp_packet(layer.link, packet.data(), size));
    CHECK(said(datagram_in(layer.link, packet + Octets(9, 0))) == "{}");  // Ethernet pads short packets
  }
  CHECK_FALSE(datagram_in(DLT_EN10MB, kMacs + octets(0x0806, 2) + ip));  // ARP
  CHECK_FALSE(datagram_in(DLT_IEEE802_11, ip));
}

TEST_CASE("A datagram over IPv6 is found, with its ends") {
  const Octets ip = over_ipv6(kUdpInside, kUdp);
  for (const Octets& packet : {kMacs + octets(0x86dd, 2) + ip}) {
    const auto found = datagram_in(DLT_EN10MB, packet);
    REQUIRE(found);
    CHECK(said(found) == "hi");
    CHECK(found->from.v6);
    CHECK(found->to.v6);
    CHECK(found->from.address == Endpoint{{0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11,
                                           0x11, 0x11, 0x11, 0x11, 0x11}}
                                     .address);
    CHECK(found->to.address[15] == 0x33);
    CHECK(found->from.port == 7);
    CHECK(found->to.port == 9);
    for (std::size_t size = 0; size < packet.size(); ++size)
      CHECK_FALSE(parse_udp_packet(DLT_EN10MB, packet.data(), size));
  }
  CHECK_FALSE(datagram_in(DLT_RAW, over_ipv6(kUdpInside, kTcp)));
}

TEST_CASE("A header that contradicts itself, a fragment and another protocol are no datagram") {
  const Octets good = udp_packet("{}", kSender, kReceiver);
  const auto with = [&](std::size_t at, const Octets& value) {
    Octets packet = good;
    std::copy(value.begin(), value.end(), packet.begin() + static_cast<std::ptrdiff_t>(at));
    return packet;
  };
  CHECK(datagram_in(DLT_RAW, good));
  CHECK_FALSE(datagram_in(DLT_RAW, with(0, {0x55})));             // version 5
  CHECK_FALSE(datagram_in(DLT_RAW, with(0, {0x44})));             // a head of 16 bytes
  CHECK_FALSE(datagram_in(DLT_RAW, with(2, octets(19, 2))));      // shorter than its head
  CHECK_FALSE(datagram_in(DLT_RAW, with(2, octets(31, 2))));      // longer than it is
  CHECK_FALSE(datagram_in(DLT_RAW, with(6, octets(0x2000, 2))));  // more fragments
  CHECK_FALSE(datagram_in(DLT_RAW, with(6, octets(0x0001, 2))));  // not the first
  CHECK(datagram_in(DLT_RAW, with(6, octets(0x4000, 2))));        // not to be fragmented
  CHECK_FALSE(datagram_in(DLT_RAW, with(9, {6})));                // TCP
  CHECK_FALSE(datagram_in(DLT_RAW, with(24, octets(7, 2))));      // shorter than UDP's head
  CHECK_FALSE(datagram_in(DLT_RAW, with(24, octets(11, 2))));     // longer than IP's payload
  CHECK(said(datagram_in(DLT_RAW, with(24, octets(9, 2)))) == "{");
  CHECK(said(datagram_in(DLT_RAW, with(24, octets(8, 2)))).empty());
}

TEST_CASE("Options of IP and TCP are passed over") {
  const Octets plain = tcp_packet({'a', 'b'}, kSender, kReceiver, 0x12345678, 9);
  Octets options(plain.begin(), plain.begin() + 20);
  options[0] = 0x46, options[3] = static_cast<std::uint8_t>(options[3] + 4 + 8);
  Octets head(plain.begin() + 20, plain.end() - 2);
  head[12] = 0x70;
  const Octets packet = options + Octets(4, 1) + head + Octets(8, 1) + Octets{'a', 'b'};
  const auto found = segment_in(DLT_RAW, packet);
  REQUIRE(found);
  CHECK(std::string(found->data, found->data + found->size) == "ab");
  for (std::size_t size = 0; size < packet.size(); ++size)
    CHECK_FALSE(parse_packet(DLT_RAW, packet.data(), size));
}

TEST_CASE("A segment tells its sequence number and its flags") {
  Octets packet = tcp_packet({'x'}, kSender, kReceiver, 0x89abcdef, 77);
  auto found = segment_in(DLT_RAW, packet);
  REQUIRE(found);
  CHECK(found->sequence == 0x89abcdef);
  CHECK(found->ack);
  CHECK_FALSE(found->syn);
  CHECK(found->from.port == 50001);
  CHECK(found->to.port == 1503);
  packet[33] = 2;
  found = segment_in(DLT_RAW, packet);
  REQUIRE(found);
  CHECK(found->syn);
  CHECK_FALSE(found->ack);
  packet[32] = 0x40;  // a head of 16 bytes
  CHECK_FALSE(segment_in(DLT_RAW, packet));
  packet[32] = 0x60;  // of 24: more than there is
  CHECK_FALSE(segment_in(DLT_RAW, packet));
}

TEST_CASE("What we make up has the right lengths and checksums") {
  for (const std::string text : {"", "{}", "{\"engine_rpm\": 1500}"}) {
    CAPTURE(text);
    for (const Octets& packet : {udp_packet(text, kSender, kReceiver),
                                 tcp_packet({text.begin(), text.end()}, kSender, kReceiver, 1, 0xfffffffe)}) {
      const bool is_udp = packet[9] == 17;
      const std::size_t head = is_udp ? 8 : 20;
      CHECK(packet.size() == 20 + head + text.size());
      CHECK(octets(packet.size(), 2) == Octets(packet.begin() + 2, packet.begin() + 4));
      CHECK(sum_of_words({packet.begin(), packet.begin() + 20}) == 0xffff);
      const Octets pseudo = Octets(packet.begin() + 12, packet.begin() + 20) + octets(packet[9], 2) +
                            octets(packet.size() - 20, 2);
      CHECK(sum_of_words(pseudo + Octets(packet.begin() + 20, packet.end())) == 0xffff);
      CHECK(text_of({packet.begin() + 20 + static_cast<std::ptrdiff_t>(head), packet.end()}) == text);
    }
  }
}
