#include "rigsound/log/modbus_log.hpp"

#include <algorithm>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr int kAnyUnit = 255;

}  // namespace

ModbusLog::ModbusLog(const std::filesystem::path& file, const std::vector<modbus::ModbusOptions>& buses)
    : capture_(file), buses_(buses) {
  fetch();
  if (!pending_)
    throw InputError(file.string(), "holds no Modbus/TCP exchange, expected requests and their answers");
  first_ns_ = pending_->time_ns;
}

void ModbusLog::fetch() {
  TimedExchange next;
  if (pending_ || !capture_.next(next)) return;
  if (first_ns_ != 0) time_s_ = std::max(time_s_, static_cast<double>(next.time_ns - first_ns_) * 1e-9);
  pending_ = std::move(next);
}

std::optional<double> ModbusLog::next_s() {
  fetch();
  return pending_ ? std::optional<double>(time_s_) : std::nullopt;
}

bool ModbusLog::read_until(double until_s, SignalBoard& board) {
  std::vector<Reading> readings;
  for (fetch(); pending_ && time_s_ <= until_s; fetch()) {
    const std::size_t before = readings.size();
    for (const modbus::ModbusOptions& bus : buses_)
      if (bus.unit == kAnyUnit || bus.unit == pending_->exchange.unit)
        modbus::readings(pending_->exchange, bus.routes, time_s_, readings);
    used_ += readings.size() == before ? 0 : 1;
    pending_.reset();
  }
  for (const Reading& reading : readings) board.take(reading);
  return !readings.empty();
}

std::vector<LogNote> ModbusLog::notes() const {
  const CaptureCounts& c = capture_.counts();
  const auto text = [](std::uint64_t n) { return std::to_string(n); };
  std::vector<LogNote> notes = {
      {text(c.exchanges) + " exchanges in " + seconds_text(time_s_) + " s, " + text(used_) + " used"}};
  if (c.refused > 0) notes.push_back({text(c.refused) + " requests were refused by the device"});
  if (c.unpaired > 0) notes.push_back({text(c.unpaired) + " answers fit no request of the capture"});
  if (c.other_functions > 0)
    notes.push_back({text(c.other_functions) + " requests neither read nor wrote values"});
  if (c.other > 0) notes.push_back({text(c.other) + " packets are no Modbus/TCP"});
  return notes;
}

}  // namespace rigsound::log
