// The machine signals by name, unit and range, as buses deliver them one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rigsound {

enum class Signal : std::uint8_t {
  kEngineRpm,
  kFeedPressureBar,
  kRattling,
  kPercussion,
  kPercussionRateHz,
  kEngineLoad,
  kRodCount,
  kRock,
  kMasterGainDb,
};
constexpr int kSignalCount = 9;

struct SignalInfo {
  std::string_view name;  ///< key in rig files and in the CSV of `rigsound decode`
  std::string_view unit;
  double min, max;  ///< a value outside is refused
  double absent;    ///< the value that stands when the signal was never seen
  double idle;      ///< the value that means quiet (safety rule `idle`)
  bool per_boom;    ///< drilling signals exist once per boom, engine signals once per rig
  bool stepped;     ///< takes whole values only, never fades
};

/// Shape: one entry per Signal, in its order. Thread: any.
const std::array<SignalInfo, kSignalCount>& signal_table();
const SignalInfo& info(Signal s);
std::optional<Signal> signal_by_name(std::string_view name);

/// Which signal of which boom; boom is 0 for signals of the whole rig.
struct SignalId {
  Signal signal;
  std::uint8_t boom = 0;
};

/// Why a signal may not be believed.
enum class Validity : std::uint8_t {
  kNeverSeen,
  kValid,
  kStale,
  kBusDown,
  kErrorValue,
  kNotAvailable,
  kOutOfRange
};
std::string_view name(Validity v);

/// The word for a value of a stepped signal ("closed", "on"), or empty when the value is a plain number.
std::string_view value_word(Signal s, double value);

}  // namespace rigsound
