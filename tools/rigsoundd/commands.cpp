#include "commands.hpp"

#include <stdexcept>

#include "live_values.hpp"

namespace rigsound::daemon {
namespace {

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
  if (command == "metrics") return Json{{"ok", true}, {"text", to_openmetrics(daemon.scrape())}}.dump();
  if (command == "set") return set_value(request, daemon).dump();
  if (command == "release") return release_value(request, daemon).dump();
  if (command == "reload") return reload(daemon).dump();
  if (command == "mute") return mute(request, daemon).dump();
  throw Refused("\"" + command +
                "\": unknown command, expected status, metrics, set, release, reload or mute");
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
