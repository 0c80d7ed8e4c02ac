#include "rigsound/log/bus_log.hpp"

#include <algorithm>

namespace rigsound::log {

std::string seconds_text(double seconds) {
  const auto tenths = static_cast<std::int64_t>(seconds * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

bool BusLog::take(const Reading& reading, SignalBoard& board) {
  const Validity validity = board.take(reading);
  if (validity == Validity::kValid) return true;
  const auto same = [&](const Refusal& r) {
    return r.id.signal == reading.id.signal && r.id.boom == reading.id.boom && r.why == validity;
  };
  auto known = std::find_if(refusals_.begin(), refusals_.end(), same);
  if (known == refusals_.end()) known = refusals_.insert(refusals_.end(), {reading.id, validity});
  ++known->count;
  known->last = reading.value;
  return false;
}

}  // namespace rigsound::log
