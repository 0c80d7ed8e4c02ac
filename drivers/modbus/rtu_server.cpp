#include "modbus/rtu_server.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "modbus/rtu_frame.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::modbus {
namespace {

constexpr int kAdapter_ms = 20;         // USB adapters pass bytes on every 16 ms
constexpr int kSilentBits_ms = 38'500;  // 3.5 characters of 11 bits, times the baud rate

}  // namespace

RtuServer::RtuServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : ModbusServer(options, listener, tap), silence_ms_(kAdapter_ms + kSilentBits_ms / options.baud) {}

void RtuServer::step() {
  if (!context_) {
    if (may_open()) open();
    return;
  }
  const bool waiting = filled_ > 0 || overflowed_;
  const int fd = modbus_get_socket(context_.get());
  if (stop_event().wait(fd, POLLIN, waiting ? silence_ms_ : kRound_ms))
    receive();
  else if (waiting && !stopped())
    end_of_bytes();
}

void RtuServer::open() {
  try {
    context_ = make_context(options());
    if (modbus_connect(context_.get()) != 0)
      throw DeviceError(std::string("cannot be opened: ") + modbus_strerror(errno));
    filled_ = 0;
    overflowed_ = false;
    opened();
    report_up();
  } catch (const DeviceError& error) {
    context_.reset();
    open_failed(error.what());
  }
}

void RtuServer::receive() {
  const int fd = modbus_get_socket(context_.get());
  const ssize_t got = ::read(fd, bytes_.data() + filled_, bytes_.size() - filled_);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (got <= 0) return lose(got == 0 ? ECONNRESET : errno);
  filled_ += static_cast<std::size_t>(got);
  while (context_ && take_frame()) continue;
  if (filled_ < bytes_.size()) return;
  overflowed_ = true;
  filled_ = 0;
}

/// A request, or what another unit answers. Where neither begins, only a silent line starts the next frame.
bool RtuServer::take_frame() {
  for (const RtuSide side : {RtuSide::kRequest, RtuSide::kAnswer}) {
    const std::size_t size = rtu_frame_size(side, bytes_.data(), filled_).value_or(0);
    if (size == 0 || filled_ < size || !rtu_checksum_holds(bytes_.data(), size)) continue;
    if (side == RtuSide::kRequest && !overflowed_ && ours(bytes_[0])) obey(size);
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(size),
              bytes_.begin() + static_cast<std::ptrdiff_t>(filled_), bytes_.begin());
    filled_ -= size;
    return true;
  }
  return false;
}

/// What came in one piece and is whole all the same is of a function that is not served.
void RtuServer::end_of_bytes() {
  if (overflowed_ || !rtu_checksum_holds(bytes_.data(), filled_)) {
    count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
    warn("bad frame", modbus_strerror(EMBBADCRC));
  } else if (ours(bytes_[0])) {
    obey(filled_);
  }
  filled_ = 0;
  overflowed_ = false;
}

void RtuServer::obey(std::size_t size) {
  const Reply reply =
      respond(context_.get(), bytes_.data(), static_cast<int>(size), size - kRtuEnds, "serial line");
  if (reply == Reply::kFailed) lose(errno);
}

bool RtuServer::ours(int unit) const { return unit == options().unit || unit == MODBUS_BROADCAST_ADDRESS; }

void RtuServer::lose(int error) {
  count_.lost.fetch_add(1, std::memory_order_relaxed);
  context_.reset();
  pause_before_reopening();
  report_down(modbus_strerror(error));
}

}  // namespace rigsound::modbus
