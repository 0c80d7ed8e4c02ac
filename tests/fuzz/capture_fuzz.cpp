// Any bytes as a pcap or a pcapng: no crash, no packet outside of the file, and whatever is in it is read as
// CAN, Modbus and UDP.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "fuzz_target.hpp"
#include "log/can_capture.hpp"
#include "log/capture_file.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/udp_capture.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

namespace {

template <class Read>
void tolerate(Read read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileDescriptor memory(::memfd_create("capture", 0));
  if (!memory || ::write(memory.get(), data, size) != static_cast<ssize_t>(size)) return 0;
  const std::string path = "/proc/self/fd/" + std::to_string(memory.get());
  tolerate([&] {
    const log::LogFile file(path);
    log::CaptureFile capture(file);
    log::CapturedPacket packet;
    while (capture.next(packet)) {
      if (packet.bytes.size() > size || packet.time_ns < 0) std::abort();
      const auto frame = log::parse_can_packet(packet);
      if (frame && frame->frame.size > 64) std::abort();
    }
  });
  tolerate([&] {
    const log::LogFile file(path);
    log::ModbusCapture capture(file, {{502, false}, {4001, true}});
    log::TimedExchange exchange;
    while (capture.next(exchange)) continue;
  });
  tolerate([&] {
    const log::LogFile file(path);
    log::UdpCapture capture(file, {});
    log::TimedDatagram datagram;
    while (capture.next(datagram)) continue;
  });
  return 0;
}
