#include "rigsound/log/udp_capture.hpp"

#include <algorithm>

#include "log/capture_file.hpp"
#include "log/ip_packet.hpp"

namespace rigsound::log {

UdpCapture::UdpCapture(const LogFile& file, std::vector<int> ports)
    : file_(std::make_unique<CaptureFile>(file)), ports_(std::move(ports)) {}

UdpCapture::~UdpCapture() = default;

double UdpCapture::share() const { return file_->share(); }

bool UdpCapture::next(TimedDatagram& datagram) {
  CapturedPacket captured;
  while (file_->next(captured)) {
    const auto packet = parse_udp_packet(captured.link_type, captured.bytes.data(), captured.bytes.size());
    if (!packet || packet->size == 0) continue;
    const bool wanted = ports_.empty()
                            ? packet->data[0] == '{'
                            : std::find(ports_.begin(), ports_.end(), packet->to.port) != ports_.end();
    if (!wanted) continue;
    datagram = {captured.time_ns, packet->to.port,
                std::string(reinterpret_cast<const char*>(packet->data), packet->size)};
    return true;
  }
  return false;
}

}  // namespace rigsound::log
