#include "commands.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "live_values.hpp"
#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/fields.hpp"
#include "snapshot_json.hpp"

namespace rigsound::daemon {
namespace {

Json mute(const Json& request, DaemonControl& daemon) {
  const bool muted = request.value("on", !daemon.snapshot().muted);
  daemon.set_muted(muted);
  return {{"ok", true}, {"muted", muted}};
}

Json subscribe(const Json& request, std::optional<Subscription>& subscription) {
  subscription.emplace(request);
  return {{"ok", true}, {"every_s", subscription->every_s()}, {"topics", subscription->topics()}};
}

Json unsubscribe(std::optional<Subscription>& subscription) {
  const bool was = subscription.has_value();
  subscription.reset();
  return {{"ok", true}, {"was_subscribed", was}};
}

Json metrics(DaemonControl& daemon) { return {{"ok", true}, {"text", to_openmetrics(daemon.scrape())}}; }

Json reset_exposure(DaemonControl& daemon) {
  if (!daemon.snapshot().exposure)
    throw Refused("exposure: the output is not calibrated, expected [mix] db_spl_at_0dbfs in the rig");
  daemon.reset_exposure();
  return {{"ok", true}, {"exposure", status_json(daemon.snapshot())["exposure"]}};
}

constexpr std::array<std::string_view, 9> kCommands = {
    "status", "metrics", "set", "release", "mute", "exposure_reset", "reload", "subscribe", "unsubscribe"};

[[noreturn]] void refuse_command(const std::string& command) {
  const std::string_view near = config::nearest_word(command, kCommands);
  throw Refused(near.empty()
                    ? fmt::format("\"{}\": unknown command, expected {}", command, list_of(kCommands))
                    : fmt::format("\"{}\": unknown command, did you mean {}?", command, near));
}

/// Null: later.
Json answer_json(const Json& request, DaemonControl& daemon, ClientState& client) {
  const std::string command = request.value("command", "");
  if (command == "status") return status_json(daemon.snapshot());
  if (command == "metrics") return metrics(daemon);
  if (command == "set") return set_value(request, daemon);
  if (command == "release") return release_value(request, daemon);
  if (command == "reload") return client.reload = daemon.ask_reload(), nullptr;
  if (command == "mute") return mute(request, daemon);
  if (command == "exposure_reset") return reset_exposure(daemon);
  if (command == "subscribe") return subscribe(request, client.subscription);
  if (command == "unsubscribe") return unsubscribe(client.subscription);
  refuse_command(command);
}

std::string line_of(const Json& answer) { return config::json_line(answer) + "\n"; }

std::string refusal_line(const std::string& error) { return line_of({{"ok", false}, {"error", error}}); }

}  // namespace

std::string answer(const std::string& request, DaemonControl& daemon, ClientState& client) {
  try {
    const Json json = answer_json(config::parsed_json(request), daemon, client);
    return json.is_null() ? "" : line_of(json);
  } catch (const Json::exception&) {
    return refusal_line("expected one JSON object a line, like {\"command\": \"status\"}");
  } catch (const std::exception& refused) {
    return refusal_line(refused.what());
  }
}

std::string late_answer(const DaemonControl& daemon, ClientState& client) {
  const ReloadResult* const result = client.reload ? daemon.reload_result(*client.reload) : nullptr;
  if (result == nullptr) return {};
  client.reload.reset();
  if (!result->error.empty()) return refusal_line(result->error);
  return line_of({{"ok", true}, {"not_applied", result->not_applied}});
}

}  // namespace rigsound::daemon
