#include "snapshot_json.hpp"

#include <cmath>

#include "rigsound/machine/signal.hpp"

namespace rigsound::daemon {
namespace {

constexpr const char* kEventNames[audio::kCardEventCount] = {"xruns",        "suspends",      "bad_states",
                                                             "short_writes", "interruptions", "losses"};

double decibels(double linear) { return linear > 1e-10 ? 20 * std::log10(linear) : -200; }

Json level_json(const LevelSnapshot& level) {
  return {{"peak_db", decibels(level.peak)}, {"rms_db", decibels(level.rms)}};
}

Json audio_json(const Snapshot& s) {
  Json json = {{"playing", s.card.playing},
               {"card", s.card.description},
               {"scheduling", s.scheduling},
               {"blocks", s.blocks},
               {"block_ms", s.block_s * 1e3},
               {"block_mean_us", s.block_mean_s * 1e6},
               {"block_worst_us", s.block_worst_s * 1e6},
               {"load", s.block_s > 0 ? s.block_mean_s / s.block_s : 0},
               {"deadline_misses", s.deadline_misses},
               {"clock_jumps", s.clock_jumps},
               {"skipped_blocks", s.skipped_blocks}};
  for (std::size_t i = 0; i < s.card.events.size(); ++i) json[kEventNames[i]] = s.card.events[i];
  return json;
}

Json signals_json(const Snapshot& s) {
  Json json = Json::array();
  for (const SignalSnapshot& signal : s.signals) {
    Json entry = {
        {"name", signal.name}, {"value", signal.value}, {"unit", signal.unit}, {"validity", signal.validity}};
    entry["age_s"] = signal.age_s < 0 ? Json(nullptr) : Json(signal.age_s);
    entry["word"] = signal.word;
    entry["refused"] = signal.refused;
    entry["last_refused"] = signal.last_refused ? Json(*signal.last_refused) : Json(nullptr);
    entry["clamped"] = signal.clamped;
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

Json banks_json(const BoomSnapshot& boom) {
  Json json = Json::array();
  for (const BankSnapshot& bank : boom.banks)
    json.push_back({{"name", bank.name}, {"share", bank.share}, {"rods", bank.rods}, {"rock", bank.rock}});
  return json;
}

Json boom_json(const BoomSnapshot& boom) {
  Json json = {{"name", boom.name},
               {"situation", std::string(name(boom.situation))},
               {"hammering", boom.hammering},
               {"feed_deviation", boom.feed_deviation},
               {"banks", banks_json(boom)},
               {"rods", boom.rods},
               {"rock", boom.rock},
               {"impacts_wanted_hz", boom.impacts_wanted_hz},
               {"impacts_made_hz", boom.impacts_made_hz}};
  json["levels"]["drill"] = level_json(boom.drill_level);
  if (!boom.tool.empty()) json["levels"][boom.tool] = level_json(boom.tool_level);
  for (const ControlInfo& control : control_table())
    json[std::string(control.name)] = boom.controls.*control.field;
  return json;
}

Json booms_json(const Snapshot& s) {
  Json json = Json::array();
  for (const BoomSnapshot& boom : s.booms) json.push_back(boom_json(boom));
  return json;
}

Json meters_json(const Snapshot& s) {
  Json json = level_json(s.output);
  json["limiter_db"] = decibels(s.limiter_gain);
  json["output_gain"] = s.output_gain;
  json["lost_clicks"] = s.lost_clicks;
  json["dropped_chunks"] = s.dropped_chunks;
  json["diesel"] = level_json(s.diesel);
  return json;
}

Json exposure_json(const Snapshot& s) {
  if (!s.exposure) return nullptr;
  const ExposureSnapshot& e = *s.exposure;
  return {{"laf_db", e.fast_db},
          {"las_db", e.slow_db},
          {"laeq_1min_db", e.minute_db},
          {"lex_8h_db", e.day_db},
          {"lc_peak_db", e.peak_db},
          {"since_s", e.since_s},
          {"turned_down_db", e.turned_down_db}};
}

}  // namespace

Json status_json(const Snapshot& s) {
  return Json{{"ok", true},
              {"version", s.version},
              {"rig", s.rig},
              {"uptime_s", s.uptime_s},
              {"audio", audio_json(s)},
              {"meters", meters_json(s)},
              {"exposure", exposure_json(s)},
              {"muted", s.muted},
              {"paused", s.paused},
              {"no_buses", s.no_buses},
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
}

}  // namespace rigsound::daemon
