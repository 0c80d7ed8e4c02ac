#include "log/can_survey.hpp"

#include <algorithm>
#include <cstdio>

#include "rigsound/can/signal_reading.hpp"

namespace rigsound::log {
namespace {

std::string hex(std::uint32_t value, int digits) {
  char text[16];
  std::snprintf(text, sizeof text, "%0*X", digits, value);
  return text;
}

std::string identifier(bool extended, std::uint32_t id) { return hex(id, extended ? 8 : 3); }

std::string message_of(const can::SignalRoute& route) { return route.name.substr(0, route.name.find('.')); }

void keep_first(std::string& kept, const std::string& text) {
  if (kept.empty()) kept = text;
}

/// The PGN that a J1939 transport connection announces (J1939-21: RTS or BAM on PGN 60416); 0: none.
std::uint32_t announced_pgn(const can::Frame& f) {
  constexpr std::uint32_t kConnectionManagement = 60416;
  constexpr int kRts = 16, kBam = 32;
  if (!f.extended || f.size < 8 || can::pgn(f.id) != kConnectionManagement) return 0;
  if (f.data[0] != kRts && f.data[0] != kBam) return 0;
  return static_cast<std::uint32_t>(f.data[5] | f.data[6] << 8 | f.data[7] << 16);
}

}  // namespace

bool CanSurvey::add(const can::CanOptions& bus, const CanRecord& record) {
  const can::Frame& f = record.frame;
  ++frames_;
  if (f.remote || f.error) return false;
  ++ids_[{f.extended, f.id}];
  bool good = false;
  for (const can::SignalRoute& route : bus.routes) {
    if (can::matches(route.match, f)) {
      if (f.fd && !bus.fd) {
        ++fd_frames_;
        continue;
      }
      good = add_message(route, f) || good;
    } else {
      add_near(route, f);
    }
  }
  return good;
}

void CanSurvey::add_foreign(const CanRecord& record) {
  ++frames_;
  for (const can::CanOptions& bus : buses_)
    for (const can::SignalRoute& route : bus.routes)
      if (can::matches(route.match, record.frame))
        keep_first(foreign_, message_of(route) + " came on " + record.interface + ", the rig wants it on " +
                                 bus.interface + ": --can " + record.interface + "=" + bus.interface + "?");
}

bool CanSurvey::add_message(const can::SignalRoute& route, const can::Frame& frame) {
  const can::RawValues raw_values = route.match.j1939 ? can::RawValues::kJ1939 : can::RawValues::kAll;
  const auto decoded = can::read_signal(route.layout, raw_values, frame);
  if (!decoded) return false;
  const Validity validity = board_.take({route.target, decoded->value, decoded->validity, 0});
  if (validity == Validity::kValid) return true;
  const SignalInfo& signal = info(route.target.signal);
  if (validity == Validity::kOutOfRange)
    keep_first(refused_, route.name + " is " + number_text(decoded->value) + ", but " +
                             std::string(signal.name) + " goes from " + number_text(signal.min) + " to " +
                             number_text(signal.max) + ": another scale?");
  else
    keep_first(refused_, route.name + " has no value: " + std::string(name(validity)));
  return false;
}

void CanSurvey::add_near(const can::SignalRoute& route, const can::Frame& f) {
  const can::MessageMatch& match = route.match;
  const std::uint32_t group = can::pgn(match.id);
  const bool same_group = match.extended && f.extended && can::pgn(f.id) == group;
  if (same_group && match.j1939)
    keep_first(addressed_, message_of(route) + " (PGN " + std::to_string(group) + ") came from " +
                               hex(f.id & 0xFF, 2) + ", the rig says source = 0x" +
                               hex(match.source.value_or(0), 2));
  else if (same_group)
    keep_first(addressed_, "PGN " + std::to_string(group) + " came from " + hex(f.id & 0xFF, 2) +
                               ", the DBC says " + hex(match.id & 0xFF, 2) + ": j1939 = true?");
  if (f.id == match.id && f.extended != match.extended)
    keep_first(other_length_, message_of(route) + " is an identifier of " + (match.extended ? "29" : "11") +
                                  " bits, but came with " + (f.extended ? "29" : "11"));
  if (match.j1939 && announced_pgn(f) == group)
    keep_first(transported_, message_of(route) + " (PGN " + std::to_string(group) +
                                 ") comes by transport protocol (PGN 60416 and 60160), which is not read");
}

std::string CanSurvey::most_frequent() const {
  constexpr std::size_t kShown = 5;
  std::vector<std::pair<std::uint64_t, std::pair<bool, std::uint32_t>>> by_count;
  for (const auto& [id, count] : ids_) by_count.emplace_back(count, id);
  std::stable_sort(by_count.begin(), by_count.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, by_count.size()); ++i)
    text += (i > 0 ? ", " : "") + identifier(by_count[i].second.first, by_count[i].second.second);
  return by_count.size() > kShown ? text + " and " + std::to_string(by_count.size() - kShown) + " more"
                                  : text;
}

std::string CanSurvey::nearest() const {
  const std::string fd = fd_frames_ > 0 ? "the rig's messages came as CAN FD frames: fd = true?" : "";
  for (const std::string* known : {&refused_, &fd, &addressed_, &other_length_, &transported_, &foreign_})
    if (!known->empty()) return *known;
  std::string wanted;
  for (const can::CanOptions& bus : buses_)
    for (const can::SignalRoute& route : bus.routes) {
      const std::string text = message_of(route) + " = " + identifier(route.match.extended, route.match.id);
      if (wanted.find(text) == std::string::npos) wanted += (wanted.empty() ? "" : ", ") + text;
    }
  return "it holds " + (ids_.empty() ? "no data frame of the rig's interfaces" : most_frequent()) +
         ", the rig wants " + wanted;
}

}  // namespace rigsound::log
