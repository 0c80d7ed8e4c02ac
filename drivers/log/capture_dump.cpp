#include "log/capture_dump.hpp"

#include <cerrno>
#include <cstring>

#include "log/capture_file.hpp"
#include "log/ip_packet.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kLongestPacket = 65535;

/// The highest first.
void put(Bytes& out, std::uint32_t value, int bytes) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t ones_sum(const Bytes& bytes, std::size_t from, std::size_t to, std::uint32_t sum) {
  for (std::size_t i = from; i < to; ++i)
    sum += static_cast<std::uint32_t>(bytes[i] << (i % 2 == from % 2 ? 8 : 0));
  return sum;
}

std::uint16_t fold(std::uint32_t sum) {
  while (sum >> 16 != 0) sum = (sum & 0xffff) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum & 0xffff);
}

void set_word(Bytes& bytes, std::size_t at, std::uint16_t word) {
  bytes[at] = static_cast<std::uint8_t>(word >> 8);
  bytes[at + 1] = static_cast<std::uint8_t>(word & 0xff);
}

Bytes ip_head(int protocol, std::size_t payload, const MadeUpEnd& from, const MadeUpEnd& to) {
  Bytes p;
  put(p, 0x45000000U | static_cast<std::uint32_t>(20 + payload), 4);
  put(p, 0x00004000, 4);                                                // no fragments
  put(p, 0x40000000U | static_cast<std::uint32_t>(protocol) << 16, 4);  // 64 hops
  put(p, from.address, 4);
  put(p, to.address, 4);
  return p;
}

/// Fills in the checksums of IP and, at `checksum_at`, of what it carries.
void seal(Bytes& p, int protocol, std::size_t checksum_at) {
  set_word(p, 10, fold(ones_sum(p, 0, 20, 0)));
  const std::uint32_t pseudo =
      ones_sum(p, 12, 20, static_cast<std::uint32_t>(protocol) + static_cast<std::uint32_t>(p.size() - 20));
  set_word(p, checksum_at, fold(ones_sum(p, 20, p.size(), pseudo)));
}

}  // namespace

Bytes tcp_packet(const Bytes& frame, const MadeUpEnd& from, const MadeUpEnd& to, std::uint32_t sequence,
                 std::uint32_t acknowledged) {
  Bytes p = ip_head(kTcp, 20 + frame.size(), from, to);
  put(p, static_cast<std::uint32_t>(from.port), 2);
  put(p, static_cast<std::uint32_t>(to.port), 2);
  put(p, sequence, 4);
  put(p, acknowledged, 4);
  put(p, 0x5018ffff, 4);  // no options, PSH ACK, window
  put(p, 0, 4);
  p.insert(p.end(), frame.begin(), frame.end());
  seal(p, kTcp, 36);
  return p;
}

Bytes udp_packet(const std::string& text, const MadeUpEnd& from, const MadeUpEnd& to) {
  Bytes p = ip_head(kUdp, 8 + text.size(), from, to);
  put(p, static_cast<std::uint32_t>(from.port), 2);
  put(p, static_cast<std::uint32_t>(to.port), 2);
  put(p, static_cast<std::uint32_t>(8 + text.size()), 2);
  put(p, 0, 2);
  p.insert(p.end(), text.begin(), text.end());
  seal(p, kUdp, 26);
  return p;
}

CaptureDump::CaptureDump(const std::filesystem::path& file)
    : name_(file.string()), out_(file, std::ios::binary) {
  if (!out_) throw DeviceError(name_ + ": cannot be written: " + std::strerror(errno));
  Bytes head;
  put(head, 0xa1b23c4d, 4);  // nanoseconds; written backwards it would say that the numbers are
  put(head, 2, 2), put(head, 4, 2);
  put(head, 0, 4), put(head, 0, 4);  // UTC, without a claim how exact
  put(head, kLongestPacket, 4);
  put(head, kRawIp, 4);
  write(head);
}

void CaptureDump::write(const Bytes& bytes) {
  out_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void CaptureDump::write(std::int64_t time_ns, const Bytes& packet) {
  const auto size = static_cast<std::uint32_t>(packet.size());
  Bytes head;
  put(head, static_cast<std::uint32_t>(time_ns / 1'000'000'000), 4);
  put(head, static_cast<std::uint32_t>(time_ns % 1'000'000'000), 4);
  put(head, size, 4), put(head, size, 4);  // what is here, and what there was
  write(head), write(packet);
}

void CaptureDump::flush() {
  if (!out_.flush()) throw DeviceError(name_ + ": cannot be written");
}

}  // namespace rigsound::log
