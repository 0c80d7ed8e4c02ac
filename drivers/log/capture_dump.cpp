#include "log/capture_dump.hpp"

#include <pcap/pcap.h>

#include "log/ip_packet.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kLongestPacket = 65535;

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

struct CaptureDump::File {
  std::string name;
  std::unique_ptr<pcap_t, void (*)(pcap_t*)> pcap{
      ::pcap_open_dead_with_tstamp_precision(DLT_RAW, kLongestPacket, PCAP_TSTAMP_PRECISION_NANO),
      ::pcap_close};
  std::unique_ptr<pcap_dumper_t, void (*)(pcap_dumper_t*)> out{nullptr, ::pcap_dump_close};
};

CaptureDump::CaptureDump(const std::filesystem::path& file) : file_(std::make_unique<File>()) {
  file_->name = file.string();
  file_->out.reset(::pcap_dump_open(file_->pcap.get(), file.c_str()));
  if (!file_->out)
    throw DeviceError(file_->name + ": cannot be written: " + ::pcap_geterr(file_->pcap.get()));
}

CaptureDump::~CaptureDump() = default;

void CaptureDump::write(std::int64_t time_ns, const Bytes& packet) {
  pcap_pkthdr head{};
  head.ts.tv_sec = time_ns / 1'000'000'000;
  head.ts.tv_usec = time_ns % 1'000'000'000;  // nanoseconds, as the file says
  head.caplen = head.len = static_cast<bpf_u_int32>(packet.size());
  ::pcap_dump(reinterpret_cast<u_char*>(file_->out.get()), &head, packet.data());
}

void CaptureDump::flush() {
  if (::pcap_dump_flush(file_->out.get()) != 0) throw DeviceError(file_->name + ": cannot be written");
}

}  // namespace rigsound::log
