#include "commands.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "rigsound/machine/signal.hpp"

namespace rigsound::daemon {
namespace {

using Json = nlohmann::ordered_json;

struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const ControlInfo& control_named(const std::string& name) {
  std::string known;
  for (const ControlInfo& control : control_table()) {
    if (control.name == name) return control;
    known.append(known.empty() ? "" : ", ").append(control.name);
  }
  throw Refused(name + ": unknown control, expected [BOOM.] and one of " + known);
}

/// Boom index of `BOOM.CONTROL`, whose `key` is cut to CONTROL; without a boom all are meant: -1.
int take_boom(std::string& key, const std::vector<std::string>& booms) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) return -1;
  const std::string name = key.substr(0, dot);
  key.erase(0, dot + 1);
  for (std::size_t b = 0; b < booms.size(); ++b)
    if (booms[b] == name) return static_cast<int>(b);
  throw Refused(name +
                fmt::format(": the rig has no boom of that name, expected {}", fmt::join(booms, ", ")));
}

Json set(const Json& request, DaemonControl& daemon) {
  std::string key = request.value("key", "");
  if (!request.contains("value") || !request["value"].is_number())
    throw Refused(key + ": expected a number as value");
  const double value = request["value"].get<double>();
  const std::vector<std::string> booms = daemon.boom_names();
  const int boom = take_boom(key, booms);
  const ControlInfo& control = control_named(key);
  if (!control.takes(value))
    throw Refused(fmt::format("{}: {} is out of range, expected {}...{} {}{}", key, value, control.min,
                              control.max, control.unit,
                              control.kind == SignalKind::kNumberOrZero ? " or 0" : ""));
  for (int b = 0; b < static_cast<int>(booms.size()); ++b) {
    if (boom >= 0 && b != boom) continue;
    DrillControls controls = daemon.controls(b);
    controls.*control.field = static_cast<float>(value);
    daemon.set_controls(b, controls);
  }
  return {{"ok", true}};
}

Json reload(DaemonControl& daemon) {
  const ReloadResult result = daemon.reload();
  if (!result.error.empty()) throw Refused(result.error);
  return {{"ok", true}, {"not_applied", result.not_applied}};
}

Json mute(const Json& request, DaemonControl& daemon) {
  const bool muted = request.value("on", !daemon.snapshot().muted);
  daemon.set_muted(muted);
  return {{"ok", true}, {"muted", muted}};
}

std::string answer_json(const Json& request, DaemonControl& daemon) {
  const std::string command = request.value("command", "");
  if (command == "status") return to_json(daemon.snapshot());
  if (command == "metrics") return Json{{"ok", true}, {"text", to_openmetrics(daemon.snapshot())}}.dump();
  if (command == "set") return set(request, daemon).dump();
  if (command == "reload") return reload(daemon).dump();
  if (command == "mute") return mute(request, daemon).dump();
  throw Refused("\"" + command + "\": unknown command, expected status, metrics, set, reload or mute");
}

}  // namespace

std::string answer(const std::string& request, DaemonControl& daemon) {
  std::string error;
  try {
    return answer_json(Json::parse(request), daemon) + "\n";
  } catch (const nlohmann::json::exception&) {
    error = "expected one JSON object a line, like {\"command\": \"status\"}";
  } catch (const std::exception& refused) {
    error = refused.what();
  }
  return Json{{"ok", false}, {"error", error}}.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rigsound::daemon
