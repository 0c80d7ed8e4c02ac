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
    : file_(std::move(file)), clock_(options.longest_gap_s) {
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

void UdpLog::fetch() {
  if (pending_) return;
  const auto read_ahead = [this] {
    TimedDatagram next;
    ahead_ = capture_->next(next) ? std::optional<TimedDatagram>(std::move(next)) : std::nullopt;
  };
  if (!started_) read_ahead();
  started_ = true;
  if (!ahead_) return;
  pending_ = std::move(ahead_);
  read_ahead();
  const auto next_ns = ahead_ ? std::optional<std::int64_t>(ahead_->time_ns) : std::nullopt;
  time_s_ = static_cast<double>(clock_.place(pending_->time_ns, next_ns, 0)) * 1e-9;
}

std::optional<double> UdpLog::next_s() {
  fetch();
  return pending_ ? std::optional<double>(time_s_) : std::nullopt;
}

bool UdpLog::read_until(double until_s, SignalBoard& board) {
  bool told = false;
  for (fetch(); pending_ && time_s_ <= until_s; fetch()) {
    ++seen_;
    std::string problem;
    const auto content = read(*pending_, time_s_, problem);
    const int port = inputs_.count(0) != 0 ? 0 : pending_->port;
    pending_.reset();
    if (!content) {
      ++bad_;
      continue;
    }
    if (content->unknown_count > 0 && unknown_ == 0) first_unknown_ = content->unknown;
    unknown_ += content->unknown_count;
    if (content->sequence && !inputs_.at(port).sequence.passes(*content->sequence, time_s_)) {
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
      {text(seen_) + " datagrams in " + seconds_text(time_s_) + " s, " + text(used_) + " used"}};
  if (bad_ > 0) notes.push_back({text(bad_) + " datagrams are no JSON object of signals"});
  if (late_ > 0) notes.push_back({text(late_) + " datagrams came after a newer one and were left out"});
  if (unknown_ > 0)
    notes.push_back(
        {text(unknown_) + " names are no signal of the rig, the first is '" + first_unknown_ + "'"});
  const std::vector<LogNote> of_clock = clock_.notes();
  notes.insert(notes.end(), of_clock.begin(), of_clock.end());
  return notes;
}

}  // namespace rigsound::log
