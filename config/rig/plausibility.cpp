#include "rig/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rig/units.hpp"

namespace rigsound::config {
namespace {

constexpr double kSameScale = 0.01;  // relative: nobody writes 0.0689475729

/// Nothing for a signal that has no unit: a count, a word.
std::optional<Unit> unit_of_signal(Signal s) {
  const SignalInfo& signal = info(s);
  if (signal.stepped()) return std::nullopt;
  return signal.unit.empty() ? Unit{Quantity::kRatio, 1} : unit_of(signal.unit);
}

std::string shown(Signal s) {
  const SignalInfo& signal = info(s);
  if (signal.stepped()) return std::string(signal.name) + " a whole number";
  return std::string(signal.name) + " in " + (signal.unit.empty() ? "shares of 1" : std::string(signal.unit));
}

/// Whether a signal of the bus may be what the machine's signal is, as far as units tell.
bool units_go_together(const std::string& unit, Signal target) {
  const auto given = unit_of(unit);
  const auto wanted = unit_of_signal(target);
  if (!given) return true;
  return wanted && given->quantity == wanted->quantity;
}

std::string unit_doubt(const MappedSignal& s, const std::vector<MappedSignal>& all) {
  const auto given = unit_of(s.unit);
  if (!given) return {};
  const std::string both = s.name + " is in " + s.unit + ", " + shown(s.target.signal);
  if (!units_go_together(s.unit, s.target.signal)) {
    const auto other = std::find_if(all.begin(), all.end(), [&](const MappedSignal& o) {
      return o.name != s.name && unit_of(o.unit) && units_go_together(s.unit, o.target.signal) &&
             units_go_together(o.unit, s.target.signal);
    });
    return both + ": " +
           (other == all.end() ? "another signal?"
                               : "swapped with " + std::string(info(other->target.signal).name) + "?");
  }
  const double meant = given->factor / unit_of_signal(s.target.signal)->factor;
  if (std::fabs(s.scale / meant - 1) <= kSameScale) return {};
  const std::string now = s.scale == 1 ? "" : ", the rig's scale is " + number_text(s.scale);
  return both + now + ": scale = " + number_text(meant) + "?";
}

std::string range_doubt(const MappedSignal& s) {
  const SignalInfo& signal = info(s.target.signal);
  if (s.min == 0 && s.max == 0) return {};
  const double ends[] = {s.min * s.scale + s.offset, s.max * s.scale + s.offset};
  const double low = std::min(ends[0], ends[1]), high = std::max(ends[0], ends[1]);
  const bool zero_may_be = signal.kind == SignalKind::kNumberOrZero && low == 0;
  if ((low >= signal.min || zero_may_be) && high <= signal.max) return {};
  const std::string unit = signal.unit.empty() ? "" : " " + std::string(signal.unit);
  std::string text = s.name + " goes from " + number_text(low) + " to " + number_text(high) + unit + ", " +
                     std::string(signal.name) + " from " + number_text(signal.min) + " to " +
                     number_text(signal.max) + unit;
  const bool share_in_percent = signal.max == 1 && !signal.stepped() && low == 0 && high == 100;
  if (share_in_percent) return text + ": scale = " + number_text(s.scale / 100) + "?";
  return text + (signal.kind == SignalKind::kClampedNumber && low >= signal.min
                     ? ": what is above counts as " + number_text(signal.max)
                     : ": what is outside is refused");
}

}  // namespace

double scale_of_unit(Signal target, const std::string& unit) {
  const auto given = unit_of(unit);
  const auto wanted = unit_of_signal(target);
  const bool share =
      given && wanted && given->quantity == Quantity::kRatio && wanted->quantity == Quantity::kRatio;
  return share ? given->factor / wanted->factor : 1;
}

std::vector<std::string> doubts(const std::vector<MappedSignal>& signals) {
  std::vector<std::string> lines;
  for (const MappedSignal& signal : signals) {
    std::string doubt = unit_doubt(signal, signals);
    if (doubt.empty()) doubt = range_doubt(signal);
    if (!doubt.empty()) lines.push_back(signal.where + ": " + doubt);
  }
  return lines;
}

}  // namespace rigsound::config
