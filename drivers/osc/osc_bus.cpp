#include "osc/osc_bus.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "rigsound/monotonic_time.hpp"

namespace rigsound::osc {
namespace {

constexpr double kFarthest_s = 10;
constexpr std::size_t kMostWaiting = 1024;

double realtime_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// NaN for a word that the signal does not have: the board refuses it, and counts.
double value_for(Signal signal, const Said& said) {
  if (const auto* const number = std::get_if<double>(&said)) return *number;
  return value_of_word(signal, std::get<std::string>(said)).value_or(std::nan(""));
}

}  // namespace

OscBus::OscBus(const OscOptions& options, BusListener& listener, ControlListener& controls)
    : DatagramBus("osc " + options.address, targets(options.routes),
                  {options.host, options.port, options.allow}, listener),
      addresses_(options),
      controls_(controls) {}

void OscBus::take(const Arrival& arrival) {
  std::string problem;
  auto messages = read_packet(arrival.bytes, problem);
  if (!messages) {
    count(bad_);
    return warn("bad", arrival.host + ": a datagram that is no OSC: " + problem);
  }
  for (Message& message : *messages) {
    const double ahead_s = message.due_s > 0 ? message.due_s - realtime_s() : 0;
    if (ahead_s > kFarthest_s)
      warn("time", arrival.host + ": a bundle " + number_text(std::round(ahead_s)) +
                       " s ahead is taken at once, expected clocks that agree");
    if (ahead_s <= 0 || ahead_s > kFarthest_s) {
      obey(message, arrival.host, arrival.time_s);
    } else if (waiting_.size() < kMostWaiting) {
      waiting_.emplace(monotonic_s() + ahead_s, Waiting{std::move(message), arrival.host});
    } else {
      count(bad_);
      warn("waiting",
           arrival.host + ": over " + std::to_string(kMostWaiting) + " messages wait for their time");
    }
  }
}

double OscBus::after_round() {
  const double now_s = monotonic_s();
  while (!waiting_.empty() && waiting_.begin()->first <= now_s) {
    const Waiting due = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    obey(due.message, due.from, now_s);
  }
  return waiting_.empty() ? kLongestWait_s : std::min(kLongestWait_s, waiting_.begin()->first - now_s);
}

void OscBus::obey(const Message& message, const std::string& from, double time_s) {
  const std::vector<Target> targets = addresses_.find(message.path);
  if (targets.empty())
    return warn("unknown",
                from + ": '" + message.path +
                    "' is no address of the rig, expected /rigsound/SIGNAL, /rigsound/BOOM/SIGNAL, ...");
  bool all = true;
  for (const Target& target : targets) all = obey(target, message.said, time_s) && all;
  count(all ? used_ : bad_);
  if (!all) warn("value", from + ": " + message.path + " was told what it cannot be");
}

/// Returns false for what a control or the mute cannot be. A signal's value is judged by the board.
bool OscBus::obey(const Target& target, const Said& said, double time_s) {
  const auto* const number = std::get_if<double>(&said);
  const bool nothing = std::holds_alternative<std::monostate>(said);
  switch (target.kind) {
    case Target::Kind::kSignal:
      deliver({target.signal, nothing ? 0 : value_for(target.signal.signal, said),
               nothing ? Validity::kNotAvailable : Validity::kValid, time_s});
      return true;
    case Target::Kind::kControl:
      if (number == nullptr || !target.control->range().holds(*number)) return false;
      controls_.control(target.boom, *target.control, *number);
      return true;
    case Target::Kind::kMute:
      if (number == nullptr || (*number != 0 && *number != 1)) return false;
      controls_.mute(*number == 1);
      return true;
  }
  return false;
}

std::unique_ptr<Bus> make_bus(const OscOptions& options, BusListener& listener, ControlListener& controls) {
  return std::make_unique<OscBus>(options, listener, controls);
}

}  // namespace rigsound::osc
