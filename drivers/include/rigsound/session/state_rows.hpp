// The rows of a CSV `time_s,signal,value` of states that are no signals: what follows from the signals, and
// what a session was told beside them.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

#include "rigsound/machine/signal.hpp"

namespace rigsound::session {

constexpr std::string_view kSituationRow = "situation", kFeedDeviationRow = "feed_deviation",
                           kOutputGainRow = "output_gain", kManualRow = "manual";

/// The value of a signal that nothing says any more.
constexpr std::string_view kAbsent = "absent";

/// Whether a row [BOOM.]`name` is one of those, or a live control. Thread: any
inline bool is_side_row(std::string_view name) {
  const std::string_view rows[] = {kSituationRow, kFeedDeviationRow, kOutputGainRow, kManualRow};
  const auto& controls = control_table();
  return std::find(std::begin(rows), std::end(rows), name) != std::end(rows) ||
         std::any_of(controls.begin(), controls.end(),
                     [&](const ControlInfo& control) { return control.name == name; });
}

}  // namespace rigsound::session
