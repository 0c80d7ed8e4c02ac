#include <cmath>
#include <nlohmann/json.hpp>

#include "rigsound/machine/signal.hpp"
#include "snapshot.hpp"

namespace rigsound::daemon {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEventNames[audio::kCardEventCount] = {"xruns",        "suspends",      "bad_states",
                                                             "short_writes", "interruptions", "losses"};

double decibels(double linear) { return linear > 1e-10 ? 20 * std::log10(linear) : -200; }

Json audio_json(const Snapshot& s) {
  Json json = {{"playing", s.card.playing},
               {"card", s.card.description},
               {"scheduling", s.scheduling},
               {"blocks", s.blocks},
               {"block_ms", s.block_s * 1e3},
               {"block_mean_us", s.block_mean_s * 1e6},
               {"block_worst_us", s.block_worst_s * 1e6},
               {"load", s.block_s > 0 ? s.block_mean_s / s.block_s : 0},
               {"deadline_misses", s.deadline_misses}};
  for (std::size_t i = 0; i < s.card.events.size(); ++i) json[kEventNames[i]] = s.card.events[i];
  return json;
}

Json signals_json(const Snapshot& s) {
  Json json = Json::array();
  for (const SignalSnapshot& signal : s.signals) {
    Json entry = {
        {"name", signal.name}, {"value", signal.value}, {"unit", signal.unit}, {"validity", signal.validity}};
    entry["age_s"] = signal.age_s < 0 ? Json(nullptr) : Json(signal.age_s);
    json.push_back(entry);
  }
  return json;
}

Json buses_json(const Snapshot& s) {
  Json json = Json::array();
  for (const BusSnapshot& bus : s.buses) {
    Json entry = {{"name", bus.name}, {"up", bus.up}, {"problem", bus.problem}};
    for (const auto& [name, count] : bus.counters) entry[std::string(name)] = count;
    json.push_back(entry);
  }
  return json;
}

Json booms_json(const Snapshot& s) {
  Json json = Json::array();
  for (const BoomSnapshot& boom : s.booms) {
    Json entry = {{"name", boom.name}};
    for (const ControlInfo& control : control_table())
      entry[std::string(control.name)] = boom.controls.*control.field;
    json.push_back(entry);
  }
  return json;
}

}  // namespace

std::string to_json(const Snapshot& s) {
  const Json json = {{"ok", true},
                     {"version", s.version},
                     {"rig", s.rig},
                     {"uptime_s", s.uptime_s},
                     {"audio", audio_json(s)},
                     {"meters",
                      {{"peak_db", decibels(s.peak)},
                       {"rms_db", decibels(s.rms)},
                       {"limiter_db", decibels(s.limiter_gain)},
                       {"output_gain", s.output_gain},
                       {"lost_clicks", s.lost_clicks}}},
                     {"muted", s.muted},
                     {"signals", signals_json(s)},
                     {"buses", buses_json(s)},
                     {"booms", booms_json(s)},
                     {"session",
                      {{"file", s.session.file},
                       {"recording", s.session.recording},
                       {"bytes", s.session.bytes},
                       {"problem", s.session.problem},
                       {"lost_records", s.lost_records}}},
                     {"reloads", s.reloads},
                     {"failed_reloads", s.failed_reloads},
                     {"lost_log_entries", s.lost_log_entries}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rigsound::daemon
