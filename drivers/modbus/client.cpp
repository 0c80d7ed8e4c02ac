#include "modbus/client.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "rigsound/device_error.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::modbus {
namespace {

bool is_bad_frame(int error) {
  return error == EMBBADCRC || error == EMBBADDATA || error == EMBMDATA || error == EMBBADSLAVE;
}

std::int64_t milliseconds(double seconds) { return static_cast<std::int64_t>(std::lround(seconds * 1e3)); }

std::vector<RegisterRoute> routes_of(const Line& line) {
  std::vector<RegisterRoute> all;
  for (const ModbusOptions& unit : line) all.insert(all.end(), unit.routes.begin(), unit.routes.end());
  return all;
}

}  // namespace

Client::Client(const Line& line, BusListener& listener, ModbusTap* tap)
    : ModbusBus(line.front().address, routes_of(line), listener, tap) {
  for (const ModbusOptions& unit : line) units_.emplace_back(unit);
  last_ = units_.size() - 1;
}

void Client::step() {
  tell_silence();
  if (!link_) {
    if (may_open()) connect();
    return;
  }
  const std::size_t next = next_unit(monotonic_ms());
  if (!wait_until(units_[next].next_poll_ms)) return;
  last_ = next;
  poll(units_[next]);
}

/// Waits up to one round; returns whether the time has come.
bool Client::wait_until(std::int64_t due_ms) const {
  const std::int64_t left_ms = due_ms - monotonic_ms();
  if (left_ms > 0) stop_event().wait(-1, 0, static_cast<int>(std::min<std::int64_t>(left_ms, kRound_ms)));
  return left_ms <= kRound_ms && !stopped();
}

/// Those that are due in turn; when none is, the one that will be first.
std::size_t Client::next_unit(std::int64_t now_ms) const {
  std::size_t first = 0;
  for (std::size_t i = 1; i <= units_.size(); ++i) {
    const std::size_t candidate = (last_ + i) % units_.size();
    if (units_[candidate].next_poll_ms <= now_ms) return candidate;
    if (i == 1 || units_[candidate].next_poll_ms < units_[first].next_poll_ms) first = candidate;
  }
  return first;
}

bool Client::connect() {
  const ModbusOptions& options = units_.front().options;
  try {
    link_ = std::make_unique<ClientLink>(options, stop_event());
    answered_ = false;
    next_request_ms_ = monotonic_ms() + milliseconds(options.pause_s);
    return true;
  } catch (const DeviceError& error) {
    if (stopped()) return false;
    last_problem_ = error.what();
    open_failed(last_problem_);
    return false;
  }
}

void Client::poll(Unit& unit) {
  const std::int64_t period_ms = std::max<std::int64_t>(1, milliseconds(unit.options.poll_s));
  const std::int64_t now_ms = monotonic_ms();
  const std::int64_t late_ms = unit.next_poll_ms == 0 ? 0 : now_ms - unit.next_poll_ms;
  // A slow device loses polls, it does not gather them.
  unit.next_poll_ms = now_ms - late_ms % period_ms + period_ms;
  const std::vector<PollRequest> plan = unit.plan;  // what is refused changes it
  for (const PollRequest& request : plan) {
    switch (ask(unit, request)) {
      case Outcome::kAnswered:
      case Outcome::kRefused:
        break;
      case Outcome::kSilent:
        unit.pause.failed(monotonic_ms());
        unit.next_poll_ms = monotonic_ms() + unit.pause.left_ms(monotonic_ms());
        return;
      case Outcome::kLost:
        return;
    }
  }
  unit.pause.worked(monotonic_ms());
  opened();  // not before: a device that answers wrong now and then is asked less and less often
}

Client::Outcome Client::ask(Unit& unit, const PollRequest& request) {
  Exchange answer;
  for (;;) {
    if (!link_ && !connect()) return Outcome::kLost;
    while (!wait_until(next_request_ms_))
      if (stopped()) return Outcome::kLost;
    const int error = link_->read(unit.options.unit, request, answer);
    if (stopped()) return Outcome::kLost;
    next_request_ms_ = monotonic_ms() + milliseconds(unit.options.pause_s);
    if (error == 0) {
      take(unit, answer);
      return Outcome::kAnswered;
    }
    if (is_exception(error)) {
      answered_ = true;
      refused(unit, request, error);
      return Outcome::kRefused;
    }
    const bool closed_after_an_answer = answered_ && error != ETIMEDOUT && !is_bad_frame(error);
    if (!closed_after_an_answer) return after_error(unit, error);
    drop(error);  // as some devices do each time: once more on a connection of its own
  }
}

/// After a late or broken answer a TCP stream is out of step: only a new connection is sure. A serial line is
/// still there, and other units on it are none the worse.
Client::Outcome Client::after_error(Unit& unit, int error) {
  if (is_bad_frame(error)) count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
  last_problem_ = of_unit(unit, modbus_strerror(error));
  const bool serial = unit.options.transport == Transport::kRtu;
  if (serial && (error == ETIMEDOUT || is_bad_frame(error))) {
    if (!unit.delivers) report_problem(last_problem_);
    return Outcome::kSilent;
  }
  const bool had_answers = answered_;
  drop(error);
  if (!had_answers) pause_before_reopening();
  if (!up_) report_problem(last_problem_);
  return units_.size() > 1 && error == ETIMEDOUT ? Outcome::kSilent : Outcome::kLost;
}

void Client::drop(int error) {
  last_problem_ = modbus_strerror(error);
  link_.reset();
  answered_ = false;
}

void Client::take(Unit& unit, const Exchange& answer) {
  count_.requests.fetch_add(1, std::memory_order_relaxed);
  answered_ = true;
  unit.answered_s = monotonic_s();
  if (!up_) report_up();
  up_ = unit.delivers = true;
  report_exchange(answer, unit.options.routes);
}

/// The device lives, but has no such register, or no value for it.
void Client::refused(Unit& unit, const PollRequest& request, int error) {
  count_.refused.fetch_add(1, std::memory_order_relaxed);
  const bool has_hole = error == EMBXILADD || error == EMBXILVAL;
  if (has_hole && split(unit.plan, request, unit.options.routes)) {
    report_problem(of_unit(unit, describe(request.table, request.address) + " (" +
                                     std::to_string(request.count) + "): " + modbus_strerror(error) +
                                     "; asked for in parts from now on"));
    unit.next_poll_ms = monotonic_ms();
    return;
  }
  warn("refused", of_unit(unit, describe(request.table, request.address) + " (" +
                                    std::to_string(request.count) + "): " + modbus_strerror(error)));
  const double now_s = monotonic_s();
  std::vector<Reading> values;
  for (const RegisterRoute& route : unit.options.routes) {
    const int offset = route.address - request.address;
    if (route.table == request.table && offset >= 0 && offset < request.count)
      values.push_back({route.target, 0, Validity::kErrorValue, now_s});
  }
  report(values);
}

void Client::tell_silence() {
  const double now_s = monotonic_s();
  bool any_delivers = false;
  std::vector<Reading> unknown;
  std::string silent;
  for (Unit& unit : units_) {
    const bool silent_now = unit.delivers && now_s - unit.answered_s > unit.options.down_after_s;
    if (silent_now) {
      unit.delivers = false;
      silent = of_unit(unit, "no answer: " + last_problem_);
      for (const RegisterRoute& route : unit.options.routes)
        unknown.push_back({route.target, 0, Validity::kBusDown, now_s});
    }
    any_delivers = any_delivers || unit.delivers;
  }
  if (unknown.empty()) return;
  if (any_delivers) {
    report(unknown);
    warn("silent", silent);
    return;
  }
  up_ = false;
  count_.lost.fetch_add(1, std::memory_order_relaxed);
  report_down(last_problem_);
}

std::string Client::of_unit(const Unit& unit, const std::string& what) const {
  return units_.size() > 1 ? "unit " + std::to_string(unit.options.unit) + ": " + what : what;
}

}  // namespace rigsound::modbus
