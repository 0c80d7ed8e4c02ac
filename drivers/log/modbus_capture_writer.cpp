#include "rigsound/log/modbus_capture_writer.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <vector>

#include "log/capture_dump.hpp"
#include "modbus/pdu.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint8_t high(std::size_t word) { return static_cast<std::uint8_t>(word >> 8 & 0xff); }
std::uint8_t low(std::size_t word) { return static_cast<std::uint8_t>(word & 0xff); }

MadeUpEnd end_of(const HostPort& server) {
  in_addr address{};
  MadeUpEnd end{MadeUpEnd().address, server.port > 0 ? server.port : modbus::kPort};
  const bool literal = ::inet_pton(AF_INET, server.host.c_str(), &address) == 1;
  if (literal && address.s_addr != INADDR_ANY) end.address = ntohl(address.s_addr);
  return end;
}

/// Behind an MBAP header.
Bytes frame_of(std::uint16_t transaction, int unit, const Bytes& pdu) {
  const std::size_t length = pdu.size() + 1;
  const std::array<std::uint8_t, 7> mbap = {
      high(transaction), low(transaction), 0, 0, high(length), low(length), static_cast<std::uint8_t>(unit)};
  Bytes frame(mbap.size() + pdu.size());
  std::copy(pdu.begin(), pdu.end(), std::copy(mbap.begin(), mbap.end(), frame.begin()));
  return frame;
}

}  // namespace

ModbusCaptureWriter::ModbusCaptureWriter(const std::filesystem::path& file)
    : file_(std::make_unique<CaptureDump>(file)) {}

ModbusCaptureWriter::~ModbusCaptureWriter() = default;

void ModbusCaptureWriter::write(std::int64_t time_ns, const HostPort& server,
                                const modbus::Exchange& exchange) {
  ++transaction_;
  const MadeUpEnd client, end = end_of(server);
  Connection& c = connections_[{end.address, end.port}];
  const Bytes request = frame_of(transaction_, exchange.unit, modbus::request_pdu(exchange));
  file_->write(time_ns, tcp_packet(request, client, end, c.to_server, c.to_client));
  c.to_server += static_cast<std::uint32_t>(request.size());
  const Bytes answer = frame_of(transaction_, exchange.unit, modbus::answer_pdu(exchange));
  file_->write(time_ns, tcp_packet(answer, end, client, c.to_client, c.to_server));
  c.to_client += static_cast<std::uint32_t>(answer.size());
}

void ModbusCaptureWriter::flush() { file_->flush(); }

}  // namespace rigsound::log
