#include "modbus/rtu_server.hpp"

#include <array>
#include <cerrno>

#include "modbus/rtu_frame.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::modbus {

RtuServer::RtuServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : ModbusServer(options, listener, tap) {}

void RtuServer::step() {
  if (!context_) {
    if (may_open()) open();
    return;
  }
  std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> frame{};
  const int size = modbus_receive(context_.get(), frame.data());
  if (size == 0) return;  // for another unit on the line
  if (size < 0) {
    const int error = errno;
    if (error == ETIMEDOUT) return;
    return error == EMBBADCRC || error == EMBBADDATA ? drop_bad_frame(error) : lose(error);
  }
  const std::size_t pdu_size = static_cast<std::size_t>(size) - kRtuEnds;
  if (respond(context_.get(), frame.data(), size, pdu_size, "serial line") == Reply::kFailed) lose(errno);
}

void RtuServer::open() {
  try {
    context_ = make_context(options());
    modbus_set_indication_timeout(context_.get(), 0, kRound_ms * 1000);
    if (modbus_connect(context_.get()) != 0)
      throw DeviceError(std::string("cannot be opened: ") + modbus_strerror(errno));
    opened();
    report_up();
  } catch (const DeviceError& error) {
    context_.reset();
    open_failed(error.what());
  }
}

// What follows a broken frame belongs to it: only a silent line starts the next one.
void RtuServer::drop_bad_frame(int error) {
  count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
  warn("bad frame", modbus_strerror(error));
  modbus_flush(context_.get());
}

void RtuServer::lose(int error) {
  count_.lost.fetch_add(1, std::memory_order_relaxed);
  context_.reset();
  pause_before_reopening();
  report_down(modbus_strerror(error));
}

}  // namespace rigsound::modbus
