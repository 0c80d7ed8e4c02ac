#include "rigsound/log/modbus_capture_writer.hpp"

#include <pcap/pcap.h>

#include <string>

#include "modbus/pdu.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kClientPort = 49152, kServerPort = 502;
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

/// IPv4 and TCP headers around `frame`, checksums included.
Bytes packet_of(const Bytes& frame, int from_port, int to_port, std::uint32_t sequence,
                std::uint32_t acknowledged) {
  Bytes p;
  put(p, 0x45000000U | static_cast<std::uint32_t>(40 + frame.size()), 4);
  put(p, 0x00004000, 4);  // no fragments
  put(p, 0x40060000, 4);  // 64 hops, TCP
  put(p, 0x7f000001, 4);
  put(p, 0x7f000001, 4);
  put(p, from_port, 2);
  put(p, to_port, 2);
  put(p, sequence, 4);
  put(p, acknowledged, 4);
  put(p, 0x5018ffff, 4);  // no options, PSH ACK, window
  put(p, 0, 4);
  p.insert(p.end(), frame.begin(), frame.end());
  set_word(p, 10, fold(ones_sum(p, 0, 20, 0)));
  const std::uint32_t pseudo = ones_sum(p, 12, 20, 6 + static_cast<std::uint32_t>(p.size() - 20));
  set_word(p, 36, fold(ones_sum(p, 20, p.size(), pseudo)));
  return p;
}

}  // namespace

struct ModbusCaptureWriter::File {
  std::string name;
  std::unique_ptr<pcap_t, void (*)(pcap_t*)> pcap{
      ::pcap_open_dead_with_tstamp_precision(DLT_RAW, kLongestPacket, PCAP_TSTAMP_PRECISION_NANO),
      ::pcap_close};
  std::unique_ptr<pcap_dumper_t, void (*)(pcap_dumper_t*)> out{nullptr, ::pcap_dump_close};
};

ModbusCaptureWriter::ModbusCaptureWriter(const std::filesystem::path& file)
    : file_(std::make_unique<File>()), client_{kClientPort}, server_{kServerPort} {
  file_->name = file.string();
  file_->out.reset(::pcap_dump_open(file_->pcap.get(), file.c_str()));
  if (!file_->out)
    throw DeviceError(file_->name + ": cannot be written: " + ::pcap_geterr(file_->pcap.get()));
}

ModbusCaptureWriter::~ModbusCaptureWriter() = default;

void ModbusCaptureWriter::write(std::int64_t time_ns, const modbus::Exchange& exchange) {
  ++transaction_;
  packet(time_ns, client_, server_, modbus::request_pdu(exchange), exchange.unit);
  packet(time_ns, server_, client_, modbus::answer_pdu(exchange), exchange.unit);
}

void ModbusCaptureWriter::packet(std::int64_t time_ns, Side& from, const Side& to, const Bytes& pdu,
                                 int unit) {
  Bytes frame;
  put(frame, transaction_, 2);
  put(frame, 0, 2);
  put(frame, static_cast<std::uint32_t>(pdu.size() + 1), 2);
  put(frame, static_cast<std::uint32_t>(unit), 1);
  frame.insert(frame.end(), pdu.begin(), pdu.end());
  const Bytes bytes = packet_of(frame, from.port, to.port, from.sequence, to.sequence);
  from.sequence += static_cast<std::uint32_t>(frame.size());
  pcap_pkthdr head{};
  head.ts.tv_sec = time_ns / 1'000'000'000;
  head.ts.tv_usec = time_ns % 1'000'000'000;  // nanoseconds, as the file says
  head.caplen = head.len = static_cast<bpf_u_int32>(bytes.size());
  ::pcap_dump(reinterpret_cast<u_char*>(file_->out.get()), &head, bytes.data());
}

void ModbusCaptureWriter::flush() {
  if (::pcap_dump_flush(file_->out.get()) != 0) throw DeviceError(file_->name + ": cannot be written");
}

}  // namespace rigsound::log
