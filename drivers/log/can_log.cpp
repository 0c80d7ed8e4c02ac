#include "rigsound/log/can_log.hpp"

#include <algorithm>
#include <set>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr double kLongestGap = 3600;  // s

/// Interfaces of the log in the order of their names; reads no further than the first wanted one.
std::set<std::string> interfaces(const std::filesystem::path& file, const std::set<std::string>& wanted) {
  CandumpReader reader(file);
  CanRecord record;
  std::set<std::string> seen;
  while (reader.next(record)) {
    seen.insert(record.interface);
    if (wanted.count(record.interface) != 0) break;
  }
  if (seen.empty())
    throw InputError(file.string(), "holds no CAN frame, expected lines as candump -l writes them");
  return seen;
}

std::string list(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

}  // namespace

CanLog::CanLog(const std::filesystem::path& file, const std::vector<can::CanOptions>& buses)
    : file_(file.string()), reader_(file) {
  std::set<std::string> wanted;
  for (const can::CanOptions& bus : buses) wanted.insert(bus.interface);
  const std::set<std::string> seen = interfaces(file, wanted);
  const bool named =
      std::any_of(seen.begin(), seen.end(), [&](const std::string& name) { return wanted.count(name) != 0; });
  if (named) {
    for (const can::CanOptions& bus : buses) decoders_.emplace(bus.interface, bus.routes);
  } else if (buses.size() == 1 && seen.size() == 1) {
    decoders_.emplace(*seen.begin(), buses.front().routes);
  } else {
    throw InputError(file_, "has frames of " + list(seen) + " only, expected some of " + list(wanted));
  }
}

void CanLog::fetch() {
  if (pending_ || ended_) return;
  CanRecord record;
  if (!reader_.next(record)) {
    ended_ = true;
    return;
  }
  if (!first_ns_) first_ns_ = record.time_ns;
  const double at = static_cast<double>(record.time_ns - *first_ns_) * 1e-9;
  if (at - time_s_ > kLongestGap)
    throw InputError(file_, reader_.line(), {},
                     "the time jumps ahead by " + std::to_string(at - time_s_) +
                         " s, expected at most an hour between two frames");
  time_s_ = std::max(time_s_, at);
  pending_ = std::move(record);
}

std::optional<double> CanLog::next_s() {
  fetch();
  return pending_ ? std::optional<double>(time_s_) : std::nullopt;
}

bool CanLog::read_until(double until_s, SignalBoard& board) {
  std::vector<Reading> readings;
  for (fetch(); pending_ && time_s_ <= until_s; fetch()) {
    const auto decoder = decoders_.find(pending_->interface);
    if (decoder != decoders_.end() && decoder->second.decode(pending_->frame, time_s_, readings)) ++used_;
    pending_.reset();
  }
  for (const Reading& reading : readings) board.take(reading);
  return !readings.empty();
}

std::vector<LogNote> CanLog::notes() const {
  const CandumpCounts& counts = reader_.counts();
  const auto text = [](std::uint64_t n) { return std::to_string(n); };
  std::vector<LogNote> notes = {
      {text(counts.frames) + " frames in " + seconds_text(time_s_) + " s, " + text(used_) + " used"}};
  if (counts.other + counts.xl > 0)
    notes.push_back({"skipped " + text(counts.other) + " lines that are no frame and " + text(counts.xl) +
                     " CAN XL frames"});
  if (counts.error_frames > 0) notes.push_back({text(counts.error_frames) + " error frames"});
  if (counts.backwards > 0)
    notes.push_back({"time runs backwards here (and " + text(counts.backwards) +
                         " times in all); kept in the order of the file",
                     counts.first_backwards_line});
  return notes;
}

}  // namespace rigsound::log
