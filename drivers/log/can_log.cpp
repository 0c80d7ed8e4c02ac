#include "rigsound/log/can_log.hpp"

#include <algorithm>
#include <set>

#include "can/source_watch.hpp"
#include "log/can_survey.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

/// Which bus of the rig an interface of the log is. A pair that is the wrong way round is turned.
std::map<std::string, const can::CanOptions*> buses_by_interface(const std::vector<can::CanOptions>& buses,
                                                                 const LogOptions& options) {
  const auto of_rig = [&](const std::string& name) {
    const auto found = std::find_if(buses.begin(), buses.end(),
                                    [&](const can::CanOptions& bus) { return bus.interface == name; });
    return found == buses.end() ? nullptr : &*found;
  };
  std::map<std::string, const can::CanOptions*> by_interface;
  for (const can::CanOptions& bus : buses) by_interface[bus.interface] = &bus;
  for (const auto& [first, second] : options.interfaces) {
    if (const can::CanOptions* bus = of_rig(second))
      by_interface[first] = bus;
    else if (const can::CanOptions* turned = of_rig(first))
      by_interface[second] = turned;
    else
      throw InputError(std::string("--can ").append(first).append("=").append(second),
                       "names no interface of the rig, expected LOG_INTERFACE=RIG_INTERFACE");
  }
  return by_interface;
}

}  // namespace

CanLog::CanLog(LogFile file, const std::vector<can::CanOptions>& buses, const LogOptions& options)
    : file_(std::move(file)), clock_(options.longest_gap_s) {
  find_buses(buses, options);
  reader_ = open_can_reader(file_);
}

/// Reads the log as far as the first value that is of use.
void CanLog::find_buses(const std::vector<can::CanOptions>& buses, const LogOptions& options) {
  auto by_interface = buses_by_interface(buses, options);
  std::set<std::string> seen, wanted;
  for (const auto& [interface, bus] : by_interface) wanted.insert(interface);
  std::optional<CanSurvey> survey;
  const auto useful = [&] {
    survey.emplace(buses);
    const auto reader = open_can_reader(file_);
    CanRecord record;
    while (reader->next(record)) {
      seen.insert(record.interface);
      const auto bus = by_interface.find(record.interface);
      if (bus == by_interface.end())
        survey->add_foreign(record);
      else if (survey->add(*bus->second, record))
        return true;
    }
    return false;
  };
  bool good = useful();
  if (seen.empty())
    throw InputError(file_.name(),
                     "holds no CAN frame, expected a log of candump, ASC, TRC or a capture of SocketCAN; "
                     "can_logconvert of "
                     "python3-can makes a candump log of others");
  const bool any_wanted =
      std::any_of(seen.begin(), seen.end(), [&](const std::string& name) { return wanted.count(name) != 0; });
  if (!any_wanted && (buses.size() != 1 || seen.size() != 1))
    throw InputError(file_.name(), "has frames of " + list_of(seen) + " only, expected some of " +
                                       list_of(wanted) + ": --can " + *seen.begin() + "=" + *wanted.begin() +
                                       "?");
  if (!any_wanted) {
    by_interface[*seen.begin()] = &buses.front();
    good = useful();
  }
  if (!good)
    throw InputError(file_.name(), "none of its " + std::to_string(survey->frames()) +
                                       " frames is of use to the rig: " + survey->nearest());
  for (const auto& [interface, bus] : by_interface)
    buses_.emplace(interface, Bus{*bus, can::FrameDecoder(bus->routes),
                                  std::make_shared<can::SourceWatch>(bus->routes)});
}

void CanLog::read_ahead() {
  has_ahead_ = reader_->next(ahead_);
  ahead_line_ = reader_->line();
}

void CanLog::fetch() {
  if (has_pending_) return;
  if (!started_) read_ahead();
  started_ = true;
  if (!has_ahead_) return;
  std::swap(pending_, ahead_);
  has_pending_ = true;
  const int line = ahead_line_;
  read_ahead();
  const auto next_ns = has_ahead_ ? std::optional<std::int64_t>(ahead_.time_ns) : std::nullopt;
  time_s_ = static_cast<double>(clock_.place(pending_.time_ns, next_ns, line)) * 1e-9;
}

std::optional<double> CanLog::next_s() {
  fetch();
  return has_pending_ ? std::optional<double>(time_s_) : std::nullopt;
}

void CanLog::take_frame(SignalBoard& board) {
  readings_.clear();
  const auto bus = buses_.find(pending_.interface);
  if (bus == buses_.end()) return;
  if (!bus->second.decoder.decode(pending_.frame, time_s_, readings_)) return;
  if (pending_.frame.fd && !bus->second.options.fd) {
    ++fd_refused_;
    readings_.clear();
    return;
  }
  bus->second.sources->add(pending_.frame);
  bool good = false;
  for (const Reading& reading : readings_) good = board.take(reading) == Validity::kValid || good;
  used_ += good ? 1 : 0;
}

bool CanLog::read_until(double until_s, SignalBoard& board) {
  bool told = false;
  for (fetch(); has_pending_ && time_s_ <= until_s; fetch()) {
    take_frame(board);
    told = told || !readings_.empty();
    has_pending_ = false;
  }
  return told;
}

std::vector<LogNote> CanLog::notes() const {
  const CanCounts& counts = reader_->counts();
  const auto text = [](std::uint64_t n) { return std::to_string(n); };
  std::vector<LogNote> notes = {
      {text(counts.frames) + " frames in " + seconds_text(time_s_) + " s, " + text(used_) + " used"}};
  if (!reader_->remark().empty()) notes.push_back({reader_->remark()});
  if (counts.other > 0) notes.push_back({"skipped " + text(counts.other) + " lines that are no frame"});
  if (counts.xl > 0) notes.push_back({"skipped " + text(counts.xl) + " CAN XL frames"});
  if (counts.error_frames > 0) notes.push_back({text(counts.error_frames) + " error frames"});
  if (fd_refused_ > 0)
    notes.push_back({text(fd_refused_) + " CAN FD frames of the rig's messages were not taken: fd = true?"});
  for (const auto& [interface, bus] : buses_)
    for (const std::string& word : bus.sources->found()) notes.push_back({word});
  const std::vector<LogNote> of_clock = clock_.notes();
  notes.insert(notes.end(), of_clock.begin(), of_clock.end());
  return notes;
}

}  // namespace rigsound::log
