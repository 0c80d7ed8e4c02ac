#include "rig/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
bool units_go_together(const Unit& given, Signal target) {
  const auto wanted = unit_of_signal(target);
  return wanted && given.quantity == wanted->quantity;
}

std::string unit_doubt(const MappedSignal& s, const std::vector<MappedSignal>& all) {
  const auto given = unit_of(s.unit);
  if (!given) return {};
  const std::string both = s.name + " is in " + s.unit + ", " + shown(s.target.signal);
  if (!units_go_together(*given, s.target.signal)) {
    const auto other = std::find_if(all.begin(), all.end(), [&](const MappedSignal& o) {
      const auto its = unit_of(o.unit);
      return o.name != s.name && its && units_go_together(*given, o.target.signal) &&
             units_go_together(*its, s.target.signal);
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

/// What the rig makes of the range that the DBC gives; nothing when it gives none.
std::optional<std::pair<double, double>> range_of(const MappedSignal& s) {
  if (s.min == 0 && s.max == 0) return std::nullopt;
  const double a = s.min * s.scale + s.offset, b = s.max * s.scale + s.offset;
  return std::pair(std::min(a, b), std::max(a, b));
}

bool inside(const std::pair<double, double>& range, Signal target) {
  const SignalInfo& signal = info(target);
  const bool zero_may_be = signal.kind == SignalKind::kNumberOrZero && range.first == 0;
  return (range.first >= signal.min || zero_may_be) && range.second <= signal.max;
}

/// Another signal whose place this one would fill, and the other way round.
std::string swapped_by_range(const MappedSignal& s, const std::vector<MappedSignal>& all) {
  const auto own = range_of(s);
  for (const MappedSignal& other : all) {
    const auto its = range_of(other);
    const bool clamped = its && info(other.target.signal).kind == SignalKind::kClampedNumber;
    if (other.name != s.name && its && clamped && inside(*own, other.target.signal) &&
        inside(*its, s.target.signal))
      return std::string(info(other.target.signal).name);
  }
  return {};
}

std::string range_doubt(const MappedSignal& s, const std::vector<MappedSignal>& all) {
  const SignalInfo& signal = info(s.target.signal);
  const auto range = range_of(s);
  if (!range || inside(*range, s.target.signal)) return {};
  const auto [low, high] = *range;
  const std::string unit = signal.unit.empty() ? "" : " " + std::string(signal.unit);
  const std::string text = s.name + " goes from " + number_text(low) + " to " + number_text(high) + unit +
                           ", " + std::string(signal.name) + " from " + number_text(signal.min) + " to " +
                           number_text(signal.max) + unit;
  const std::string other = swapped_by_range(s, all);
  if (!other.empty()) return text + ": swapped with " + other + "?";
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
    if (doubt.empty()) doubt = range_doubt(signal, signals);
    if (!doubt.empty()) lines.push_back(signal.where + ": " + doubt);
  }
  return lines;
}

}  // namespace rigsound::config
