#include "modbus/rtu_server.hpp"

#include <array>
#include <cerrno>

#include "rigsound/device_error.hpp"

namespace rigsound::modbus {
namespace {

constexpr std::uint32_t kRound_us = 200'000;
constexpr int kUnitAndChecksum = 3;  // bytes around the PDU of an RTU frame

}  // namespace

RtuServer::RtuServer(const ModbusOptions& options, ModbusListener& listener)
    : options_(options),
      listener_(listener),
      complaints_([this](const std::string& text) { listener_.notice(text); }),
      responder_(options, listener, complaints_) {}

void RtuServer::step() {
  if (!context_) return backoff_.due() ? open() : backoff_.wait();
  std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> frame{};
  const int size = modbus_receive(context_.get(), frame.data());
  if (size == 0) return;  // for another unit on the line
  if (size < 0) {
    const int error = errno;
    if (error == ETIMEDOUT) return;
    return error == EMBBADCRC || error == EMBBADDATA ? garbled(error) : lose(error);
  }
  const auto pdu_size = static_cast<std::size_t>(size - kUnitAndChecksum);
  switch (responder_.respond(context_.get(), frame.data(), size, pdu_size, "serial line")) {
    case Responder::Outcome::kAnswered:
      count_.requests.fetch_add(1, std::memory_order_relaxed);
      break;
    case Responder::Outcome::kRefused:
      count_.refused.fetch_add(1, std::memory_order_relaxed);
      break;
    case Responder::Outcome::kNotSent:
      lose(errno);
  }
}

void RtuServer::open() {
  try {
    context_ = make_context(options_);
    modbus_set_indication_timeout(context_.get(), 0, kRound_us);
    if (modbus_connect(context_.get()) != 0)
      throw DeviceError("modbus " + options_.address + ": cannot be opened: " + modbus_strerror(errno));
    backoff_.worked();
    last_problem_.clear();
    listener_.up();
  } catch (const DeviceError& error) {
    context_.reset();
    backoff_.failed();
    if (last_problem_ != error.what()) listener_.notice(error.what());
    last_problem_ = error.what();
  }
}

// What follows a broken frame belongs to it: only a silent line starts the next one.
void RtuServer::garbled(int error) {
  count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
  complaints_.add("modbus " + options_.address + ": " + modbus_strerror(error));
  modbus_flush(context_.get());
}

void RtuServer::lose(int error) {
  count_.lost.fetch_add(1, std::memory_order_relaxed);
  context_.reset();
  backoff_.failed();
  listener_.down("modbus " + options_.address + ": " + modbus_strerror(error));
}

}  // namespace rigsound::modbus
