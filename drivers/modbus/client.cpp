#include "modbus/client.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include "rigsound/device_error.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::modbus {
namespace {

constexpr std::int64_t kRound_ms = 200;

bool is_exception(int error) { return error >= EMBXILFUN && error <= EMBXGTAR; }

}  // namespace

Client::Client(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : ModbusBus(options, listener, tap), plan_(poll_plan(options.routes)) {}

void Client::step() {
  if (context_) return poll();
  if (may_open()) connect();
}

void Client::connect() {
  try {
    context_ = make_context(options_);
    if (modbus_connect(context_.get()) != 0)
      throw DeviceError(text(std::string("cannot be reached: ") + modbus_strerror(errno)));
    modbus_flush(context_.get());  // a serial line may still hold answers to what was asked before
    answered_ = false;
    next_poll_ms_ = monotonic_ms();
  } catch (const DeviceError& error) {
    context_.reset();
    open_failed(error.what());
  }
}

void Client::poll() {
  const std::int64_t left = next_poll_ms_ - monotonic_ms();
  if (left > 0) return std::this_thread::sleep_for(std::chrono::milliseconds(std::min(left, kRound_ms)));
  const auto period = std::max<std::int64_t>(1, static_cast<std::int64_t>(options_.poll_s * 1e3));
  next_poll_ms_ += period * (1 - left / period);  // a slow device loses polls, it does not gather them

  Exchange answer;
  for (const PollRequest& request : plan_) {
    if (!read(request, answer)) {
      if (!context_) return;
      continue;
    }
    if (!answered_) {
      answered_ = true;
      report_up();
    }
    report_exchange(answer);
  }
  opened();  // not before: a device that answers wrong now and then is asked less and less often
}

bool Client::read(const PollRequest& request, Exchange& answer) {
  answer = {options_.unit, request.table, false, request.address, {}};
  answer.values.resize(request.count);
  const bool bits = holds_bits(request.table);
  std::vector<std::uint8_t> bit_values(bits ? answer.values.size() : 0);
  modbus_t* const c = context_.get();
  int got = -1;
  switch (request.table) {
    case Table::kHolding:
      got = modbus_read_registers(c, request.address, request.count, answer.values.data());
      break;
    case Table::kInput:
      got = modbus_read_input_registers(c, request.address, request.count, answer.values.data());
      break;
    case Table::kCoil:
      got = modbus_read_bits(c, request.address, request.count, bit_values.data());
      break;
    case Table::kDiscrete:
      got = modbus_read_input_bits(c, request.address, request.count, bit_values.data());
      break;
  }
  if (bits) std::copy(bit_values.begin(), bit_values.end(), answer.values.begin());
  if (got == request.count) {
    count_.requests.fetch_add(1, std::memory_order_relaxed);
    return true;
  }
  const int error = errno;
  if (is_exception(error)) {
    count_.refused.fetch_add(1, std::memory_order_relaxed);
    warn(text(describe(request.table, request.address) + " (" + std::to_string(request.count) +
              "): " + modbus_strerror(error)));
    report_error_value(request);
  } else {
    lose(error);
  }
  return false;
}

// The device lives but has no such register, or no value for it.
void Client::report_error_value(const PollRequest& request) {
  const double now_s = monotonic_s();
  std::vector<Reading> values;
  for (const RegisterRoute& route : options_.routes) {
    const int offset = route.address - request.address;
    if (route.table == request.table && offset >= 0 && offset < request.count)
      values.push_back({route.target, 0, Validity::kErrorValue, now_s});
  }
  report(values);
}

// After a late or broken answer the stream is out of step: only a new connection, after a pause, is sure.
void Client::lose(int error) {
  if (error == EMBBADCRC || error == EMBBADDATA || error == EMBMDATA || error == EMBBADSLAVE)
    count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
  context_.reset();
  pause_before_reopening();
  const std::string why = text(modbus_strerror(error));
  if (answered_) {
    count_.lost.fetch_add(1, std::memory_order_relaxed);
    report_down(why);
  } else {
    report_problem(why);
  }
  answered_ = false;
}

}  // namespace rigsound::modbus
