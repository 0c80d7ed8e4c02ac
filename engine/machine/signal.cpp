#include "rigsound/machine/signal.hpp"

namespace rigsound {

const std::array<SignalInfo, kSignalCount>& signal_table() {
  static constexpr std::array<SignalInfo, kSignalCount> kTable = {{
      {"engine_rpm", "r/min", 0, 4000, 0, 0, false, false},
      {"feed_pressure_bar", "bar", 0, 300, 0, 0, true, false},
      {"rattling", "", 0, 2, 0, 0, true, true},
      {"percussion", "", 0, 1, 2, 0, true, true},
      {"percussion_rate_hz", "Hz", 5, 80, 0, 0, true, false},
      {"engine_load", "", 0, 1, -1, 0, false, false},
      {"rod_count", "", 1, 20, 1, 1, true, true},
      {"rock", "", 0, 65535, 0, 0, true, true},
      {"master_gain_db", "dB", -60, 0, 0, -60, false, false},
  }};
  return kTable;
}

const SignalInfo& info(Signal s) { return signal_table()[static_cast<std::size_t>(s)]; }

std::optional<Signal> signal_by_name(std::string_view name) {
  const auto& table = signal_table();
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table[i].name == name) return static_cast<Signal>(i);
  return std::nullopt;
}

std::string_view name(Validity v) {
  constexpr std::string_view kNames[] = {"never_seen",  "valid",         "stale",       "bus_down",
                                         "error_value", "not_available", "out_of_range"};
  return kNames[static_cast<std::size_t>(v)];
}

std::string_view value_word(Signal s, double value) {
  constexpr std::string_view kRattling[] = {"none", "closed", "open"};
  constexpr std::string_view kPercussion[] = {"off", "on"};
  const auto i = static_cast<std::size_t>(value);
  if (s == Signal::kRattling && i < 3) return kRattling[i];
  if (s == Signal::kPercussion && i < 2) return kPercussion[i];
  return {};
}

}  // namespace rigsound
