#include "rigsound/log/modbus_capture_writer.hpp"

#include <algorithm>
#include <array>

#include "log/capture_dump.hpp"
#include "modbus/pdu.hpp"

namespace rigsound::log {
namespace {

constexpr int kServerPort = 502;

std::uint8_t high(std::size_t word) { return static_cast<std::uint8_t>(word >> 8 & 0xff); }
std::uint8_t low(std::size_t word) { return static_cast<std::uint8_t>(word & 0xff); }

}  // namespace

ModbusCaptureWriter::ModbusCaptureWriter(const std::filesystem::path& file)
    : file_(std::make_unique<CaptureDump>(file)), client_{kMadeUpClientPort}, server_{kServerPort} {}

ModbusCaptureWriter::~ModbusCaptureWriter() = default;

void ModbusCaptureWriter::write(std::int64_t time_ns, const modbus::Exchange& exchange) {
  ++transaction_;
  packet(time_ns, client_, server_, modbus::request_pdu(exchange), exchange.unit);
  packet(time_ns, server_, client_, modbus::answer_pdu(exchange), exchange.unit);
}

void ModbusCaptureWriter::packet(std::int64_t time_ns, Side& from, const Side& to,
                                 const std::vector<std::uint8_t>& pdu, int unit) {
  const std::size_t length = pdu.size() + 1;
  const std::array<std::uint8_t, 7> mbap = {high(transaction_),
                                            low(transaction_),
                                            0,
                                            0,
                                            high(length),
                                            low(length),
                                            static_cast<std::uint8_t>(unit)};
  std::vector<std::uint8_t> frame(mbap.size() + pdu.size());
  std::copy(pdu.begin(), pdu.end(), std::copy(mbap.begin(), mbap.end(), frame.begin()));
  file_->write(time_ns, tcp_packet(frame, from.port, to.port, from.sequence, to.sequence));
  from.sequence += static_cast<std::uint32_t>(frame.size());
}

void ModbusCaptureWriter::flush() { file_->flush(); }

}  // namespace rigsound::log
