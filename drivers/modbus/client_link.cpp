#include "modbus/client_link.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "modbus/pdu.hpp"
#include "modbus/rtu_frame.hpp"
#include "modbus/tcp_frame.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/socket/tcp_connector.hpp"

namespace rigsound::modbus {
namespace {

constexpr std::int64_t kPause_ms = 500;  // within an answer that has begun

int error_of_exception(std::uint8_t code) {
  return code > 0 && code < MODBUS_EXCEPTION_MAX ? MODBUS_ENOBASE + code : EMBBADEXC;
}

}  // namespace

ClientLink::ClientLink(const ModbusOptions& options, const StopEvent& stop)
    : stop_(stop),
      rtu_(options.transport != Transport::kTcp),
      timeout_ms_(static_cast<int>(std::lround(options.timeout_s * 1e3))) {
  if (options.transport != Transport::kRtu) {
    socket_ = connect_tcp({options.host, options.port}, options.timeout_s, stop);
    return;
  }
  serial_ = make_context(options);
  if (modbus_connect(serial_.get()) != 0)
    throw DeviceError(std::string("cannot be reached: ") + modbus_strerror(errno));
}

int ClientLink::fd() const { return socket_ ? socket_.get() : modbus_get_socket(serial_.get()); }

int ClientLink::read(int unit, const PollRequest& request, Exchange& answer) {
  answer = {unit, request.table, false, request.address, {}};
  answer.values.resize(request.count);
  std::vector<std::uint8_t> question = request_pdu(answer);
  const std::uint8_t function = question.front();
  question.insert(question.begin(), static_cast<std::uint8_t>(unit));
  drain();
  if (const int error = send(std::move(question)); error != 0) return error;
  if (const int error = receive(); error != 0) return error;
  return take(unit, function, answer);
}

/// A late answer to what was asked before is no answer.
void ClientLink::drain() {
  while (!stop_.is_set() && ::read(fd(), bytes_.data(), bytes_.size()) > 0) continue;
}

int ClientLink::send(std::vector<std::uint8_t> frame) {
  if (rtu_) {
    const std::uint16_t checksum = rtu_checksum(frame.data(), frame.size());
    frame.push_back(static_cast<std::uint8_t>(checksum & 0xff));
    frame.push_back(static_cast<std::uint8_t>(checksum >> 8));
  } else {
    ++transaction_;
    frame.insert(frame.begin(), {static_cast<std::uint8_t>(transaction_ >> 8),
                                 static_cast<std::uint8_t>(transaction_ & 0xff), 0, 0, 0,
                                 static_cast<std::uint8_t>(frame.size())});
  }
  const ssize_t sent = socket_ ? ::send(fd(), frame.data(), frame.size(), MSG_NOSIGNAL)
                               : ::write(fd(), frame.data(), frame.size());
  if (sent < 0) return errno;
  return sent == static_cast<ssize_t>(frame.size()) ? 0 : EAGAIN;
}

int ClientLink::receive() {
  filled_ = 0;
  std::int64_t end_ms = monotonic_ms() + timeout_ms_;
  for (;;) {
    const auto size = rtu_ ? rtu_frame_size(RtuSide::kAnswer, bytes_.data(), filled_)
                           : tcp_frame_size(bytes_.data(), filled_);
    if (!size) return EMBBADDATA;
    frame_ = *size;
    if (frame_ > 0 && filled_ >= frame_) return 0;
    const std::int64_t now_ms = monotonic_ms();
    if (const int error = receive_some(static_cast<int>(std::max<std::int64_t>(0, end_ms - now_ms)));
        error != 0)
      return error;
    end_ms = std::max(end_ms, monotonic_ms() + kPause_ms);
  }
}

int ClientLink::receive_some(int timeout_ms) {
  if (!stop_.wait(fd(), POLLIN, timeout_ms)) return stop_.is_set() ? ECANCELED : ETIMEDOUT;
  const ssize_t got = ::read(fd(), bytes_.data() + filled_, bytes_.size() - filled_);
  if (got == 0) return ECONNRESET;
  if (got < 0) return errno == EAGAIN || errno == EINTR ? 0 : errno;
  filled_ += static_cast<std::size_t>(got);
  return 0;
}

int ClientLink::take(int unit, std::uint8_t function, Exchange& answer) const {
  const std::uint8_t* const pdu = bytes_.data() + (rtu_ ? 1 : kMbap);
  const std::size_t size = frame_ - (rtu_ ? kRtuEnds : kMbap);
  if (rtu_) {
    if (!rtu_checksum_holds(bytes_.data(), frame_)) return EMBBADCRC;
    if (bytes_[0] != unit) return EMBBADSLAVE;
  } else if ((bytes_[0] << 8 | bytes_[1]) != transaction_) {
    return EMBBADDATA;
  }
  if (pdu[0] == (function | 0x80)) return size == 2 ? error_of_exception(pdu[1]) : EMBBADDATA;
  if (pdu[0] != function) return EMBBADDATA;
  return take_read(pdu, size, answer) ? 0 : EMBBADDATA;
}

}  // namespace rigsound::modbus
