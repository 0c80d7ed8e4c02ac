#include "rigsound/log/udp_log.hpp"

#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

std::vector<int> ports_of(const std::vector<udp::UdpOptions>& inputs) {
  std::vector<int> ports;
  for (const udp::UdpOptions& input : inputs) ports.push_back(input.port);
  return ports;
}

bool has_datagrams(const LogFile& file, const std::vector<int>& ports) {
  UdpCapture capture(file, ports);
  TimedDatagram datagram;
  return capture.next(datagram);
}

}  // namespace

UdpLog::UdpLog(LogFile file, const std::vector<udp::UdpOptions>& inputs, const LogOptions& options)
    : file_(std::move(file)), entries_(options.longest_gap_s) {
  std::vector<int> ports = ports_of(inputs);
  const bool named = has_datagrams(file_, ports);
  if (!named && inputs.size() == 1) ports.clear();
  for (const udp::UdpOptions& input : inputs)
    inputs_.emplace(ports.empty() ? 0 : input.port, Input{udp::DatagramReader(input.routes), {}});
  capture_.emplace(file_, ports);
  survey(inputs);
  capture_.emplace(file_, ports);
}

std::optional<udp::DatagramContent> UdpLog::read(const TimedDatagram& datagram, double time_s,
                                                 std::string& problem) {
  const auto input = inputs_.find(inputs_.count(0) != 0 ? 0 : datagram.port);
  if (input == inputs_.end()) return std::nullopt;
  return input->second.reader.read(datagram.text, time_s, problem);
}

/// Reads as far as the first value that is of use.
void UdpLog::survey(const std::vector<udp::UdpOptions>& inputs) {
  SignalBoard scratch;
  TimedDatagram datagram;
  std::uint64_t seen = 0;
  std::string problem, unknown, refused;
  while (capture_->next(datagram)) {
    ++seen;
    const auto content = read(datagram, 0, problem);
    if (!content) continue;
    if (unknown.empty()) unknown = content->unknown;
    for (const Reading& reading : content->readings) {
      if (scratch.take(reading) == Validity::kValid) return;
      if (refused.empty())
        refused = std::string(info(reading.id.signal).name) + " is " + number_text(reading.value);
    }
  }
  if (seen == 0)
    throw InputError(file_.name(),
                     "holds no datagram to " + inputs.front().address + ", expected those of the [[udp]]");
  const std::string nearest = !refused.empty()   ? refused + ", which it cannot be"
                              : !unknown.empty() ? "'" + unknown + "' is no signal of the rig"
                              : !problem.empty() ? "they are no JSON object of signals: " + problem
                                                 : "they are empty";
  throw InputError(file_.name(),
                   "none of its " + std::to_string(seen) + " datagrams is of use to the rig: " + nearest);
}

std::optional<double> UdpLog::next_s() {
  return entries_.front(*capture_) != nullptr ? std::optional<double>(entries_.time_s()) : std::nullopt;
}

bool UdpLog::read_until(double until_s, SignalBoard& board) {
  bool told = false;
  while (const TimedDatagram* datagram = entries_.front(*capture_)) {
    const double time_s = entries_.time_s();
    if (time_s > until_s) break;
    ++seen_;
    std::string problem;
    const auto content = read(*datagram, time_s, problem);
    const int port = inputs_.count(0) != 0 ? 0 : datagram->port;
    entries_.pop();
    if (!content) {
      ++bad_;
      continue;
    }
    if (content->unknown_count > 0 && unknown_ == 0) first_unknown_ = content->unknown;
    unknown_ += content->unknown_count;
    if (content->sequence && !inputs_.at(port).sequence.passes(*content->sequence, time_s)) {
      ++late_;
      continue;
    }
    bool good = false;
    for (const Reading& reading : content->readings) good = board.take(reading) == Validity::kValid || good;
    used_ += good ? 1 : 0;
    told = told || !content->readings.empty();
  }
  return told;
}

std::vector<LogNote> UdpLog::notes() const {
  const auto text = [](std::uint64_t n) { return std::to_string(n); };
  std::vector<LogNote> notes = {
      {text(seen_) + " datagrams in " + seconds_text(entries_.time_s()) + " s, " + text(used_) + " used"}};
  if (bad_ > 0) notes.push_back({text(bad_) + " datagrams are no JSON object of signals"});
  if (late_ > 0) notes.push_back({text(late_) + " datagrams came after a newer one and were left out"});
  if (unknown_ > 0)
    notes.push_back(
        {text(unknown_) + " names are no signal of the rig, the first is '" + first_unknown_ + "'"});
  const std::vector<LogNote> of_clock = entries_.clock().notes();
  notes.insert(notes.end(), of_clock.begin(), of_clock.end());
  return notes;
}

}  // namespace rigsound::log
