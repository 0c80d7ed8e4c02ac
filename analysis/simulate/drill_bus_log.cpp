#include "simulate/drill_bus_log.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "rigsound/log/candump.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::int64_t kEpoch_ns = 1733212800LL * 1000000000;   // the log's first frame
constexpr int kStep_ms = 10, kSpeedCycle = 2, kDrillCycle = 5;  // steps between two messages
constexpr std::int64_t kFrame_ns = 280000;                      // on the wire at 500 kbit/s
constexpr std::uint32_t kEec1 = 0x0CF00400, kDrill1 = 0x18FF1017;
constexpr std::uint8_t kNotAvailable = 0xFF;

using Bytes = std::array<std::uint8_t, 8>;

/// Two bytes, low byte first.
void put(Bytes& bytes, std::size_t at, double raw) {
  const auto word = static_cast<unsigned>(std::lround(raw));
  bytes[at] = static_cast<std::uint8_t>(word & 0xFF), bytes[at + 1] = static_cast<std::uint8_t>(word >> 8);
}

Bytes nothing_available() {
  Bytes bytes;
  bytes.fill(kNotAvailable);
  return bytes;
}

Bytes eec1(const DrillMoment& moment) {
  Bytes bytes = nothing_available();
  put(bytes, 3, moment.diesel_rpm / 0.125);
  return bytes;
}

Bytes drill1(const DrillMoment& moment) {
  Bytes bytes = nothing_available();
  put(bytes, 0, moment.feed_bar / 0.01);
  bytes[4] = static_cast<std::uint8_t>(0xF0 | (moment.hammering ? 1 : 0) << 2);  // not rattling
  bytes[5] = static_cast<std::uint8_t>(moment.rods);
  return bytes;
}

std::string line(std::int64_t time_ns, std::uint32_t id, const Bytes& bytes) {
  log::CanRecord record;
  record.time_ns = time_ns;
  record.interface = "can0";
  record.frame.id = id;
  record.frame.extended = true;
  record.frame.size = static_cast<std::uint8_t>(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) record.frame.data[i] = bytes[i];
  return log::candump_line(record) + "\n";
}

}  // namespace

std::string drill_bus_log(double seconds, const std::function<DrillMoment(double)>& moment) {
  std::string text;
  const int steps = static_cast<int>(seconds * 1000 / kStep_ms) + 1;
  for (int step = 0; step < steps; ++step) {
    const DrillMoment now = moment(step * kStep_ms / 1000.0);
    const std::int64_t at = kEpoch_ns + static_cast<std::int64_t>(step) * kStep_ms * 1000000;
    if (step % kSpeedCycle == 0) text += line(at, kEec1, eec1(now));
    if (step % kDrillCycle == 0) text += line(at + kFrame_ns, kDrill1, drill1(now));
  }
  return text;
}

}  // namespace rigsound::analysis
