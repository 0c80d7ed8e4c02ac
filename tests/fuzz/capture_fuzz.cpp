// Any bytes as a pcap or a pcapng: no crash, no packet outside of the file, and whatever is in it is read as
// CAN, Modbus and UDP. The mutator knows the records of a pcap.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "fuzz_target.hpp"
#include "log/can_capture.hpp"
#include "log/capture_file.hpp"
#include "memory_file.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/udp_capture.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

namespace {

constexpr std::size_t kFileHead = 24, kRecordHead = 16, kSizeAt = 8;

/// Where the records of a pcap of this machine's byte order begin; empty for any other input.
std::vector<std::size_t> records_of(const std::string& bytes) {
  std::vector<std::size_t> at;
  if (bytes.compare(0, 4, "\xd4\xc3\xb2\xa1") != 0) return at;
  for (std::size_t i = kFileHead; i + kRecordHead <= bytes.size();) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + i + kSizeAt, sizeof size);
    if (size > bytes.size() - i - kRecordHead) break;
    at.push_back(i);
    i += kRecordHead + size;
  }
  return at;
}

}  // namespace

/// Changes a packet and makes its length right; now and then a packet comes twice.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::vector<std::size_t> records = records_of(bytes);
  if (records.empty() || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::size_t chosen = seed / 4 % records.size(), at = records[chosen];
  const std::size_t end = chosen + 1 < records.size() ? records[chosen + 1] : bytes.size();
  std::string packet = bytes.substr(at + kRecordHead, end - at - kRecordHead);
  const std::size_t before = packet.size();
  packet.resize(before + 64);
  packet.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(packet.data()), before, packet.size()));
  const auto length = static_cast<std::uint32_t>(packet.size());
  std::memcpy(bytes.data() + at + kSizeAt, &length, sizeof length);
  const std::string record = bytes.substr(at, kRecordHead) + packet;
  bytes.replace(at, end - at, seed % 16 == 1 ? record + record : record);
  if (bytes.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile memory(data, size);
  fuzz::accepts<InputError>([&] {
    const log::LogFile file(memory.path());
    log::CaptureFile capture(file);
    log::CapturedPacket packet;
    while (capture.next(packet)) {
      if (packet.bytes.size() > size || packet.time_ns < 0) std::abort();
      const auto frame = log::parse_can_packet(packet);
      if (frame && frame->frame.size > 64) std::abort();
    }
  });
  fuzz::accepts<InputError>([&] {
    const log::LogFile file(memory.path());
    log::ModbusCapture capture(file, {{502, false}, {4001, true}});
    log::TimedExchange exchange;
    while (capture.next(exchange)) continue;
  });
  fuzz::accepts<InputError>([&] {
    const log::LogFile file(memory.path());
    log::UdpCapture capture(file, {});
    log::TimedDatagram datagram;
    while (capture.next(datagram)) continue;
  });
  return 0;
}
