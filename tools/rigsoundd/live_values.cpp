#include "live_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/fields.hpp"

namespace rigsound::daemon {
namespace {

/// One signal or one control, of the booms from `first` to before `last`.
struct Target {
  std::optional<Signal> signal;
  const ControlInfo* control = nullptr;
  int first = 0, last = 1;

  std::string_view name() const { return signal ? info(*signal).name : control->name; }
  std::string_view unit() const { return signal ? info(*signal).unit : control->unit; }
  Range range() const { return signal ? info(*signal).range() : control->range(); }
  bool per_boom() const { return !signal || info(*signal).per_boom; }
};

std::string or_nearest(const std::string& given, const std::vector<std::string>& known,
                       const std::string& rest) {
  const std::string_view near = config::nearest_word(given, known);
  return near.empty() ? rest : fmt::format("did you mean {}?", near);
}

Target named(const std::string& name) {
  Target target;
  if ((target.signal = signal_by_name(name))) return target;
  std::vector<std::string> known;
  for (const SignalInfo& signal : signal_table()) known.emplace_back(signal.name);
  for (const ControlInfo& control : control_table()) {
    if (control.name == name) target.control = &control;
    known.emplace_back(control.name);
  }
  if (target.control != nullptr) return target;
  throw Refused(
      fmt::format("{}: is no signal and no control, {}", name,
                  or_nearest(name, known, fmt::format("expected [BOOM.] and one of {}", list_of(known)))));
}

int boom_named(const std::string& name, const std::vector<std::string>& booms) {
  if (const auto found = std::find(booms.begin(), booms.end(), name); found != booms.end())
    return static_cast<int>(found - booms.begin());
  throw Refused(fmt::format("{}: is no boom of the rig, {}", name,
                            or_nearest(name, booms, fmt::format("expected {}", list_of(booms)))));
}

Target target_of(const std::string& key, const std::vector<std::string>& booms) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) {
    Target target = named(key);
    if (target.per_boom()) target.last = static_cast<int>(booms.size());
    return target;
  }
  const int boom = boom_named(key.substr(0, dot), booms);
  Target target = named(key.substr(dot + 1));
  if (!target.per_boom())
    throw Refused(
        fmt::format("{}: is a signal of the whole rig, expected {} without a boom", key, target.name()));
  target.first = boom;
  target.last = boom + 1;
  return target;
}

/// The words a signal's value may be written with; none: only numbers.
std::vector<std::string> words_of(const Target& target, const DaemonControl& daemon) {
  if (!target.signal) return {};
  if (*target.signal == Signal::kRock) return daemon.rock_names();
  std::vector<std::string> words;
  for (double value = 0; !value_word(*target.signal, value).empty(); ++value)
    words.emplace_back(value_word(*target.signal, value));
  return words;
}

double value_of(const Json& given, const Target& target, const DaemonControl& daemon) {
  const std::vector<std::string> words = words_of(target, daemon);
  const std::string range = target.range().text();
  if (given.is_number()) {
    const double value = given.get<double>();
    if (target.range().holds(value)) return value;
    throw Refused(fmt::format("{}: {}", target.name(), target.range().problem(value)));
  }
  if (!given.is_string()) throw Refused(fmt::format("{}: has no value, expected {}", target.name(), range));
  const std::string word = given.get<std::string>();
  if (const auto found = std::find(words.begin(), words.end(), word); found != words.end())
    return static_cast<double>(found - words.begin());
  const std::string expected = words.empty() ? fmt::format("expected a number, {}", range)
                                             : fmt::format("expected {}, or {}", list_of(words), range);
  throw Refused(fmt::format("{}: is {}, {}", target.name(), word, or_nearest(word, words, expected)));
}

/// Calls `each(index, label)` for every boom of the target.
template <class Each>
void for_each_boom(const Target& target, const std::vector<std::string>& booms, Each each) {
  for (int b = target.first; b < target.last; ++b)
    each(b, target.per_boom() ? fmt::format("{}.{}", booms[b], target.name()) : std::string(target.name()));
}

/// Whether there was something to release.
bool release_one(const Target& target, int boom, DaemonControl& daemon) {
  if (target.signal) {
    const SignalId id{*target.signal, static_cast<std::uint8_t>(boom)};
    if (!daemon.holds(id)) return false;
    daemon.release(id);
    return true;
  }
  const auto neutral = static_cast<float>(target.control->neutral);
  if (daemon.controls(boom).*target.control->field == neutral) return false;
  daemon.set_control(boom, *target.control, target.control->neutral);
  return true;
}

std::vector<Target> targets_of(const std::string& key, const std::vector<std::string>& booms) {
  if (key != "all") return {target_of(key, booms)};
  std::vector<Target> all;
  for (const SignalInfo& signal : signal_table()) all.push_back(target_of(std::string(signal.name), booms));
  for (const ControlInfo& control : control_table())
    all.push_back(target_of(std::string(control.name), booms));
  return all;
}

}  // namespace

Json set_value(const Json& request, DaemonControl& daemon) {
  const std::vector<std::string> booms = daemon.boom_names();
  const Target target = target_of(request.value("key", ""), booms);
  const double value = value_of(request.value("value", Json()), target, daemon);
  Json set = Json::array();
  for_each_boom(target, booms, [&](int boom, const std::string& label) {
    if (target.signal)
      daemon.hold({*target.signal, static_cast<std::uint8_t>(boom)}, value);
    else
      daemon.set_control(boom, *target.control, value);
    set.push_back(
        {{"name", label}, {"value", value}, {"unit", target.unit()}, {"manual", target.signal.has_value()}});
  });
  return {{"ok", true}, {"set", set}};
}

Json release_value(const Json& request, DaemonControl& daemon) {
  const std::vector<std::string> booms = daemon.boom_names();
  Json released = Json::array();
  for (const Target& target : targets_of(request.value("key", ""), booms))
    for_each_boom(target, booms, [&](int boom, const std::string& label) {
      if (release_one(target, boom, daemon)) released.push_back(label);
    });
  return {{"ok", true}, {"released", released}};
}

}  // namespace rigsound::daemon
